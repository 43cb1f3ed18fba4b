// How long work tells how far it is and is told to stop. Read background.h next.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>

namespace viewing {

/// `fraction` is written by the worker, `cancelled` is read by it. A cancelled method returns soon, with a defined,
/// unfinished result and a sentence that says so. A work may be part of a longer one: then what is done of it is shown
/// there between `begin` and `end`, and it is cancelled with it.
struct WorkProgress {
    std::atomic<float> fraction{0.0F};  ///< 0 … 1
    std::atomic<bool> cancelled{false};

    WorkProgress* whole = nullptr;
    double begin = 0.0, end = 1.0;  ///< of `whole`

    using Clock = std::chrono::steady_clock;
    Clock::time_point deadline = Clock::time_point::max();  ///< from then on as if it were cancelled
};

#ifdef __EMSCRIPTEN__
/// A page has one thread: long work lets it have its turn wherever it asks whether it is cancelled.
void give_way();
#else
inline void give_way() {}
#endif

/// Whether the time that it had has run out.
inline bool is_late(const WorkProgress& progress) {
    return progress.deadline != WorkProgress::Clock::time_point::max() &&
           WorkProgress::Clock::now() > progress.deadline;
}

inline bool is_cancelled(const WorkProgress* progress) {
    if (progress != nullptr) give_way();
    return progress != nullptr &&
           (progress->cancelled.load(std::memory_order_relaxed) || is_late(*progress) || is_cancelled(progress->whole));
}

/// Whether the item of a long row is one before which the worker looks whether it is cancelled: not before each, which
/// would cost more than the items.
constexpr bool is_time_to_look(std::size_t item) {
    return item % 4096 == 0;
}

/// For what is worth having whole where it is quickly made: cancelled, it ends before this item, which is none of the
/// first 32,768.
inline bool is_cut_short(std::size_t item, const WorkProgress* progress) {
    constexpr std::size_t quickly_made = 32'768;
    return item >= quickly_made && is_time_to_look(item) && is_cancelled(progress);
}

/// The whole of a part never falls back, even when the part is done once more.
inline void report(WorkProgress* progress, double fraction) {
    if (progress == nullptr) return;
    progress->fraction.store(static_cast<float>(fraction), std::memory_order_relaxed);
    if (WorkProgress* const whole = progress->whole) {
        const double of_whole = progress->begin + (progress->end - progress->begin) * fraction;
        report(whole, std::max(of_whole, static_cast<double>(whole->fraction.load(std::memory_order_relaxed))));
    }
}

}  // namespace viewing
