// inspect: what is at one pixel, read back from the buffers, and every surface that was sent there.
#include "cli/as_json.h"
#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "cli/values.h"
#include "frame/depth/reconcile.h"
#include "measure/hidden_answers.h"
#include "render/probe.h"

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

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::optional<std::string> pixel_text, size_text, device_text;
    options.group("Pixel");
    options.text("--pixel", "X,Y", pixel_text, "Which one; 0,0 is the top left; default: the state's view.pixel");
    options.text("--size", "WxH", size_text, size_help);
    add_device_option(options, device_text);
    if (!options.parse(arguments)) return ExitStatus::done;

    const glm::ivec2 size_px = size_option(options, size_text);
    const LoadedState state = state_arguments.load();
    if (const auto& pinned = state.params.view.pixel; pinned && !pixel_text)
        pixel_text = std::to_string(pinned->x) + "," + std::to_string(pinned->y);
    const glm::ivec2 pixel = pixel_option(options, pixel_text, size_px);
    const Scene scene = scene_of(state);
    const Params params = probed(state.params);

    refuse_beyond_budget(params, derive(params, scene, Viewport{size_px}), scene, size_px);
    Headless headless(device_option(options, device_text));
    const bool clip_control = headless.renderer().capabilities().clip_control;
    const Derived derived = derive(params, scene, Viewport{size_px, clip_control});
    const Result<FramePlan> frame = plan_at_once(headless.renderer(), params, derived, scene, size_px);
    headless.drawn(frame ? Status(std::monostate{}) : Status(Error{frame.error()}));
    PixelProbe probe;
    headless.drawn(probe.prepare(headless.renderer(), *frame, scene, derived, size_px));
    const PixelReport report = probe.at(pixel, scene);
    headless.require_no_errors();
    Json json = report_as_json(report);
    std::vector<Fragment> fragments = FragmentFinder(scene).at(*frame, pixel, size_px);
    reconcile(fragments, report, frame->clears_depth());
    json["fragments"] = fragments_as_json(fragments);
    if (has_raster(params.visibility))
        json["raster"] = raster_as_json(hidden_request(params, derived, size_px), pixel, size_px);
    print(print_document(json) + "\n");
    return ExitStatus::done;
}

}  // namespace

constinit const Command inspect_command{
    "inspect",
    "[STATE] [--set PATH=VALUE]… --pixel X,Y [--size WxH] [--device N|auto]",
    "colour, depth, stencil, object and all fragments at one pixel, as JSON",
    "Draws the camera view without multisampling and reads one pixel back: its "
    "colour, the depth as stored and as it is in "
    "the eye's space, the width of one stored code there (step) and what can be told apart there, which for a float is "
    "often more (resolvable_step), the stencil "
    "value, and whose surface it is. \"object\" is "
    "null for the background, \"plane\" for the plane's patch and \"plane 2\" for a further one's; eye_z, step and "
    "world "
    "are null where the depth is that of a cleared buffer. "
    "\"fragments\" are all surfaces on the pixel's ray in drawing order, computed: "
    "the code that each stores, how far GL's may be from it, in codes or a float's last places (within), whether it "
    "passes the tests at its turn and whether its colour is drawn; the last one "
    "drawn is what is seen. \"culled\", \"tie\" "
    "(the same code as the one it is compared with) and \"rounding\" (surfaces so close that GL's "
    "rounding decides, not the codes) stand only where they are true. "
    "Mirror image and shadows are left out. \"raster\" stands only where visibility.raster makes a picture of few "
    "large "
    "pixels: its size and the one of its pixels that this one shows, whose middle then is what the fragments are "
    "about; "
    "null beside the picture.",
    "inspect --pixel 640,360\n"
    "inspect --set depth.format=d16 --pixel 100,50 --size 200x100",
    "023489",
    run};

}  // namespace viewing
