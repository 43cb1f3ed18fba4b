#include "topics/depth/numbers/fighting_report.h"

#include <algorithm>
#include <cmath>

#include "frame/animation.h"

namespace viewing {
namespace {

double share(std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

}  // namespace

double CountedPair::wrong_fraction() const {
    return share(wrong, pixels);
}

double FightingCounts::wrong_fraction() const {
    std::int64_t wrong = 0, pixels = 0;
    for (const CountedPair& pair : pairs) {
        wrong += pair.wrong;
        pixels += pair.pixels;
    }
    return share(wrong, pixels);
}

std::int64_t FightingCounts::vanished() const {
    std::int64_t sum = vanished_elsewhere;
    for (const CountedPair& pair : pairs) sum += pair.vanished;
    return sum;
}

void ShareSpread::take(double share) {
    ++cameras;
    sum += share;
    sum_of_squares += share * share;
    least = std::min(least, share);
    most = std::max(most, share);
}

double ShareSpread::deviation() const {
    return cameras > 1 ? std::sqrt(std::max(sum_of_squares - sum * mean(), 0.0) / (cameras - 1)) : 0.0;
}

double ShareSpread::standard_error() const {
    return cameras > 1 ? deviation() / std::sqrt(cameras) : 0.0;
}

Params jittered(const Params& state, int camera) {
    constexpr double between_s = 0.83;  // not in step with either of the jitter's two frequencies
    Params params = state;
    params.animation.jiggle = true;
    params = animated(params, {.time_s = (camera + 1) * between_s});
    params.animation = state.animation;
    return params;
}

FightingReport fighting_report(FightingCounts counts, const Params& params, const Derived& derived, const Scene& scene,
                               glm::ivec2 size_px) {
    FightingReport made;
    const auto name_of = [&scene](int object) {
        return scene.objects.at(static_cast<std::size_t>(object)).description.name;
    };
    for (const CountedPair& counted : counts.pairs)
        made.rows.push_back({name_of(counted.pair.first),
                             name_of(counted.pair.second),
                             predict_pair(counted.pair, params, derived, size_px),
                             {}});
    if (!counts.pairs.empty())
        for (Cure& cure : cures(params, derived, scene)) made.cured.push_back({std::move(cure), {}});
    made.counts = std::move(counts);
    made.size_px = size_px;
    return made;
}

}  // namespace viewing
