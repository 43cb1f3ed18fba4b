#include "cli/measure_mirror.h"

#include "cli/as_json.h"
#include "cli/measure_visibility.h"
#include "measure/mirror_measure.h"

namespace viewing {

Json mirror_as_json(Headless& headless, const LoadedState& state, const Scene& scene, glm::ivec2 size_px) {
    const MirrorWays measured = headless.drawn(compare_mirror_ways(headless.renderer(), state.params, scene, size_px));
    Json ways = Json::array();
    for (std::size_t index = 0; index < mirror_way_count; ++index) {
        const MirrorWayReport& report = measured.reports[index];
        ways.push_back({{"way", name_of(static_cast<MirrorWay>(index))},
                        {"different", report.different},
                        {"worst", report.worst},
                        {"pixels", report.compared},
                        {"image_pixels", report.image_pixels},
                        {"first_depth", report.first_depth},
                        {"last_depth", report.last_depth},
                        {"distinct_depths", report.distinct_depths}});
    }
    return {{"scene", scene_name(state.params)}, {"size", as_json(size_px)}, {"ways", std::move(ways)}};
}

}  // namespace viewing
