// --timeout: ends the process when its time has run out, wherever it hangs, or has it write what is done.
#pragma once

#include <string>

namespace viewing {

/// From construction until lift() or the end of the object: when `seconds` are over, one sentence on stderr and exit
/// status 8. With `grace_s` above 0 has_run_out() is true from then on, and the process ends so many seconds later. One
/// at a time per process; uses SIGALRM, so that it needs no thread and works inside a driver.
class TimeLimit {
public:
    explicit TimeLimit(double seconds, unsigned grace_s = 0);
    ~TimeLimit() { lift(); }
    TimeLimit(const TimeLimit&) = delete;
    TimeLimit& operator=(const TimeLimit&) = delete;

    /// The one that there is, if any.
    static void lift();

    static bool has_run_out();

    /// What is said when it is over, and after how long; "" and 0 where there is none.
    static std::string sentence();
    static double seconds();
};

}  // namespace viewing
