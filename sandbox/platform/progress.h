// Lets long work report its progress and find out that it must stop. Read background.h next.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>

namespace viewing {

/// The worker writes `fraction` and reads `canceled`. A canceled method returns soon, with a defined but incomplete
/// result and a sentence that says so. Work may be part of other work, `whole`. The part's progress then appears there
/// between `begin` and `end`, and canceling the whole also cancels the part.
struct WorkProgress {
    std::atomic<float> fraction{0.0F};  ///< 0 … 1
    std::atomic<bool> canceled{false};

    WorkProgress* whole = nullptr;
    double begin = 0.0, end = 1.0;  ///< this part's range in `whole`

    using Clock = std::chrono::steady_clock;
    Clock::time_point deadline = Clock::time_point::max();  ///< after this time, the work counts as canceled
};

#ifdef __EMSCRIPTEN__
/// A page has only one thread, so long work lets the page run whenever it checks for cancellation.
void give_way();
#else
inline void give_way() {}
#endif

/// Whether the time for the work has run out.
inline bool is_late(const WorkProgress& progress) {
    return progress.deadline != WorkProgress::Clock::time_point::max() &&
           WorkProgress::Clock::now() > progress.deadline;
}

inline bool is_canceled(const WorkProgress* progress) {
    if (progress != nullptr) give_way();
    return progress != nullptr &&
           (progress->canceled.load(std::memory_order_relaxed) || is_late(*progress) || is_canceled(progress->whole));
}

/// Whether to check for cancellation before this item of a long sequence. Checking before each item would cost more
/// than the items themselves.
constexpr bool is_time_to_look(std::size_t item) {
    return item % 4096 == 0;
}

/// Whether work must stop before this item because it was canceled. Always false for the first 32,768 items, since
/// quick work is worth completing.
inline bool is_cut_short(std::size_t item, const WorkProgress* progress) {
    constexpr std::size_t quickly_made = 32'768;
    return item >= quickly_made && is_time_to_look(item) && is_canceled(progress);
}

/// Reports a fraction of the work. The progress of `whole` never decreases, even if a part is done again.
inline void report(WorkProgress* progress, double fraction) {
    if (progress == nullptr) return;
    progress->fraction.store(static_cast<float>(fraction), std::memory_order_relaxed);
    if (WorkProgress* const whole = progress->whole) {
        const double of_whole = progress->begin + (progress->end - progress->begin) * fraction;
        report(whole, std::max(of_whole, static_cast<double>(whole->fraction.load(std::memory_order_relaxed))));
    }
}

}  // namespace viewing
