// snapshot: draws a state into a PNG, SVG or PDF file, without a display. Refuses bad input before it uses GL. Drawing
// is in app/picture.h, the context in headless.h.
#include <array>
#include <memory>
#include <utility>

#include "app/picture.h"
#include "app/vector_figure.h"
#include "cli/commands.h"
#include "cli/ending_report.h"
#include "cli/headless.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/picture_file.h"
#include "cli/results/reference.h"
#include "cli/state_arguments.h"
#include "cli/thresholds.h"
#include "frame/finite.h"
#include "gl/facts.h"
#include "grading/exercise_picture.h"
#include "lesson/lesson_run.h"
#include "report/as_json.h"
#include "topics/depth/measured/depth_image.h"

namespace viewing {
namespace {

/// The options as typed.
struct TypedSnapshot {
    std::optional<std::string> output, view, size, samples, device, repeat, compare, diff, json;
    std::optional<std::string> lesson, step, exercise, student, course;
    std::optional<std::string> dpi, code;
    bool fail_if_blank = false, revealed = false, ends = false, presents = false, labels = false, transparent = false;
};

/// The checked options.
struct SnapshotWish {
    PictureRequest picture;
    std::string view;
    std::string device;
    int repeat = 1;
    bool is_vector = false;
    bool is_numbers = false;  ///< the file holds the depths themselves
};

/// The picture, and the device and driver that drew it.
struct Drawn {
    DrawnPicture picture;
    std::string device, renderer, gl_version;
};

void declare(Options& options, TypedSnapshot& typed) {
    options.group("Picture");
    options.text("-o,--output", "OUT.png", typed.output,
                 "File to write; - for standard output. OUT.svg and OUT.pdf contain shapes and text instead of pixels "
                 "(with GL's part as an embedded image). All these carry the state that they show. With --view depth, "
                 "names that end in .npy, .pfm or z16.png get the stored window depths as float64, float32 or 16-bit "
                 "numbers");
    options.text("--view", "VIEW", typed.view,
                 "window (default): everything as on screen; camera: the camera view alone; depth, stencil: the "
                 "camera's buffers made visible; observer: the scene from outside; or one other view alone: matrices "
                 "(those in view.layout.matrices, or all), derivation, tree, order, precision, codes, histogram, "
                 "cells, pixel, fighting, passes, moving_world, clip, way, from_light, mirror_ways, lecture_code, "
                 "display_code, why. A view that would need scrolling is scaled down to fit");
    options.flag(
        "--labels", typed.labels,
        "Adds the window's handles, names and legends to --view camera, and the picture beside it (view.beside)");
    options.flag("--transparent", typed.transparent, "Makes the background transparent");
    options.text(
        "--dpi", "N", typed.dpi,
        "Dots per inch, 24 to 1200, default 96; stored in the file. Text has the same size in print at any value");
    options.text("--size", "WxH", typed.size, size_help);
    options.text("--samples", "0|4", typed.samples, samples_help);
    add_device_option(options, typed.device);
    options.group("Lesson");
    options.text("--lesson", "ID|FILE", typed.lesson,
                 "Draws a step of this lesson instead of STATE (viewing-sandbox lesson --list)");
    options.text("--step", "N", typed.step, "Number of the step, counted from 1; default 1");
    options.flag("--revealed", typed.revealed, "Shows the step after its answer");
    options.flag("--end", typed.ends, "Shows the card that ends a lesson, after its last step");
    options.flag("--present", typed.presents, "Shows the window as in a lecture room: the lesson's step, or STATE");
    options.text("--code", "ADDRESS", typed.code,
                 "Adds the QR code of a link to the step to what --present shows; ADDRESS is the part before the #");
    options.group("Exercise");
    options.text(
        "--exercise", "ID", typed.exercise,
        "Draws an exercise instead of STATE: its beginning for --student, or, with a hand-in as STATE, its end");
    options.text("--student", "ID", typed.student, "The student whose variant is shown; default: none");
    options.text("--course", "C", typed.course, "The student's course");
    options.group("Checks");
    options.text("--repeat", "N", typed.repeat,
                 "Draws N times, each in a new context; exits with status 7 unless all are byte-identical");
    options.flag("--fail-if-blank", typed.fail_if_blank, "Exits with status 5 if all pixels have the same color");
    options.text("--compare", "REF.png", typed.compare,
                 "Compares with a reference: exits with status 1 if different, 6 if there is none; the picture is "
                 "written anyway");
    options.text("--diff", "D.png", typed.diff, "Writes a picture of the differences, as compare -o does");
}

std::vector<FileArgument> outputs_of(const TypedSnapshot& typed) {
    std::vector<FileArgument> outputs;
    if (typed.output) outputs.push_back({"-o", *typed.output});
    if (typed.diff) outputs.push_back({"--diff", *typed.diff});
    if (typed.json) outputs.push_back({"--json", *typed.json});
    return outputs;
}

std::vector<FileArgument> inputs_of(const TypedSnapshot& typed, const StateArguments& state_arguments,
                                    const ThresholdOptions& thresholds, std::vector<FileArgument> inputs) {
    for (const auto& typed_files : {state_arguments.files(), thresholds.files()})
        inputs.insert(inputs.end(), typed_files.begin(), typed_files.end());
    if (typed.compare) inputs.push_back({"--compare", *typed.compare});
    if (typed.lesson) add_file_if_there(inputs, "--lesson", *typed.lesson);
    return inputs;
}

/// Refuses a picture that labels of a readable size would mostly cover.
void check_room_for_labels(const Options& options, const PictureRequest& picture) {
    const glm::dvec2 least_px = glm::ceil(glm::dvec2(480.0, 270.0) * (picture.dpi / usual_dpi));
    if (glm::all(glm::greaterThanEqual(glm::dvec2(picture.size_px), least_px))) return;
    options.refuse("--labels: at " + shortest_number(picture.dpi) + " dpi, the picture needs at least " +
                   std::to_string(std::lround(least_px.x)) + "x" + std::to_string(std::lround(least_px.y)) +
                   " pixels, or its labels would cover it");
}

SnapshotWish checked(const Options& options, const TypedSnapshot& typed, const ThresholdOptions& thresholds,
                     const StateArguments& state_arguments) {
    if (!typed.output && !typed.compare) options.refuse("-o OUT.png or --compare REF.png is required");
    if (thresholds.given() && !typed.compare)
        options.refuse("--profile, --worst, --share and --mask need --compare REF.png");
    if (typed.diff && !typed.compare) options.refuse("--diff needs --compare REF.png");

    SnapshotWish wish;
    const std::size_t view = choice_option(options, "--view", typed.view.value_or("window"), picture_view_names);
    wish.view = picture_view_names[view];
    wish.picture.view = static_cast<PictureView>(view);
    wish.picture.size_px = size_option(options, typed.size);
    check_size(options, wish.picture);
    wish.picture.labels = typed.labels;
    wish.picture.transparent = typed.transparent;
    if (typed.labels && wish.picture.view != PictureView::camera) options.refuse("--labels needs --view camera");
    if (typed.dpi) wish.picture.dpi = number_option(options, "--dpi", *typed.dpi, 24.0, 1200.0);
    if (typed.labels) check_room_for_labels(options, wish.picture);
    wish.picture.samples = samples_option(options, typed.samples);
    const bool wants_lesson = typed.step || typed.revealed || typed.ends;
    if (wants_lesson && !typed.lesson && !state_arguments.linked_step())
        options.refuse("--step, --revealed and --end need --lesson");
    if (typed.code && !typed.presents) options.refuse("--code needs --present");
    wish.picture.presents = typed.presents;
    if (typed.repeat) wish.repeat = whole_option(options, "--repeat", *typed.repeat, 1, 1000);
    if (typed.compare == "") options.refuse("--compare: must be the name of a PNG file, got an empty string");
    wish.is_vector = typed.output && is_vector_name(*typed.output);
    if (wish.is_vector && (typed.compare || typed.repeat || typed.fail_if_blank))
        options.refuse("--compare, --repeat and --fail-if-blank need a picture of pixels: -o OUT.png");
    wish.is_numbers = typed.output && is_depth_file_name(*typed.output) &&
                      (wish.picture.view == PictureView::depth || !is_png_name(*typed.output));
    if (wish.is_numbers && wish.picture.view != PictureView::depth)
        options.refuse("-o: .npy and .pfm hold depths, which need --view depth");
    if (typed.output && !wish.is_vector && !wish.is_numbers)
        check_picture_name(options, "-o", *typed.output, ".png, .svg or .pdf, or, with --view depth, in .npy or .pfm");
    if (typed.diff) check_picture_name(options, "--diff", *typed.diff);
    return wish;
}

/// Returns the step that the options name, or the one that STATE links to.
std::optional<LinkedStep> step_of(const Options& options, const TypedSnapshot& typed,
                                  const StateArguments& state_arguments) {
    std::optional<LinkedStep> linked = typed.exercise ? std::nullopt : state_arguments.linked_step();
    if (linked && (typed.lesson || typed.step)) options.refuse("STATE already links to a lesson's step");
    if (!typed.lesson) return linked;
    return lesson_step(options, *typed.lesson, typed.step);
}

/// Returns the state at the start of a student's exercise, with the question; or, if STATE is a hand-in, the state at
/// the exercise's end.
LoadedState take_exercise(const Options& options, const TypedSnapshot& typed, const StateArguments& arguments,
                          SnapshotWish& wish) {
    if (typed.lesson) options.refuse("--lesson and --exercise cannot be combined");
    HandIn hand_in{.program = {},
                   .course = typed.course.value_or(""),
                   .student = typed.student.value_or(""),
                   .name = {},
                   .items = {}};
    const std::string& file = arguments.as_typed();
    if (!file.empty()) {
        if (typed.student || typed.course)
            options.refuse(
                "--student and --course cannot be given with a hand-in, which STATE is here and which names both");
        hand_in = value_or_end(load_hand_in(file));
    }
    const UiParams looks = arguments.looks();
    Headless headless(device_option(options, typed.device));
    ExercisePicture shown = value_or_end(exercise_picture(hand_in, *typed.exercise, headless.renderer()));
    headless.require_no_errors();
    LoadedState state = show_step({std::move(shown.lesson), 0, false, false, true}, wish.picture);
    if (!file.empty()) wish.picture.lesson = nullptr;  // at the end, there is no question to show
    state.params = shown.params;
    state.params.ui = looks;
    return state;
}

Drawn draw_once(const SnapshotWish& wish, const LoadedState& state, const Scene& scene, bool is_last) {
    auto headless = std::make_unique<Headless>(wish.device);
    const auto drawn = [&](auto draw) {
        return headless->drawn(draw(headless->renderer(), state, scene, wish.picture),
                               status_of_trouble(wish.picture.view));
    };
    Drawn result;
    if (wish.is_vector)
        result.picture.drawing = drawn(draw_figure);
    else
        result.picture.image = drawn(draw_picture);
    if (wish.is_numbers)
        result.picture.depths =
            headless->drawn(depth_image(headless->renderer(), state.params, scene, wish.picture.size_px));
    const gl::ContextFacts facts = gl::context_facts();
    result.device = headless->context().description();
    result.renderer = facts.renderer;
    result.gl_version = facts.version;
    if (is_last) Headless::keep_to_the_end(std::move(headless));
    return result;
}

Drawn draw(const SnapshotWish& wish, const LoadedState& state, const Scene& scene) {
    Drawn first = draw_once(wish, state, scene, wish.repeat == 1);
    for (int i = 2; i <= wish.repeat; ++i) {
        const Drawn again = draw_once(wish, state, scene, i == wish.repeat);
        if (again.picture.image == first.picture.image) continue;
        const CompareReport report = compare_images(again.picture.image, first.picture.image, {0, 0.0});
        throw Failure(ExitStatus::not_repeatable, "not repeatable: drawing " + std::to_string(i) + " of " +
                                                      std::to_string(wish.repeat) +
                                                      " differs from the first: " + sentence(report));
    }
    return first;
}

int samples_of(const SnapshotWish& wish, const Params& params) {
    const bool is_buffer = wish.picture.view == PictureView::depth || wish.picture.view == PictureView::stencil;
    return is_buffer ? 0 : wish.picture.samples.value_or(params.view.samples);
}

/// Adds the request to the report, and null for facts that are not known yet.
void tell_typed(EndingReport& report, const TypedSnapshot& typed, const StateArguments& state,
                const ThresholdOptions& thresholds) {
    report.tell("state", state.as_typed().empty() ? Json() : name_as_json(state.as_typed()));
    report.tell("output", name_as_json(typed.output));
    for (const char* const name : {"view", "size", "samples", "repeat", "device", "renderer", "gl_version", "blank"})
        report.tell(name, Json());
    report.tell("problems", Json());
    report.tell("reference", name_as_json(typed.compare));
    report.tell("masks", thresholds.masks_as_json());
    report.tell("diff", name_as_json(typed.diff));
    report.tell("compare", Json());
}

void tell_wish(EndingReport& report, const SnapshotWish& wish, const Params& params) {
    report.tell("view", wish.view);
    report.tell("size", as_json(wish.picture.size_px));
    report.tell("samples", samples_of(wish, params));
    report.tell("repeat", wish.repeat);
}

void tell_drawn(EndingReport& report, const Drawn& drawn) {
    report.tell("device", drawn.device);
    report.tell("renderer", drawn.renderer);
    report.tell("gl_version", drawn.gl_version);
    report.tell("blank", drawn.picture.is_blank());
}

/// Returns the state to show: that of a lesson's step or of an exercise, or STATE.
LoadedState state_of(const Options& options, const TypedSnapshot& typed, const StateArguments& state_arguments,
                     SnapshotWish& wish) {
    LoadedState state;
    if (typed.exercise)
        state = take_exercise(options, typed, state_arguments, wish);
    else if (typed.student || typed.course)
        options.refuse("--student and --course need --exercise");
    else
        state = state_arguments.load();
    if (std::optional<LinkedStep> step = step_of(options, typed, state_arguments)) {
        if (!state_arguments.say_only_looks())
            options.refuse(
                "--lesson: a step has its own state, so STATE and --mesh are not allowed and --set takes only ui.… "
                "fields");
        const UiParams looks = state.params.ui;
        if (typed.ends && !LessonRun(step->lesson, step->step).end())
            options.refuse("--end: no card follows this step; give the --step that ends a lesson");
        const std::string code = typed.code ? address_option(options, "--code", typed.code) : "";
        state = show_step({std::move(step->lesson), step->step, typed.revealed, false, true, code, typed.ends},
                          wish.picture);
        state.params.ui = looks;
    }
    return state;
}

/// Draws the picture and writes the results. As the files of the state's scene become known, collects them in
/// `scene_files`, since none of them may be overwritten.
ExitStatus take(const Options& options, const TypedSnapshot& typed, const StateArguments& state_arguments,
                const ThresholdOptions& thresholds, std::vector<FileArgument>& scene_files, EndingReport& report) {
    report.begin();
    SnapshotWish wish = checked(options, typed, thresholds, state_arguments);
    std::optional<Reference> reference;
    if (typed.compare) reference.emplace(*typed.compare, thresholds, wish.picture.size_px);
    const LoadedState state = state_of(options, typed, state_arguments, wish);
    scene_files = files_of(state);
    report.begin();
    const Scene scene = scene_of(state);
    scene_files = files_of(scene);
    report.begin();
    tell_wish(report, wish, state.params);
    const Derived derived = derive(state.params, scene, Viewport{wish.picture.size_px});
    value_or_end(check_finite(derived), ExitStatus::nan_or_blank);
    refuse_beyond_budget(state.params, derived, scene, wish.picture.size_px);
    if (typed.json)
        report.tell("problems", as_json(find_problems(state.params, derived, scene, plan(state.params, derived))));

    wish.device = device_option(options, typed.device);
    const Drawn drawn = draw(wish, state, scene);
    tell_drawn(report, drawn);
    if (typed.fail_if_blank && drawn.picture.is_blank())
        throw Failure(ExitStatus::nan_or_blank, "the picture is blank: all pixels have the same color");

    Outputs outputs;
    if (typed.output)
        outputs.add(*typed.output, picture_file(*typed.output, drawn.picture,
                                                {wish.picture.dpi, "viewing-sandbox: " + wish.view,
                                                 carried_state(drawn_params(state.params, wish.picture))}));
    if (reference) reference->hold_against(drawn.picture.image, typed.diff, outputs, report);
    const ExitStatus status = reference ? reference->status() : ExitStatus::done;
    report.finish(outputs, status, reference ? reference->told() : "");
    if (reference) reference->tell(typed.output == "-" || typed.diff == "-" || typed.json == "-");
    return status;
}

ExitStatus run_snapshot(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    TypedSnapshot typed;
    declare(options, typed);
    const ThresholdOptions thresholds(options);
    options.text("--json", "FILE|-", typed.json, ending_report_help);
    std::vector<FileArgument> scene_files;
    EndingReport report(self, options, typed.json, [&] {
        return NamedFiles{outputs_of(typed), inputs_of(typed, state_arguments, thresholds, scene_files)};
    });
    return report.guard([&] {
        if (!options.parse(arguments)) return ExitStatus::done;
        tell_typed(report, typed, state_arguments, thresholds);
        return take(options, typed, state_arguments, thresholds, scene_files, report);
    });
}

}  // namespace

constinit const Command snapshot_command{
    "snapshot",
    "[STATE] [--set PATH=VALUE]… -o OUT.png [--view VIEW] [--size WxH] [OPTIONS]",
    "draws a state into a PNG file, without a display",
    "Draws one picture through EGL, without a display or X. The same state always gives a byte-identical file. GL's "
    "debug output is on, and an error ends the command with status 4. Unless the exit status is 0, 1 or 6, no file is "
    "touched except the report of --json.",
    "snapshot -o window.png\n"
    "snapshot mine.json --view camera --size 640x360 --samples 0 -o picture.png\n"
    "snapshot --set projection.near=0.001 --set depth.format=d16 --view depth -o depth.png\n"
    "snapshot --view camera --compare reference.png --worst 3 -o picture.png --json report.json\n"
    "snapshot --view camera --compare reference.png --profile portable --mask 0,0,120,40 --diff difference.png\n"
    "snapshot --view depth -o depth.npy\n"
    "snapshot bsp-walk --view tree --transparent -o tree.svg\n"
    "snapshot --exercise E16 --student 32201234 -o question.png\n"
    "snapshot --repeat 3 --fail-if-blank --timeout 60 -o picture.png",
    "0123456789",
    run_snapshot};

}  // namespace viewing
