#include "topics/depth/numbers/heat_map.h"

#include <algorithm>
#include <cmath>

#include "topics/depth/numbers/fighting.h"

namespace viewing {
namespace {

/// Returns the position of `value` between `from` and `to` on a logarithmic scale; 0 if these are equal.
double logarithmic_place(double value, double from, double to) {
    const double range = std::log(to / from);
    return range > 0.0 ? std::clamp(std::log(value / from) / range, 0.0, 1.0) : 0.0;
}

}  // namespace

double HeatMap::distance_of(std::size_t entry) const {
    return near * std::pow(far / near, static_cast<double>(entry) / static_cast<double>(entry_count - 1));
}

double HeatMap::onset_at(double distance) const {
    const double place = logarithmic_place(std::max(distance, near), near, far) * static_cast<double>(entry_count - 1);
    const auto entry = std::min(static_cast<std::size_t>(place), entry_count - 2);
    const double share = place - static_cast<double>(entry);
    return std::exp((1.0 - share) * std::log(onsets[entry]) + share * std::log(onsets[entry + 1]));
}

HeatMap heat_map(const Params& params, const Derived& derived, const Scene& scene) {
    HeatMap made;
    const DepthCoding coding = depth_coding(params, derived);
    made.near = coding.lens.logarithmic_near();
    made.far = coding.lens.shown_far();
    constexpr double narrowest = 1e-12;  // relative to the distance; keeps every entry positive
    for (std::size_t entry = HeatMap::entry_count; entry-- > 0;) {
        const double distance = made.distance_of(entry);
        const FightingOnset onset = fighting_onset(coding, distance);
        const bool is_last = entry + 1 == HeatMap::entry_count;
        made.onsets[entry] =
            onset.is_reachable || is_last ? std::max(onset.gap(), narrowest * distance) : made.onsets[entry + 1];
    }
    made.gap_of_object.resize(scene.objects.size());
    for (const FlatPair& pair : near_coplanar_pairs(scene)) {
        const glm::dvec3 normal_view(derived.view_from_world * glm::dvec4(pair.normal_world, 0.0));
        for (const int object : {pair.first, pair.second}) {
            std::optional<FlatGap>& found = made.gap_of_object[object];
            if (!found || pair.gap() < found->gap) found = FlatGap{pair.gap(), normal_view};
        }
    }
    return made;
}

Color heat_color(double ratio) {
    const double place = ratio < 1.0 ? 2.0 * std::max(ratio, 0.0) : 3.0 + std::min(std::log2(ratio), 2.0);
    const auto first = std::min(static_cast<std::size_t>(place), ratio < 1.0 ? std::size_t{1} : std::size_t{4});
    const double share = place - static_cast<double>(first);
    const Color &a = heat_colors[first], &b = heat_colors[first + 1];
    const auto mixed = [share](int from, int to) {
        return static_cast<std::uint8_t>(std::lround((1.0 - share) * from + share * to));
    };
    return {mixed(a.r, b.r), mixed(a.g, b.g), mixed(a.b, b.b)};
}

}  // namespace viewing
