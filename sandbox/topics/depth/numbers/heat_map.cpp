#include "topics/depth/numbers/heat_map.h"

#include <algorithm>
#include <cmath>

#include "topics/depth/numbers/fighting.h"

namespace viewing {

double HeatMap::distance_of(std::size_t entry) const {
    return near * std::pow(far / near, static_cast<double>(entry) / static_cast<double>(entry_count - 1));
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

}  // namespace viewing
