// snapshot: a picture of a state into a PNG file, without a display. Bad input is refused before GL is touched.
// What is drawn is app/picture.h; read headless.h for the context.
#include <array>
#include <cmath>

#include "app/picture.h"
#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "cli/thresholds.h"
#include "cli/values.h"
#include "gl/facts.h"
#include "image/png.h"
#include "report/as_json.h"
#include "report/exercise_picture.h"
#include "state/json.h"

namespace viewing {
namespace {

constexpr glm::ivec2 smallest_window_px{320, 240};

/// The options as they were typed.
struct Typed {
    std::optional<std::string> output, view, size, samples, device, repeat, compare, diff, json;
    std::optional<std::string> lesson, step, exercise, student, course;
    bool fail_if_blank = false, revealed = false, presents = false;
};

/// The same, checked.
struct Wish {
    PictureRequest picture;
    std::string view;
    std::string device;
    int repeat = 1;
    CompareOptions limits;
    Mask mask;
};

/// What was drawn, and by whom.
struct Drawn {
    Image image;
    std::string device, renderer, gl_version;
};

void declare(Options& options, Typed& typed) {
    options.group("Picture");
    options.text("-o,--output", "OUT.png", typed.output, "The file to write; - for standard output");
    options.text("--view", "VIEW", typed.view,
                 "window (default): everything as on screen; camera: the picture alone; depth, stencil: the camera's "
                 "buffers made visible; observer: the scene from outside");
    options.text("--size", "WxH", typed.size, size_help);
    options.text("--samples", "0|4", typed.samples, samples_help);
    add_device_option(options, typed.device);
    options.group("Lesson");
    options.text("--lesson", "ID|FILE", typed.lesson,
                 "A step of a lesson in place of STATE (viewing-sandbox lesson --list)");
    options.text("--step", "N", typed.step, "Which one, counted from 1; default 1");
    options.flag("--revealed", typed.revealed, "After its answer");
    options.flag("--present", typed.presents, "As a room sees it");
    options.group("Exercise");
    options.text("--exercise", "ID", typed.exercise,
                 "In place of STATE: how an exercise begins for --student, or with a hand-in as STATE how it ended");
    options.text("--student", "ID", typed.student, "Whose variant; left out, nobody's");
    options.text("--course", "C", typed.course, "Of the student");
    options.group("Checks");
    options.text("--repeat", "N", typed.repeat,
                 "Draws N times, each in a new context; exit 7 unless all are byte-equal");
    options.flag("--fail-if-blank", typed.fail_if_blank, "Exit 5 when all pixels have the same colour");
    options.text(
        "--compare", "REF.png", typed.compare,
        "Compares with a reference: exit 1 when different, 6 when there is none; the picture is written all the same");
    options.text("--diff", "D.png", typed.diff, "Writes the picture of the differences from it, as compare -o does");
}

std::vector<FileArgument> outputs_of(const Typed& typed) {
    std::vector<FileArgument> outputs;
    if (typed.output) outputs.push_back({"-o", *typed.output});
    if (typed.diff) outputs.push_back({"--diff", *typed.diff});
    if (typed.json) outputs.push_back({"--json", *typed.json});
    return outputs;
}

std::vector<FileArgument> inputs_of(const Typed& typed, const StateArguments& state_arguments,
                                    const ThresholdOptions& thresholds) {
    std::vector<FileArgument> inputs = state_arguments.files();
    for (const FileArgument& mask : thresholds.files()) inputs.push_back(mask);
    if (typed.compare) inputs.push_back({"--compare", *typed.compare});
    if (typed.lesson) add_file_if_there(inputs, "--lesson", *typed.lesson);
    return inputs;
}

Wish checked(const Options& options, const Typed& typed, const ThresholdOptions& thresholds) {
    if (!typed.output && !typed.compare) options.refuse("-o OUT.png is missing (or --compare REF.png)");
    if (thresholds.given() && !typed.compare)
        options.refuse("--profile, --worst, --share and --mask need --compare REF.png");
    if (typed.diff && !typed.compare) options.refuse("--diff needs --compare REF.png");

    Wish wish;
    const std::size_t view = choice_option(options, "--view", typed.view.value_or("window"), picture_view_names);
    wish.view = picture_view_names[view];
    wish.picture.view = static_cast<PictureView>(view);
    wish.picture.size_px = size_option(options, typed.size);
    const glm::ivec2 size_px = wish.picture.size_px;
    if (wish.picture.view == PictureView::window &&
        (size_px.x < smallest_window_px.x || size_px.y < smallest_window_px.y))
        options.refuse("--size: the window has at least 320x240 pixels; --view camera can be smaller");
    wish.picture.samples = samples_option(options, typed.samples);
    if (!typed.lesson && (typed.step || typed.revealed || typed.presents))
        options.refuse("--step, --revealed and --present need --lesson");
    if (typed.repeat) wish.repeat = whole_option(options, "--repeat", *typed.repeat, 1, 1000);
    wish.limits = thresholds.values();
    if (typed.compare == "") options.refuse("--compare: must be the name of a PNG file, got an empty text");
    if (typed.output) check_picture_name(options, "-o", *typed.output);
    if (typed.diff) check_picture_name(options, "--diff", *typed.diff);
    return wish;
}

/// The state of the step, and for a picture of the window the lesson itself.
LoadedState take_step(const Options& options, const Typed& typed, Wish& wish) {
    LessonPicture picture{value_or_end(load_lesson(*typed.lesson)), 0, typed.revealed, typed.presents, true};
    const int count = static_cast<int>(picture.lesson.steps.size());
    const int number = typed.step ? whole_option(options, "--step", *typed.step, 1, count) : 1;
    picture.step = static_cast<std::size_t>(number - 1);
    return show_step(std::move(picture), wish.picture);
}

/// The state of a student's exercise with its question, or of its end where a hand-in stands for STATE.
LoadedState take_exercise(const Options& options, const Typed& typed, const StateArguments& arguments, Wish& wish) {
    if (typed.lesson) options.refuse("--lesson and --exercise cannot both be");
    HandIn hand_in{.program = {},
                   .course = typed.course.value_or(""),
                   .student = typed.student.value_or(""),
                   .name = {},
                   .items = {}};
    const std::string file = arguments.as_typed();
    if (!file.empty()) {
        if (typed.student || typed.course) options.refuse("a hand-in says itself whose it is");
        hand_in = value_or_end(load_hand_in(file));
    }
    const UiParams looks = arguments.looks();
    Headless headless(device_option(options, typed.device));
    ExercisePicture shown = value_or_end(exercise_picture(hand_in, *typed.exercise, headless.renderer()));
    headless.require_no_errors();
    LoadedState state = show_step({std::move(shown.lesson), 0, false, false, true}, wish.picture);
    if (!file.empty()) wish.picture.lesson = nullptr;  // how it ended has no question
    state.params = shown.params;
    state.params.ui = looks;
    return state;
}

/// None when the file is not there; one that cannot be read or is no PNG is bad input.
std::optional<Image> reference(const std::string& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return std::nullopt;
    return value_or_end(read_png(file));
}

/// Pixels of 8 bits hold no NaN, so it is looked for where it would come from: in what is uploaded, as floats.
bool is_finite(const glm::dmat4& matrix) {
    for (glm::length_t column = 0; column < 4; ++column)
        for (glm::length_t row = 0; row < 4; ++row)
            if (!std::isfinite(static_cast<float>(matrix[column][row]))) return false;
    return true;
}

void refuse_nan(const Derived& derived) {
    const auto refuse = [](const char* name, const glm::dmat4& matrix) {
        if (!is_finite(matrix))
            throw Failure(ExitStatus::nan_or_blank, std::string(name) + " has an entry that is not a finite number");
    };
    refuse("the projection", derived.clip_from_view);
    refuse("the view matrix", derived.view_from_world);
    for (const DerivedPlane& plane : derived.planes) {
        for (const CastShadow& cast : plane.shadows) refuse("the shadow matrix", cast.shadowed_world_from_world);
        refuse("the mirror matrix", plane.mirrored_world_from_world);
    }
}

bool is_blank(const Image& image) {
    for (std::size_t at = 4; at < image.rgba.size(); ++at)
        if (image.rgba[at] != image.rgba[at % 4]) return false;
    return true;
}

Drawn draw_once(const Wish& wish, const LoadedState& state, const Scene& scene) {
    Headless headless(wish.device);
    Image image = headless.drawn(draw_picture(headless.renderer(), state, scene, wish.picture));
    const gl::ContextFacts facts = gl::context_facts();
    return {std::move(image), headless.context().description(), facts.renderer, facts.version};
}

Drawn draw(const Wish& wish, const LoadedState& state, const Scene& scene) {
    Drawn first = draw_once(wish, state, scene);
    for (int i = 2; i <= wish.repeat; ++i) {
        const Drawn again = draw_once(wish, state, scene);
        if (again.image == first.image) continue;
        const CompareReport report = compare_images(again.image, first.image, {0, 0.0});
        throw Failure(ExitStatus::not_repeatable, "not repeatable: drawing " + std::to_string(i) + " of " +
                                                      std::to_string(wish.repeat) +
                                                      " is not the first one: " + sentence(report));
    }
    return first;
}

int samples_of(const Wish& wish, const Params& params) {
    const bool is_buffer = wish.picture.view == PictureView::depth || wish.picture.view == PictureView::stencil;
    return is_buffer ? 0 : wish.picture.samples.value_or(params.view.samples);
}

Json report_as_json(const Typed& typed, const Wish& wish, const Params& params, const Drawn& drawn,
                    const std::vector<Problem>& problems, const std::optional<CompareReport>& compared,
                    ExitStatus status) {
    return {{"status", static_cast<int>(status)},
            {"meaning", meaning(status)},
            {"output", typed.output ? Json(*typed.output) : Json()},
            {"view", wish.view},
            {"size", as_json(wish.picture.size_px)},
            {"samples", samples_of(wish, params)},
            {"repeat", wish.repeat},
            {"device", drawn.device},
            {"renderer", drawn.renderer},
            {"gl_version", drawn.gl_version},
            {"blank", is_blank(drawn.image)},
            {"problems", as_json(problems)},
            {"reference", typed.compare ? Json(*typed.compare) : Json()},
            {"compare", compared ? Json::parse(as_json(*compared)) : Json()}};
}

/// The comparison's sentence is a result, unless something else was asked for on standard output.
void tell(const Typed& typed, const std::optional<CompareReport>& compared) {
    if (!typed.compare) return;
    if (!compared) throw Failure(ExitStatus::reference_missing, *typed.compare + ": there is no such reference");
    if (typed.output != "-" && typed.diff != "-" && typed.json != "-")
        print(sentence(*compared) + "\n");
    else if (!compared->equal)
        throw Failure(ExitStatus::different, *typed.compare + ": " + sentence(*compared));
}

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    Typed typed;
    declare(options, typed);
    const ThresholdOptions thresholds(options);
    options.text("--json", "FILE|-", typed.json,
                 "Writes a report as JSON: what was drawn by whom, problems, the comparison");
    if (!options.parse(arguments)) return ExitStatus::done;

