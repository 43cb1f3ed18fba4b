#include "cli/signals.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <string_view>

#include "cli/exit_status.h"
#include "platform/ending_signals.h"
#include "platform/file.h"
#include "platform/last_words.h"
#include "platform/sanitized.h"

namespace viewing {
namespace {

void end_at_fault(int) {
    constexpr int status = static_cast<int>(ExitStatus::internal_error);
    for (const std::string_view part : {std::string_view(fault_sentence), std::string_view("\n")})
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, part.data(), part.size());
    say_last_words(status);
    remove_unfinished_files();
    ::_exit(status);
}

void catch_faults() {
    // Use a separate stack, since a stack overflow is a fault, too.
    static std::array<char, 64U << 10U> stack_bytes;
    stack_t stack{};
    stack.ss_sp = stack_bytes.data();
    stack.ss_size = stack_bytes.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = end_at_fault;
    action.sa_flags = SA_ONSTACK;
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigaction(fault, &action, nullptr);
}

}  // namespace

void end_cleanly_by_signals() {
    clean_up_at_ending_signals();
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGXFSZ, &ignore, nullptr);
    if (!is_sanitized) catch_faults();
}

}  // namespace viewing
