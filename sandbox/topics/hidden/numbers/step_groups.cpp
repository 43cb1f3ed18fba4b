#include "topics/hidden/numbers/step_groups.h"

#include <algorithm>

namespace viewing {
namespace {

int reached(const HiddenResult& result, int step) {
    return step < 0 ? result.step_count : std::min(step, result.step_count);
}

}  // namespace

std::optional<StepPlace> place_of_step(const HiddenResult& result, int step) {
    const std::vector<int>& ends = result.group_ends;
    if (ends.empty() || result.step_count == 0) return std::nullopt;
    const int at = reached(result, step);
    const auto found = std::lower_bound(ends.begin(), ends.end(), std::max(at, 1));
    const auto group = std::min(found, ends.end() - 1);
    const int first = group == ends.begin() ? 0 : *(group - 1);
    return StepPlace{.group = static_cast<int>(group - ends.begin()) + 1,
                     .groups = static_cast<int>(ends.size()),
                     .within = std::min(at, *group) - first,
                     .size = *group - first,
                     .first = first};
}

int end_of_group(const HiddenResult& result, int group) {
    return result.group_ends[group - 1];
}

std::optional<int> next_group(const HiddenResult& result, int step) {
    const std::vector<int>& ends = result.group_ends;
    const auto next = std::upper_bound(ends.begin(), ends.end(), reached(result, step));
    return next == ends.end() ? std::nullopt : std::optional(*next);
}

std::optional<int> previous_group(const HiddenResult& result, int step) {
    const std::vector<int>& ends = result.group_ends;
    const int at = reached(result, step);
    if (at == 0) return std::nullopt;
    const auto next = std::lower_bound(ends.begin(), ends.end(), at);
    return next == ends.begin() ? 0 : *(next - 1);
}

std::optional<int> next_touch(const HiddenResult& result, int step) {
    const auto next = std::find_if(result.touches.begin(), result.touches.end(),
                                   [&](const PixelTouch& touch) { return touch.step > reached(result, step); });
    return next == result.touches.end() ? std::nullopt : std::optional(next->step);
}

std::optional<int> previous_touch(const HiddenResult& result, int step) {
    const auto before = std::find_if(result.touches.rbegin(), result.touches.rend(),
                                     [&](const PixelTouch& touch) { return touch.step < reached(result, step); });
    return before == result.touches.rend() ? std::nullopt : std::optional(before->step);
}

}  // namespace viewing