    Wish wish = checked(options, typed, thresholds);
    check_outputs(options, outputs_of(typed), inputs_of(typed, state_arguments, thresholds));
    wish.mask = value_or_end(mask_of(thresholds.mask(), wish.picture.size_px.x, wish.picture.size_px.y));
    const std::optional<Image> expected = typed.compare ? reference(*typed.compare) : std::nullopt;
    LoadedState state;
    if (typed.exercise)
        state = take_exercise(options, typed, state_arguments, wish);
    else if (typed.student || typed.course)
        options.refuse("--student and --course need --exercise");
    else
        state = state_arguments.load();
    if (typed.lesson) {
        if (!state_arguments.say_only_looks())
            options.refuse("--lesson: a step has its own state, so no STATE, no --mesh, and --set of ui.… alone");
        const UiParams looks = state.params.ui;
        state = take_step(options, typed, wish);
        state.params.ui = looks;
    }
    const Scene scene = scene_of(state);
    check_apart(options, outputs_of(typed), files_of(scene));
    const Derived derived = derive(state.params, scene, Viewport{wish.picture.size_px});
    refuse_nan(derived);
    refuse_beyond_budget(state.params, derived, scene, wish.picture.size_px);

    wish.device = device_option(options, typed.device);
    const Drawn drawn = draw(wish, state, scene);
    if (typed.fail_if_blank && is_blank(drawn.image))
        throw Failure(ExitStatus::nan_or_blank, "the picture is blank: all pixels have the same colour");

