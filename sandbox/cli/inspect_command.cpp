// inspect: reads one pixel back from the buffers, and lists every surface drawn there.
#include <array>
#include <iostream>
#include <sstream>

#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "frame/pinned_pixel.h"
#include "platform/text_file.h"
#include "topics/depth/measured/pixel_as_json.h"
#include "topics/why/measured/why_report.h"

namespace viewing {
namespace {

/// A pixel as typed, "X,Y", and where.
struct TypedPixel {
    std::string text, place;
};

/// Returns the pixels in a file, one per line; skips empty lines.
std::vector<TypedPixel> lines_of(const std::string& file) {
    std::istringstream lines(value_or_end(file == "-" ? read_text(std::cin, "standard input") : read_text_file(file)));
    std::vector<TypedPixel> pixels;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.ends_with('\r')) line.pop_back();
        if (!line.empty()) pixels.push_back({line, "--pixels: line " + std::to_string(number)});
    }
    return pixels;
}

/// Returns the pixel that the state pins, in the form that --pixel takes; nothing if the state pins none.
std::optional<std::string> pixel_of_state(const Params& params, const Derived& derived, const Scene& scene,
                                          glm::ivec2 size_px) {
    const PinnedPixel pinned = pinned_pixel(params, derived, plan(params, derived), scene, size_px);
    if (!pinned.why_none.empty() && params.view.pin) throw Failure(ExitStatus::bad_input, say(pinned.why_none));
    const std::optional<glm::ivec2> pixel = pinned.pixel ? pinned.pixel : params.view.pixel;
    if (!pixel) return std::nullopt;
    return std::to_string(pixel->x) + "," + std::to_string(pixel->y);
}

ExitStatus run_inspect(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    std::vector<std::string> pixel_texts;
    std::optional<std::string> file, size_text, device_text, format;
    bool explains = false;
    options.group("Pixel");
    options.texts("--pixel", "X,Y", pixel_texts,
                  "The pixel; 0,0 is the top left; repeatable; default: the state's view.pin or view.pixel");
    options.text("--pixels", "FILE|-", file, "Adds the pixels of a file, one X,Y per line, after --pixel");
    options.text("--size", "WxH", size_text, size_help);
    add_device_option(options, device_text);
    options.group("Explanation");
    options.flag("--why", explains,
                 "Explains the color instead: all passes, mirrors and lights, and the fix for what is wrong");
    options.text("--format", "FORMAT", format, "json (default) or, with --why, text");
    if (!options.parse(arguments)) return ExitStatus::done;

    static constexpr std::array formats{"json", "text"};
    const bool is_text = choice_option(options, "--format", format.value_or("json"), formats) == 1;
    if (is_text && !explains) options.refuse("--format text needs --why");
    const glm::ivec2 size_px = size_option(options, size_text);
    if (file == "-" && state_arguments.as_typed() == "-")
        options.refuse("--pixels and STATE cannot both be standard input");
    const bool is_list = file || pixel_texts.size() > 1;
    std::vector<TypedPixel> typed;
    for (const std::string& text : pixel_texts) typed.push_back({text, "--pixel"});
    if (file)
        for (TypedPixel& line : lines_of(*file)) typed.push_back(std::move(line));
    constexpr std::size_t most_pixels = 100'000;
    if (typed.size() > most_pixels) options.refuse("--pixels: at most 100000 pixels in one run");
    const LoadedState state = state_arguments.load();
    const Scene scene = scene_of(state);
    const Derived derived = derive(state.params, scene, Viewport{size_px});
    std::vector<glm::ivec2> pixels;
    for (const auto& [text, place] : typed) pixels.push_back(pixel_option(options, text, size_px, place));
    if (pixels.empty() && !is_list)
        pixels.push_back(pixel_option(options, pixel_of_state(state.params, derived, scene, size_px), size_px));
    refuse_beyond_budget(state.params, derived, scene, size_px);
    Headless headless(device_option(options, device_text));
    if (explains) {
        const std::vector<Why> all =
            headless.drawn(explained_pixels(headless.renderer(), state.params, scene, pixels, size_px));
        Json list = Json::array();
        std::string text;
        for (const Why& one : all) {
            list.push_back(why_as_json(one));
            text += say(why_as_text(one));
        }
        print(is_text ? text : print_document(is_list ? list : list.front()) + "\n");
        return ExitStatus::done;
    }
    const Json list = headless.drawn(pixels_as_json(headless.renderer(), state.params, scene, pixels, size_px));
    print(print_document(is_list ? list : list.front()) + "\n");
    return ExitStatus::done;
}

}  // namespace

constinit const Command inspect_command{
    "inspect",
    "[STATE] [--set PATH=VALUE]… --pixel X,Y… [--pixels FILE] [--why] [--size WxH] [--device N|auto]",
    "prints color, depth, stencil, object and all fragments at one pixel, as JSON",
    "Draws the camera view without multisampling and reads back one pixel; several pixels are printed as an array. The "
    "color is that of snapshot --view camera --samples 0, so it depends on view.shows; the other values describe the "
    "surface: its depth as stored and in eye space, the width of one depth code there (step) and the smallest distance "
    "that can be resolved there, which for a float is often larger (resolvable_step), the stencil value, and the "
    "object it belongs to. \"object\" is null for the background, \"plane\" for the patch of the plane and \"plane 2\" "
    "for that of a second one; eye_z, step and world are null if the depth is that of a cleared buffer. \"fragments\" "
    "lists all surfaces on the pixel's ray in drawing order, as computed: the code that each one stores, how far GL's "
    "code may be from it, in codes or units in the last place of a float (within), whether it passes the tests when it "
    "is drawn and whether its color is drawn; the last one drawn is visible. \"culled\", \"tie\" (the same code as the "
    "one it is compared with) and \"rounding\" (surfaces so close that GL's rounding decides, not the codes) appear "
    "only if true. Mirror image and shadows are left out. \"raster\" appears only if visibility.raster makes a picture "
    "of a few large pixels: its size and the large pixel that contains this one, to whose center the fragments then "
    "refer; null outside the picture. With --why, the command instead explains the color: everything on the ray, each "
    "pass with its tests and what it writes, the path from mirror to mirror, each light and what blocks it, and every "
    "problem whose fix changes this pixel. \"predicted\" is the color computed from this explanation, \"read_back\" "
    "the one in the buffer.",
    "inspect --pixel 640,360\n"
    "inspect --pixel 640,360 --pixel 100,50\n"
    "inspect shadow-false --pixel 640,500 --why --format text\n"
    "inspect --set depth.format=d16 --pixel 100,50 --size 200x100",
    "023489",
    run_inspect};

}  // namespace viewing
