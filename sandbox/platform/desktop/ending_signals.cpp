#include "platform/ending_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

#include "platform/file.h"

namespace viewing {
namespace {

constexpr std::array signals_to_note{SIGINT, SIGTERM, SIGHUP, SIGALRM};

volatile sig_atomic_t noted_signal = 0;
std::array<int, 2> wake_ends{-1, -1};
std::array<struct sigaction, signals_to_note.size()> handlers_before{};

void handle(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    ::sigaction(signal, &action, nullptr);
}

bool is_ignored(int signal) {
    struct sigaction now {};
    return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

void end_process(int signal) {
    remove_unfinished_files();
    handle(signal, SIG_DFL);
    sigset_t own;
    ::sigemptyset(&own);
    ::sigaddset(&own, signal);
    ::sigprocmask(SIG_UNBLOCK, &own, nullptr);
    ::raise(signal);
    ::_exit(EXIT_FAILURE);
}

void note(int signal) {
    if (noted_signal != 0) end_process(signal);
    noted_signal = signal;
    [[maybe_unused]] const ssize_t written = ::write(wake_ends[1], "!", 1);
}

}  // namespace

void clean_up_at_ending_signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE})
        if (!is_ignored(signal)) handle(signal, end_process);
}

EndingNote::EndingNote() {
    noted_signal = 0;
    if (::pipe2(wake_ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) wake_ends = {-1, -1};
    for (std::size_t i = 0; i < signals_to_note.size(); ++i) {
        ::sigaction(signals_to_note[i], nullptr, &handlers_before[i]);
        if (!is_ignored(signals_to_note[i])) handle(signals_to_note[i], note);
    }
}

EndingNote::~EndingNote() {
    for (std::size_t i = 0; i < signals_to_note.size(); ++i)
        ::sigaction(signals_to_note[i], &handlers_before[i], nullptr);
    for (int& end : wake_ends) {
        if (end >= 0) ::close(end);
        end = -1;
    }
}

int EndingNote::signal() {
    return noted_signal;
}

int EndingNote::file() {
    return wake_ends[0];
}

const char* name_of_ending_signal(int signal) {
    return signal == SIGINT    ? "SIGINT (Ctrl+C)"
           : signal == SIGTERM ? "SIGTERM (kill)"
           : signal == SIGHUP  ? "SIGHUP (the terminal was closed)"
                               : "--timeout";
}

bool is_timeout(int signal) {
    return signal == SIGALRM;
}

void end_by_signal(int signal) {
    end_process(signal);
    std::abort();  // not reached
}

void leave_terminal_to_parent() {
    for (const int signal : {SIGINT, SIGHUP}) handle(signal, SIG_IGN);
}

}  // namespace viewing
