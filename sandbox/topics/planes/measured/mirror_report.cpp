#include "topics/planes/measured/mirror_report.h"

#include "report/as_json.h"
#include "topics/planes/measured/mirror_measure.h"

namespace viewing {

Result<Json> mirror_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 size_px) {
    const Result<MirrorWays> measured = compare_mirror_ways(renderer, params, scene, size_px);
    if (!measured) return Error{measured.error()};
    Json ways = Json::array();
    for (std::size_t index = 0; index < mirror_way_count; ++index) {
        const MirrorWayReport& report = measured->reports[index];
        ways.push_back({{"way", name_of(static_cast<MirrorWay>(index))},
                        {"different", report.different},
                        {"worst", report.worst},
                        {"pixels", report.compared},
                        {"image_pixels", report.image_pixels},
                        {"first_depth", report.first_depth},
                        {"last_depth", report.last_depth},
                        {"distinct_depths", report.distinct_depths}});
    }
    return Json{{"scene", scene_name(params)}, {"size", as_json(size_px)}, {"ways", std::move(ways)}};
}

}  // namespace viewing
