// Implements --timeout: when time is up, ends the process wherever it hangs, or lets it write its partial results.
#pragma once

#include <string>

namespace viewing {

/// A time limit, active from construction until lift() or destruction. After `seconds`, prints one sentence on stderr
/// and exits with status 8. If `grace_s` is above 0, has_run_out() becomes true instead, and the process ends `grace_s`
/// seconds later. A process can have only one limit at a time. Uses SIGALRM, which needs no thread and works even
/// inside a driver.
class TimeLimit {
public:
    explicit TimeLimit(double seconds, unsigned grace_s = 0);
    ~TimeLimit() { lift(); }
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

    /// Lifts the current limit, if any.
    static void lift();

    static bool has_run_out();

    /// Return the message that the latest limit has expired, and that limit's length in seconds; "" and 0 if there was
    /// no limit.
    static std::string sentence();
    static double seconds();
};

}  // namespace viewing
