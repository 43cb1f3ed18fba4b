// measure: measures a frame, or the costs of methods as the number of polygons grows. Read
// topics/hidden/measured/visibility_report.h and topics/depth/measured/fighting_as_json.h next.
#include <array>
#include <limits>

#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "report/as_json.h"
#include "topics/depth/measured/fighting_as_json.h"
#include "topics/hidden/measured/order_report.h"
#include "topics/hidden/measured/visibility_report.h"
#include "topics/hidden/methods/growth.h"
#include "topics/hidden/numbers/hidden_budget.h"
#include "topics/hidden/numbers/hidden_surfaces.h"
#include "topics/planes/measured/mirror_report.h"

namespace viewing {
namespace {

constexpr std::array<const char*, 5> quantities{"visibility", "growth", "fighting", "mirror", "order"};
constexpr std::array<const char*, 3> polygon_kinds{"small", "large", "scene"};
constexpr std::array<const char*, 2> measure_formats{"json", "csv"};

/// The options as typed.
struct TypedMeasure {
    std::optional<std::string> what, size, device, max, polygons, format;
    bool no_times = false;
};

void declare(Options& options, TypedMeasure& typed) {
    options.group("Measurement");
    options.text(
        "--what", "QUANTITY", typed.what,
        "visibility: runs each hidden-surface method on the scene from the camera; growth: the cost of each on more "
        "and more polygons; fighting: depth fighting, counted and predicted; mirror: the mirror image drawn in four "
        "ways, compared; order: which polygon hides which, and whether whole polygons can be ordered");
    options.text("--size", "WxH", typed.size,
                 "Width and height of the pictures in pixels, 1x1 to 16384x16384 and at most 4 million pixels; default "
                 "1280x720, for growth 320x240");
    options.flag("--no-times", typed.no_times, "Leaves out times, so that every run gives the same bytes");
    options.group("For visibility, fighting and mirror");
    add_device_option(options, typed.device);
    options.group("For growth");
    options.text("--max", "N", typed.max, "The largest number of polygons, 1 to 1000000; default 10000");
    options.text("--polygons", "KIND", typed.polygons,
                 "small (default): random triangles; large: random triangles that intersect each other; scene: the "
                 "polygons of STATE from its camera");
    options.text("--format", "FORMAT", typed.format, "json (default) or csv");
}

/// Refuses options that the chosen --what does not use.
void refuse_strangers(const Options& options, const TypedMeasure& typed) {
    const bool grows = typed.what == "growth", draws = !grows && typed.what != "order";
    if (!grows && typed.max) options.refuse("--max needs --what growth");
    if (!grows && typed.polygons) options.refuse("--polygons needs --what growth");
    if (!grows && typed.format) options.refuse("--format needs --what growth");
    if (!draws && typed.device)
        options.refuse("--device needs --what visibility, fighting or mirror: " + *typed.what +
                       " draws nothing with GL");
}

/// Returns the default numbers of polygons below `max`, followed by `max` itself.
std::vector<int> counts_up_to(int max) {
    std::vector<int> counts = GrowthRequest{}.counts;
    std::erase_if(counts, [max](int count) { return count >= max; });
    counts.push_back(max);
    return counts;
}

GrowthRequest growth_request(const Options& options, const TypedMeasure& typed) {
    GrowthRequest request;
    request.counts = counts_up_to(typed.max ? whole_option(options, "--max", *typed.max, 1, 1'000'000) : 10'000);
    const std::string kind = typed.polygons.value_or(polygon_kinds.front());
    request.scene = static_cast<GrowthScene>(choice_option(options, "--polygons", kind, polygon_kinds));
    if (typed.no_times) {  // if no times are measured, only the number of pairs limits a method
        request.time_budget_ms = std::numeric_limits<double>::infinity();
        request.max_pairs = 100'000'000;
    }
    if (typed.size) {
        const glm::ivec2 size_px = size_option(options, typed.size, most_measured_pixels);
        request.width = size_px.x;
        request.height = size_px.y;
    }
    return request;
}

Json growth_as_json(const LoadedState& state, const GrowthRequest& request, const std::vector<GrowthRow>& measured,
                    bool with_times) {
    Json rows = Json::array();
    for (const GrowthRow& row : measured)
        rows.push_back({{"method", growth_method_name(row.method)},
                        {"polygons", row.polygons},
                        {"time_ms", row.time_ms},
                        {"time_least_ms", row.time_least_ms},
                        {"time_most_ms", row.time_most_ms},
                        {"runs", row.runs},
                        {"operation", row.operation_name},
                        {"operations", row.operations},
                        {"pixels_painted", row.pixels_painted},
                        {"painting_ms", row.painting_ms},
                        {"build_ms", row.build_ms},
                        {"problem", row.problem.empty() ? Json() : Json(say(row.problem))}});
    const bool is_own = request.scene == GrowthScene::own_polygons;
    Json json{{"polygons", polygon_kinds[static_cast<std::size_t>(request.scene)]},
              {"scene", is_own ? Json(scene_name(state.params)) : Json()},
              {"size", as_json(glm::ivec2(request.width, request.height))},
              {"rows", std::move(rows)},
              {"summary", say(growth_summary(measured))}};
    if (with_times) json["times"] = say(growth_times(measured));
    return json;
}

std::string document(Json json, bool with_times) {
    return print_document(with_times ? std::move(json) : without_times(std::move(json))) + "\n";
}

std::string growth_text(const LoadedState& state, const Scene& scene, GrowthRequest request, bool as_csv,
                        bool with_times) {
    if (request.scene == GrowthScene::own_polygons) {
        const glm::ivec2 size_px(request.width, request.height);
        end_if(beyond_hidden_budget(scene, true));
        request.own_polygons = surface_of(scene).polygons;
        request.viewpoint =
            hidden_request(state.params, derive(state.params, scene, Viewport{size_px}), size_px).viewpoint;
    }
    const std::vector<GrowthRow> rows = measure_growth(request);
    return as_csv ? growth_csv(rows, with_times)
                  : document(growth_as_json(state, request, rows, with_times), with_times);
}

ExitStatus run_measure(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    TypedMeasure typed;
    declare(options, typed);
    if (!options.parse(arguments)) return ExitStatus::done;

    if (!typed.what) options.refuse("--what is missing: one of visibility, growth, fighting, mirror, order");
    typed.what = quantities[choice_option(options, "--what", *typed.what, quantities)];
    refuse_strangers(options, typed);
    const glm::ivec2 size_px = size_option(options, typed.size, most_measured_pixels);
    const GrowthRequest growth = growth_request(options, typed);
    const bool as_csv = choice_option(options, "--format", typed.format.value_or("json"), measure_formats) == 1;
    const LoadedState state = state_arguments.load();
    const Scene scene = scene_of(state);

    if (typed.what == "visibility") end_if(beyond_hidden_budget(scene, true));

    std::string text;
    if (typed.what == "growth") {
        text = growth_text(state, scene, growth, as_csv, !typed.no_times);
    } else if (typed.what == "order") {
        text = document(value_or_end(order_as_json(state.params, scene, size_px)), !typed.no_times);
    } else {
        Headless headless(device_option(options, typed.device));
        const auto measured = [&](Renderer& renderer) {
            if (typed.what == "fighting") return fighting_as_json(renderer, state.params, scene, size_px);
            return (typed.what == "mirror" ? mirror_as_json : visibility_as_json)(renderer, state.params, scene,
                                                                                  size_px);
        };
        text = document(headless.drawn(measured(headless.renderer())), !typed.no_times);
    }
    print(text);
    return ExitStatus::done;
}

}  // namespace

constinit const Command measure_command{
    "measure",
    "[STATE] [--set PATH=VALUE]… --what visibility|growth|fighting|mirror|order [--size WxH] [OPTIONS]",
    "measures hidden-surface methods, depth fighting, mirror images, occlusion: JSON or CSV",
    "visibility runs every hidden-surface method on the scene from the camera, with the state's sort key, splitter, "
    "epsilon and culling: counters, times in milliseconds, and wrong_pixels, which show a surface that ray casting "
    "with triangles sees nowhere within the pixel. A number that a method does not have is null; problem is a sentence "
    "if it stopped at a budget. painter_keys has the wrong pixels of each sort key. culling counts front and back "
    "faces by the eye's side of each plane and by the winding on the screen, as GL does, and the faces that culling "
    "leaves. growth runs the methods on more and more polygons; summary says which method needs the fewest operations "
    "in which range of polygon counts; times says how long the methods took. time_ms excludes painting_ms (the time to "
    "paint in the order that a method has found) for visibility, and includes it for growth. fighting counts, for "
    "every pair of flat objects that are nearly coplanar (parallel within a degree, at most a tenth of their size "
    "apart), the pixels where GL shows the wrong one, beside the predictions of the formulas: step is the width of a "
    "depth code in eye distance, quantisation one code along the pair's normal, arithmetic the error that float32 "
    "adds, predicted_onset_gap their sum, below which fighting begins. elsewhere has the wrong pixels outside the "
    "pairs: bleeding counts the pixels where too large a polygon offset lets another surface through, vanished those "
    "with the cleared code. predicted_wrong_fraction is an interval that holds for any arithmetic, or null; "
    "trembling_wrong_fraction is counted from 12 cameras, jittered by a thousandth of the target's distance; where "
    "nothing is predicted, the table of the window shows its least and most. minimum_gap is found by drawing quads "
    "closer and closer together at the target's distance; null if no gap is wide enough. mirror draws the mirror image "
    "with clip distance, without clipping, with an oblique near plane, and with "
    "the camera mirrored instead of the scene: different counts the pixels without a match within 2 levels among their "
    "neighbors in the first picture, worst is their largest difference, and the depths are those that the image leaves "
    "in the buffer before its mirror covers it: distinct_depths counts the codes in use, which does not measure how "
    "finely they resolve surfaces. order compares every polygon with every other one (at most 20000): a pair [a, b] "
    "says that a must be painted before b, which hides a part of it; two polygons that intersect appear as both [a, b] "
    "and [b, a]. polygons has the number of triangles, object the object of each one, objects the same for whole "
    "objects by name. exists says whether an order of whole polygons obeys all pairs; if so, order is one, from back "
    "to front, else cycle names a few polygons, each of which must come before the next, and the last before the "
    "first. painter_keys has the number of pairs that each sort key puts in the wrong order.",
    "measure --what visibility\n"
    "measure painter-cycle --what visibility --size 640x360\n"
    "measure bunny.obj --set visibility.splitter=balanced --what visibility --timeout 60\n"
    "measure depth-fighting --what fighting\n"
    "measure mirror-unclipped --what mirror\n"
    "measure cyclic-overlap --what order\n"
    "measure --what growth --max 3000 --format csv > growth.csv\n"
    "measure teapot --what growth --polygons scene",
    "023489",
    run_measure};

}  // namespace viewing
