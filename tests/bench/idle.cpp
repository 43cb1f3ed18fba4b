#include "idle.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <thread>

#include "program.h"

namespace viewing::bench {
namespace {

using namespace std::chrono_literals;

/// A child process that the destructor terminates.
class Running {
public:
    explicit Running(const Command& command) : started_(start(command)) {}
    ~Running() {
        kill(started_.process, SIGTERM);
        waitpid(started_.process, nullptr, 0);
        close(started_.output);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    /// Returns the user and system time spent so far.
    double cpu_ms() const {
        clockid_t clock{};
        timespec spent{};
        if (clock_getcpuclockid(started_.process, &clock) != 0 || clock_gettime(clock, &spent) != 0) return 0.0;
        return static_cast<double>(spent.tv_sec) * 1e3 + static_cast<double>(spent.tv_nsec) * 1e-6;
    }
    /// Returns the first line that the process prints, without its newline; empty if none arrives in time.
    std::string line(int timeout_ms) const {
        std::string text;
        pollfd ready{started_.output, POLLIN, 0};
        for (char byte = 0; poll(&ready, 1, timeout_ms) == 1 && read(started_.output, &byte, 1) == 1 && byte != '\n';)
            text += byte;
        return text;
    }

    bool has_ended() const {
        siginfo_t info{};
        return waitid(P_PID, static_cast<id_t>(started_.process), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
               info.si_pid != 0;
    }

private:
    Started started_;
};

}  // namespace

std::optional<double> idle_percent(const std::string& sandbox) {
    if (std::system("command -v Xvfb > /dev/null") != 0) return std::nullopt;
    const Running display({"Xvfb", "-displayfd", "1", "-screen", "0", "1600x900x24", "-nolisten", "tcp"});
    const std::string number = display.line(10'000);
    if (number.empty()) return std::nullopt;
    setenv("DISPLAY", (":" + number).c_str(), 1);
    const Running window({sandbox});
    std::this_thread::sleep_for(4s);
    const double begin_ms = window.cpu_ms();
    std::this_thread::sleep_for(5s);
    const double spent_ms = window.cpu_ms() - begin_ms;
    if (window.has_ended()) return std::nullopt;  // the window failed to start
    return spent_ms / 5000.0 * 100.0;
}

}  // namespace viewing::bench
