#include "cli/time_limit.h"

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <string>
#include <string_view>

#include "cli/exit_status.h"
#include "platform/file.h"
#include "platform/last_words.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

std::string line;  // made beforehand: a signal handler may not allocate
double limit_s = 0.0;

void end_process(int) {
    constexpr int status = static_cast<int>(ExitStatus::out_of_time);
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
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

TimeLimit::TimeLimit(double seconds) {
    limit_s = seconds;
    line = "out of time: not done within the " + format_number(seconds) + " s of --timeout\n";
    struct sigaction action {};
    action.sa_handler = end_process;
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

std::string TimeLimit::sentence() {
    return line.substr(0, line.find('\n'));
}

double TimeLimit::seconds() {
    return limit_s;
}

}  // namespace viewing