    Outputs outputs;
    if (typed.output)
        outputs.add(*typed.output, encode_png(drawn.image, write_state(drawn_params(state.params, wish.picture))));
    std::optional<CompareReport> compared;
    if (expected) compared = compare_images(drawn.image, *expected, wish.limits, wish.mask);
    if (expected && typed.diff)
        outputs.add(*typed.diff, encode_png(diff_picture(drawn.image, *expected, wish.limits, wish.mask)));
    const ExitStatus status = typed.compare && !expected     ? ExitStatus::reference_missing
                              : compared && !compared->equal ? ExitStatus::different
                                                             : ExitStatus::done;
    if (typed.json) {
        const std::vector<Problem> problems = find_problems(state.params, derived, scene, plan(state.params, derived));
        outputs.add(
            *typed.json,
            print_document(report_as_json(typed, wish, state.params, drawn, problems, compared, status)) + "\n");
    }
    outputs.write();
    tell(typed, compared);
    return status;
}

}  // namespace

constinit const Command snapshot_command{
    "snapshot",
    "[STATE] [--set PATH=VALUE]… -o OUT.png [--view VIEW] [--size WxH] [OPTIONS]",
    "a picture of a state into a PNG file, without a display",
    "Draws one picture through EGL alone: no display, no X. The same state gives a byte-equal file, always. Every "
    "picture is drawn under GL's debug output, and an error ends the command with exit 4. Unless the exit status is 0, "
    "1 or 6, no file is touched.",
    "snapshot -o window.png\n"
    "snapshot mine.json --view camera --size 640x360 --samples 0 -o picture.png\n"
    "snapshot --set projection.near=0.001 --set depth.format=d16 --view depth -o depth.png\n"
    "snapshot --view camera --compare reference.png --worst 3 -o picture.png --json report.json\n"
    "snapshot --view camera --compare reference.png --profile portable --mask 0,0,120,40 --diff difference.png\n"
    "snapshot --exercise E16 --student 32201234 -o question.png\n"
    "snapshot --repeat 3 --fail-if-blank --timeout 60 -o picture.png",
    "0123456789",
    run};

}  // namespace viewing
