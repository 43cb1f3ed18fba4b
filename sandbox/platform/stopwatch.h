// A stopwatch that starts when it is made.
#pragma once

#include <chrono>

namespace viewing {

class Stopwatch {
public:
    double ms() const { return std::chrono::duration<double, std::milli>(Clock::now() - started_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point started_ = Clock::now();
};

}  // namespace viewing
