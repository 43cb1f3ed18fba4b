#include "report/pixel_as_json.h"

#include "frame/depth/reconcile.h"
#include "measure/hidden_answers.h"
#include "render/probe.h"
#include "report/as_json.h"

namespace viewing {
namespace {

/// What only a surface has is null for the background, and what depth says where it is that of a cleared buffer.
Json report_as_json(const PixelReport& report) {
    const auto of_surface = [&report](Json value) { return report.written ? std::move(value) : Json(); };
    const auto of_depth = [&report](Json value) { return report.has_depth ? std::move(value) : Json(); };
    return {{"pixel", as_json(report.pixel)},
            {"color", as_text(report.color)},
            {"depth",
             {{"window", report.window_depth},
              {"stored", report.stored},
              {"bits", report.precision.is_float ? 32 : report.precision.bits},
              {"ndc", report.ndc_z},
              {"eye_z", of_depth(report.eye_z)},
              {"step", of_depth(report.step)},
              {"resolvable_step", of_depth(report.resolvable_step)}}},
            {"stencil", report.stencil},
            {"object", of_surface(report.object)},
            {"facing", of_surface(report.front_facing ? "front" : "back")},
            {"world", of_depth(as_json(report.world))}};
}

/// In drawing order; "culled", "tie" and "rounding" stand only where they are true.
Json fragments_as_json(const std::vector<Fragment>& fragments) {
    Json list = Json::array();
    for (const Fragment& fragment : fragments) {
        Json entry = {{"object", fragment.object},
                      {"eye_z", fragment.eye_z},
                      {"stored", fragment.stored},
                      {"within", fragment.within},
                      {"facing", fragment.front_facing ? "front" : "back"},
                      {"passes", fragment.passes},
                      {"drawn", fragment.drawn}};
        if (fragment.culled) entry["culled"] = true;
        if (fragment.tie) entry["tie"] = true;
        if (fragment.decided_by_rounding) entry["rounding"] = true;
        list.push_back(std::move(entry));
    }
    return list;
}

/// The pixel of the small raster that a pixel of the view lies in; null beside it.
Json raster_as_json(const HiddenRequest& request, glm::ivec2 pixel, glm::ivec2 size_px) {
    const auto own = raster_pixel(glm::dvec2(pixel) + 0.5, size_px, request.size_px, request.share);
    return {{"size", as_json(request.size_px)}, {"pixel", own ? as_json(*own) : Json()}};
}

}  // namespace

Result<Json> pixel_as_json(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 pixel,
                           glm::ivec2 size_px) {
    const Params params = probed(state);
    const Derived derived = derive(params, scene, Viewport{size_px, renderer.capabilities().clip_control});
    const Result<FramePlan> frame = plan_at_once(renderer, params, derived, scene, size_px);
    if (!frame) return Error{frame.error()};
    PixelProbe probe;
    if (const Status ready = probe.prepare(renderer, *frame, scene, derived, size_px); !ready)
        return Error{ready.error()};
    const PixelReport report = probe.at(pixel, scene);
    Json json = report_as_json(report);
    std::vector<Fragment> fragments = FragmentFinder(scene).at(*frame, pixel, size_px);
    reconcile(fragments, report, frame->clears_depth());
    json["fragments"] = fragments_as_json(fragments);
    if (has_raster(params.visibility))
        json["raster"] = raster_as_json(hidden_request(params, derived, size_px), pixel, size_px);
    return json;
}

}  // namespace viewing
