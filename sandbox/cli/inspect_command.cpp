// inspect: what is at one pixel, read back from the buffers, and every surface that was sent there.
#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "cli/values.h"
#include "frame/pinned_pixel.h"
#include "report/pixel_as_json.h"

namespace viewing {
namespace {

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::optional<std::string> pixel_text, size_text, device_text;
    options.group("Pixel");
    options.text("--pixel", "X,Y", pixel_text,
                 "Which one; 0,0 is the top left; default: the state's view.pin or view.pixel");
    options.text("--size", "WxH", size_text, size_help);
    add_device_option(options, device_text);
    if (!options.parse(arguments)) return ExitStatus::done;

    const glm::ivec2 size_px = size_option(options, size_text);
    const LoadedState state = state_arguments.load();
    const Scene scene = scene_of(state);
    const Derived derived = derive(state.params, scene, Viewport{size_px});
    if (!pixel_text) {
        const PinnedPixel pinned = pinned_pixel(state.params, derived, plan(state.params, derived), scene, size_px);
        if (!pinned.why_none.empty() && state.params.view.pin) throw Failure(ExitStatus::bad_input, pinned.why_none);
        if (pinned.pixel)
            pixel_text = std::to_string(pinned.pixel->x) + "," + std::to_string(pinned.pixel->y);
        else if (const auto& pixel = state.params.view.pixel)
            pixel_text = std::to_string(pixel->x) + "," + std::to_string(pixel->y);
    }
    const glm::ivec2 pixel = pixel_option(options, pixel_text, size_px);
    refuse_beyond_budget(state.params, derived, scene, size_px);
    Headless headless(device_option(options, device_text));
    const Json json = headless.drawn(pixel_as_json(headless.renderer(), state.params, scene, pixel, size_px));
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
