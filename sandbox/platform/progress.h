// How long work tells how far it is and is told to stop: shared by every method of this room. Read polygons.h next.
#pragma once

#include <atomic>

namespace viewing {

/// 0 … 1, written by the worker; `cancelled` is read by it. A cancelled method returns soon, with a defined, unfinished
/// result and a sentence that says so.
struct WorkProgress {
    std::atomic<float> fraction{0.0F};
    std::atomic<bool> cancelled{false};
};

inline bool is_cancelled(const WorkProgress* progress) {
    return progress != nullptr && progress->cancelled.load(std::memory_order_relaxed);
}

inline void report(WorkProgress* progress, double fraction) {
    if (progress != nullptr) progress->fraction.store(static_cast<float>(fraction), std::memory_order_relaxed);
}

}  // namespace viewing
