#include "cli/time_limit.h"

#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <string>
#include <string_view>

#include "cli/exit_status.h"
#include "platform/file.h"
#include "platform/last_words.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

std::string last_line;  // prepared in advance, because a signal handler must not allocate
double limit_s = 0.0;
volatile std::sig_atomic_t run_out = 0;
volatile std::sig_atomic_t grace_left_s = 0;

void end_at_time_limit(int) {
    run_out = 1;
    if (grace_left_s > 0) {
        ::alarm(static_cast<unsigned>(grace_left_s));
        grace_left_s = 0;
        return;
    }
    constexpr int status = static_cast<int>(ExitStatus::out_of_time);
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, last_line.data(), last_line.size());
    say_last_words(status);
    remove_unfinished_files();
    ::_exit(status);
}

void set_timer(double seconds) {
    const double whole = std::floor(seconds);
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(whole);
    timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - whole) * 1e6);
    ::setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace

TimeLimit::TimeLimit(double seconds, unsigned grace_s) {
    limit_s = seconds;
    run_out = 0;
    grace_left_s = static_cast<int>(grace_s);
    last_line = "out of time: not finished within the " + format_number(seconds) + " s of --timeout\n";
    struct sigaction action {};
    action.sa_handler = end_at_time_limit;
    action.sa_flags = SA_RESTART;  // reads and writes continue during the grace period
    ::sigaction(SIGALRM, &action, nullptr);
    sigset_t alarm;
    ::sigemptyset(&alarm);
    ::sigaddset(&alarm, SIGALRM);
    ::sigprocmask(SIG_UNBLOCK, &alarm, nullptr);
    set_timer(seconds);
}

void TimeLimit::lift() {
    set_timer(0.0);
}

bool TimeLimit::has_run_out() {
    return run_out != 0;
}

std::string TimeLimit::sentence() {
    return last_line.substr(0, last_line.find('\n'));
}

double TimeLimit::seconds() {
    return limit_s;
}

}  // namespace viewing
