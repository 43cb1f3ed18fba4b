#include "topics/depth/shown/draw_steps.h"

#include <algorithm>

namespace viewing {

int step_count(const std::vector<DrawCall>& calls) {
    int count = 0;
    for (const DrawCall& call : calls) count += call.triangles;
    return count;
}

int step_of(const DrawLimit& limit, const std::vector<DrawCall>& calls) {
    if (limit.call < 0) return -1;
    int step = 0;
    for (std::size_t i = 0; i < calls.size(); ++i) {
        if (static_cast<int>(i) < limit.call) step += calls[i].triangles;
        if (static_cast<int>(i) == limit.call)
            step += limit.triangles < 0 ? calls[i].triangles : std::min(limit.triangles, calls[i].triangles);
    }
    return step;
}

DrawLimit limit_of(int step, const std::vector<DrawCall>& calls) {
    if (step < 0 || calls.empty()) return {};
    if (step == 0) return {0, 0};
    int left = step;
    for (std::size_t i = 0; i < calls.size(); ++i) {
        if (left <= calls[i].triangles) return {static_cast<int>(i), left};
        left -= calls[i].triangles;
    }
    return {static_cast<int>(calls.size()) - 1, calls.back().triangles};
}

DrawLimit next_call(const DrawLimit& limit, const std::vector<DrawCall>& calls) {
    const int last = static_cast<int>(calls.size()) - 1;
    if (limit.call < 0 || limit.call >= last) return {};
    const bool is_nothing = limit.call == 0 && limit.triangles == 0;
    return {is_nothing ? 0 : limit.call + 1, -1};
}

DrawLimit previous_call(const DrawLimit& limit, const std::vector<DrawCall>& calls) {
    const int count = static_cast<int>(calls.size());
    if (count == 0) return {};
    const int call = limit.call < 0 ? count : std::min(limit.call, count);
    return call == 0 ? DrawLimit{0, 0} : DrawLimit{call - 1, -1};
}

std::optional<DrawLimit> next_of(const std::vector<DrawLimit>& limits, const DrawLimit& limit,
                                 const std::vector<DrawCall>& calls) {
    const int step = step_of(limit, calls);
    const auto next = std::find_if(limits.begin(), limits.end(),
                                   [&](const DrawLimit& other) { return step >= 0 && step_of(other, calls) > step; });
    return next == limits.end() ? std::nullopt : std::optional(*next);
}

std::optional<DrawLimit> previous_of(const std::vector<DrawLimit>& limits, const DrawLimit& limit,
                                     const std::vector<DrawCall>& calls) {
    const int step = limit.call < 0 ? step_count(calls) + 1 : step_of(limit, calls);
    const auto before = std::find_if(limits.rbegin(), limits.rend(),
                                     [&](const DrawLimit& other) { return step_of(other, calls) < step; });
    return before == limits.rend() ? std::nullopt : std::optional(*before);
}

}  // namespace viewing
