#include "topics/depth/measured/pixel_as_json.h"

#include <optional>

#include "render/probe.h"
#include "report/as_json.h"
#include "topics/depth/numbers/reconcile.h"
#include "topics/hidden/measured/camera_picture.h"
#include "topics/hidden/measured/hidden_answers.h"

namespace viewing {
namespace {

/// Surface values are null for the background; depth values are null where the buffer holds only the cleared depth.
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

/// Returns fragments in drawing order; "culled", "tie" and "rounding" are present only if they are true.
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

/// Returns the size of the low-resolution raster, and the raster pixel that contains a view pixel (null if none does).
Json raster_as_json(const HiddenRequest& request, glm::ivec2 pixel, glm::ivec2 size_px) {
    const auto own = raster_pixel(glm::dvec2(pixel) + 0.5, size_px, request.size_px, request.share);
    return {{"size", as_json(request.size_px)}, {"pixel", own ? as_json(*own) : Json()}};
}

/// Returns the picture for view.shows if it differs from the picture that the probe draws; otherwise nothing.
Result<std::optional<Image>> picture_of_its_own(Renderer& renderer, Params params, const Scene& scene,
                                                glm::ivec2 size_px) {
    if (params.view.shows == Shows::color || params.view.shows == Shows::facing) return std::optional<Image>{};
    params.view.samples = 0;
    Result<Image> picture = camera_picture(renderer, params, scene, size_px);
    if (!picture) return Error{picture.error()};
    return std::optional<Image>(*std::move(picture));
}

}  // namespace

Result<Json> pixels_as_json(Renderer& renderer, const Params& state, const Scene& scene,
                            std::span<const glm::ivec2> pixels, glm::ivec2 size_px) {
    const Result<std::optional<Image>> picture = picture_of_its_own(renderer, state, scene, size_px);
    if (!picture) return Error{picture.error()};
    const Params params = probed(state);
    const Derived derived = derive(params, scene, renderer.viewport(size_px, params.depth.format));
    const Result<FramePlan> frame = plan_at_once(renderer, params, derived, scene, size_px);
    if (!frame) return Error{frame.error()};
    PixelProbe probe;
    if (const Status ready = probe.prepare(renderer, *frame, scene, derived, size_px); !ready)
        return Error{ready.error()};
    const FragmentFinder finder(scene);
    Json list = Json::array();
    for (const glm::ivec2& pixel : pixels) {
        PixelReport report = probe.at(pixel, scene);
        std::vector<Fragment> fragments = finder.at(*frame, pixel, size_px);
        reconcile(fragments, report, frame->clears_depth());
        if (*picture) report.color = color_at(**picture, pixel);
        Json json = report_as_json(report);
        json["fragments"] = fragments_as_json(fragments);
        if (has_raster(params.visibility))
            json["raster"] = raster_as_json(hidden_request(params, derived, size_px), pixel, size_px);
        list.push_back(std::move(json));
    }
    return list;
}

Result<Json> pixel_as_json(Renderer& renderer, const Params& params, const Scene& scene, glm::ivec2 pixel,
                           glm::ivec2 size_px) {
    Result<Json> list = pixels_as_json(renderer, params, scene, {&pixel, 1}, size_px);
    if (!list) return Error{list.error()};
    return std::move(list->front());
}

}  // namespace viewing
