// sweep: varies one or two fields of a state, or replays a recorded flight, and writes a film, a sheet, a folder of
// pictures, or a table of numbers. Each picture is the same as the one that snapshot draws.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/picture.h"
#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/contact_sheet.h"
#include "cli/results/csv.h"
#include "cli/results/sweep_result.h"
#include "cli/state_arguments.h"
#include "frame/finite.h"
#include "grading/lesson_numbers.h"
#include "image/image_size.h"
#include "platform/file.h"
#include "platform/unfinished.h"
#include "platform/whole_folder.h"
#include "state/file/flight.h"
#include "state/file/state_json.h"
#include "state/file/variation.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr std::array ease_names{"linear", "smooth"};
constexpr std::array film_endings{".mp4", ".gif", ".webp"};

/// The options as typed.
struct TypedSweep {
    std::optional<std::string> output, csv, view, size, samples, fps, ease, columns, device;
    std::vector<std::string> vary, values;
    bool together = false, back = false;
};

enum class Kind { film, sheet, folder, nothing };

struct SweepPlan {
    std::vector<Variation> variations;
    Ease ease = Ease::linear;
    PictureRequest picture;
    Kind kind = Kind::nothing;
    std::string ending;
    double fps = 30.0;
    int columns = 1;
};

void declare(Options& options, TypedSweep& typed) {
    options.group("Sweep");
    options.texts("--vary", "PATH=FROM:TO:COUNT", typed.vary,
                  "Varies a field from one value to another in COUNT pictures; more values may come in between, evenly "
                  "spaced: light.position[0]=-3:3:61, camera.position=[0,1,8]:[4,3,5]:[0,6,0]:90. A second --vary "
                  "makes rows: each value of the first with each of the second");
    options.flag("--together", typed.together,
                 "Varies two fields in step, a picture for each pair; the counts must be equal");
    options.text("--ease", "linear|smooth", typed.ease, "smooth begins and ends at rest; default linear");
    options.flag("--back", typed.back, "Adds the way back, so that a looping film does not jump");
    options.group("Result");
    options.text("-o,--output", "OUT", typed.output,
                 ".mp4, .gif or .webp: a film (ffmpeg); .png: a sheet with each picture's values; a folder's name: a "
                 ".png for each; the folder must be new, empty or an earlier sweep's, and is replaced as a whole");
    options.text("--fps", "N", typed.fps,
                 "Pictures per second of a film, 1 to 120; default 30. With a flight, also of a sheet, a folder or a "
                 "table, which otherwise have every recorded picture");
    options.text("--columns", "N", typed.columns,
                 "Columns of a sheet; default: the second field's count, else a square");
    options.text("--csv", "FILE|-", typed.csv, "Writes a row for each picture: its values, and those of --value");
    options.texts("--value", "EXPRESSION", typed.values,
                  "Adds a column to the table, an expression as in lessons (viewing-sandbox lesson --names), for "
                  "pictures of --size: S[0][3], facts.plane_dot_light, fighting().wrong_fraction");
    options.group("Picture");
    options.text("--view", "VIEW", typed.view, "A view as for snapshot; default camera");
    options.text("--size", "WxH", typed.size, size_help);
    options.text("--samples", "0|4", typed.samples, samples_help);
    add_device_option(options, typed.device);
}

[[noreturn]] void refuse_expression(const std::string& expression, const std::string& why) {
    throw Failure(ExitStatus::bad_input, "--value " + one_line(expression) + ": " + why);
}

// ---- the request ---------------------------------------------------------------------------------------------------

/// Refuses the name of a new folder that looks like a file's.
Kind kind_of(const Options& options, const std::string& output, std::string& ending) {
    if (output == "-") options.refuse("-o: a sweep cannot go to standard output; --csv - writes its table there");
    ending = in_lower_case(fs::path(output).extension().string());
    if (std::find(film_endings.begin(), film_endings.end(), ending) != film_endings.end()) return Kind::film;
    if (ending == ".png") return Kind::sheet;
    std::error_code error;
    if (!ending.empty() && !fs::is_directory(output, error))
        options.refuse("-o: must end in .png, " + joined(film_endings) +
                       ", or name a folder, without an ending, got \"" + one_line(output) + "\"");
    return Kind::folder;
}

/// Returns the outputs that are not a folder of pictures.
std::vector<FileArgument> outputs_of(const TypedSweep& typed, const SweepPlan& wish) {
    std::vector<FileArgument> outputs;
    if (typed.output && wish.kind != Kind::folder) outputs.push_back({"-o", *typed.output});
    if (typed.csv) outputs.push_back({"--csv", *typed.csv});
    return outputs;
}

/// Refuses an output that is also an input or another output. Also refuses a picture folder that contains an input or
/// another output, since the whole folder is replaced.
void keep_apart(const Options& options, const TypedSweep& typed, const SweepPlan& wish,
                std::vector<FileArgument> inputs) {
    check_apart(options, outputs_of(typed, wish), inputs);
    if (wish.kind != Kind::folder) return;
    if (typed.csv) inputs.push_back({"--csv", *typed.csv});
    for (const FileArgument& input : inputs)
        if (input.file != "-" && are_same_file(folder_of(input.file), *typed.output))
            options.refuse("-o: the whole folder would be replaced, and " + input.option +
                           " is in it: " + one_line(input.file));
    value_or_end(check_folder_free(*typed.output, is_sweep_picture));
}

/// Checks that there is something to vary: a flight varies by itself, but any other state needs a field.
void check_way(const Options& options, const TypedSweep& typed, bool is_flight) {
    if (!is_flight && (typed.vary.empty() || typed.vary.size() > 2))
        options.refuse("--vary PATH=FROM:TO:COUNT is required once or twice; only a flight needs none");
    if (is_flight && !typed.vary.empty())
        options.refuse("--vary: STATE is a flight, which varies by itself; use --at SECONDS to vary one picture of it");
    if (is_flight && (typed.ease || typed.back)) options.refuse("--ease and --back need --vary; STATE is a flight");
}

/// Refuses two variations of the same field, or of a field and one of its parts: one would undo the other.
void check_fields_differ(const Options& options, const std::vector<Variation>& variations) {
    if (variations.size() < 2) return;
    const std::string &a = variations[0].path, &b = variations[1].path;
    const std::string &whole = a.size() < b.size() ? a : b, &part = a.size() < b.size() ? b : a;
    if (part.starts_with(whole) &&
        (part.size() == whole.size() || part[whole.size()] == '[' || part[whole.size()] == '.'))
        options.refuse("--vary: " + one_line(a) + " and " + one_line(b) + " overlap: vary two different fields");
}

SweepPlan checked(const Options& options, const TypedSweep& typed, bool is_flight) {
    SweepPlan wish;
    check_way(options, typed, is_flight);
    for (const std::string& text : typed.vary) wish.variations.push_back(value_or_end(Variation::parse(text)));
    check_fields_differ(options, wish.variations);
    if (typed.together && wish.variations.size() != 2) options.refuse("--together needs two --vary");
    if (typed.together && wish.variations[0].count != wish.variations[1].count)
        options.refuse("--together: the two fields have " + std::to_string(wish.variations[0].count) + " and " +
                       std::to_string(wish.variations[1].count) + " pictures; the counts must be equal");
    if (!typed.output && !typed.csv) options.refuse("-o OUT or --csv FILE is required");
    if (!typed.csv && !typed.values.empty()) options.refuse("--value needs --csv FILE");
    for (const std::string& expression : typed.values)
        if (const Status fine = check_expression(expression); !fine) refuse_expression(expression, fine.error());
    wish.ease = static_cast<Ease>(choice_option(options, "--ease", typed.ease.value_or("linear"), ease_names));
    wish.picture.view =
        static_cast<PictureView>(choice_option(options, "--view", typed.view.value_or("camera"), picture_view_names));
    wish.picture.size_px = size_option(options, typed.size);
    check_size(options, wish.picture);
    wish.picture.samples = samples_option(options, typed.samples);
    if (typed.output) wish.kind = kind_of(options, *typed.output, wish.ending);
    if (wish.kind != Kind::film && typed.fps && !is_flight) options.refuse("--fps needs a film: .mp4, .gif or .webp");
    if (wish.kind != Kind::sheet && typed.columns) options.refuse("--columns needs a sheet: .png");
    if (typed.fps) wish.fps = number_option(options, "--fps", *typed.fps, 1.0, 120.0);
    const glm::ivec2 size_px = wish.picture.size_px;
    if (wish.ending == ".mp4" && (size_px.x % 2 != 0 || size_px.y % 2 != 0))
        options.refuse("--size: an .mp4 needs an even width and height; a .webp takes any");
    check_outputs(options, outputs_of(typed, wish));
    return wish;
}

/// One picture of a sweep: the settings of a variation; or, for a flight, the time as "t=0.5" and the index of the
/// recorded picture.
struct Stop {
    std::vector<std::string> settings;
    std::size_t of_flight = 0;
};

/// Returns the number of pictures in a variation, which may exceed the limit.
std::int64_t count_of(const SweepPlan& wish, bool together, bool back) {
    std::int64_t count = wish.variations.front().count;
    if (wish.variations.size() == 2 && !together) count *= wish.variations.back().count;
    return back && count > 2 ? 2 * count - 2 : count;
}

/// Returns the stops of a variation, in order.
std::vector<Stop> stops_of(const SweepPlan& wish, bool together, bool back) {
    std::vector<Stop> all;
    const Variation& first = wish.variations.front();
    for (int i = 0; i < first.count; ++i) {
        const std::string setting = first.setting(i, wish.ease);
        if (wish.variations.size() == 1) {
            all.push_back({{setting}});
            continue;
        }
        const Variation& second = wish.variations.back();
        for (int k = together ? i : 0; k < (together ? i + 1 : second.count); ++k)
            all.push_back({{setting, second.setting(k, wish.ease)}});
    }
    if (back)
        for (std::size_t i = all.size() - 1; i-- > 1;) all.push_back(all[i]);
    return all;
}

/// Returns the stops of a flight: all recorded pictures or, if `fps` is given, those shown at k / fps seconds.
std::vector<Stop> stops_of(const Flight& flight, std::optional<double> fps) {
    std::vector<Stop> all;
    const auto add = [&all](double t_s, std::size_t picture) {
        all.push_back({{"t=" + shortest_number(t_s)}, picture});
    };
    if (!fps)
        for (std::size_t i = 0; i < flight.picture_count(); ++i) add(flight.time_s(i), i);
    else  // collects at most one more than the limit
        for (int k = 0; k / *fps <= flight.seconds && k <= Variation::most_frames; ++k)
            add(k / *fps, flight.picture_at(k / *fps));
    return all;
}

// ---- pictures and numbers ------------------------------------------------------------------------------------------

/// Produces the state of each picture; reloads the scene only when it changes.
class Steps {
public:
    Steps(LoadedState state, const std::vector<Stop>& stops)
        : state_(std::move(state)), stops_(stops), scene_(scene_of(state_)), loaded_(state_.params) {
        if (state_.flight) walk_.emplace(state_.flight);
    }

    std::size_t count() const { return stops_.size(); }
    const std::vector<std::string>& settings(std::size_t index) const { return stops_[index].settings; }
    const Scene& scene() const { return scene_; }

    LoadedState at(std::size_t index) {
        LoadedState state = state_;
        const Stop& stop = stops_[index];
        state.params =
            value_or_end(walk_ ? walk_->at(stop.of_flight) : apply_settings(state.params, stop.settings, "--vary "));
        if (!(state.params.scene == loaded_.scene && state.params.coplanar == loaded_.coplanar)) {
            if (!walk_ && state.params.scene != state_.params.scene) state.scene_origin = "--vary scene";
            scene_ = scene_of(state);
            loaded_ = state.params;
        }
        return state;
    }

private:
    LoadedState state_;
    const std::vector<Stop>& stops_;
    std::optional<FlightWalk> walk_;
    Scene scene_;
    Params loaded_;  ///< the parameters whose scene is loaded
};

/// Prints a list with the numbers in their shortest form, as in --vary: 5, not 5.0.
std::string inner(const Json& value) {
    if (value.is_number()) return shortest_number(value.get<double>());
    if (!value.is_array()) return value.dump();
    std::string text;
    for (const Json& one : value) text += (text.empty() ? "" : ",") + inner(one);
    return "[" + text + "]";
}

std::string cell(const Json& value) {
    if (value.is_null()) return "";
    if (value.is_number()) return std::isnan(value.get<double>()) ? "nan" : shortest_number(value.get<double>());
    return csv_quoted(value.is_string() ? value.get<std::string>() : inner(value));
}

std::string head(const TypedSweep& typed, const SweepPlan& wish) {
    std::string line;
    if (wish.variations.empty()) line = "t";
    for (const Variation& variation : wish.variations) line += (line.empty() ? "" : ",") + csv_quoted(variation.path);
    for (const std::string& expression : typed.values) line += "," + csv_quoted(expression);
    return line + "\n";
}

std::string row(const TypedSweep& typed, const std::vector<std::string>& settings, const LoadedState& state,
                const LoadedState& start, const Scene& scene, Renderer& renderer, glm::ivec2 size_px) {
    std::string line;
    for (const std::string& setting : settings)
        line += (line.empty() ? "" : ",") + csv_quoted(setting.substr(setting.find('=') + 1));
    LessonNumbers numbers(state.params, start.params, scene, &renderer, size_px);
    for (const std::string& expression : typed.values) {
        const Result<Json> value = evaluate(expression, numbers.surroundings());
        if (!value) refuse_expression(expression, value.error());
        line += "," + cell(*value);
    }
    return line + "\n";
}

int columns_of(const Options& options, const TypedSweep& typed, const SweepPlan& wish, std::size_t count) {
    if (typed.columns) return whole_option(options, "--columns", *typed.columns, 1, 1000);
    if (wish.variations.size() == 2 && !typed.together && !typed.back) return wish.variations.back().count;
    return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
}

/// Returns the stops of the whole sweep, within the limit.
std::vector<Stop> checked_stops(const Options& options, const TypedSweep& typed, const SweepPlan& wish,
                                const Flight* flight) {
    if (!flight) {
        if (const std::int64_t count = count_of(wish, typed.together, typed.back); count > Variation::most_frames)
            options.refuse("--vary: " + std::to_string(count) + " pictures exceed the limit of " +
                           std::to_string(Variation::most_frames));
        return stops_of(wish, typed.together, typed.back);
    }
    const bool resamples = typed.fps || wish.kind == Kind::film;
    std::vector<Stop> stops = stops_of(*flight, resamples ? std::optional(wish.fps) : std::nullopt);
    if (stops.size() > static_cast<std::size_t>(Variation::most_frames))
        options.refuse("--fps: at this rate the flight of " + shortest_number(flight->seconds) + " s has more than " +
                       std::to_string(Variation::most_frames) + " pictures");
    return stops;
}

/// Sets the sheet's columns, and refuses a sheet that would be too large.
void check_sheet(const Options& options, const TypedSweep& typed, SweepPlan& wish, std::size_t count) {
    if (wish.kind != Kind::sheet) return;
    wish.columns = columns_of(options, typed, wish, count);
    const glm::ivec2 sheet_px = contact_sheet_size_px(wish.picture.size_px, static_cast<int>(count), wish.columns);
    if (!is_image_size(sheet_px.x, sheet_px.y, most_image_pixels))
        options.refuse("--size: the sheet would be " + std::to_string(sheet_px.x) + " × " + std::to_string(sheet_px.y) +
                       " pixels; " + image_size_rule(most_image_pixels));
}

/// Reports what is wrong with any picture before the first one is drawn.
void check_pictures(const Options& options, const TypedSweep& typed, const SweepPlan& wish, Steps& steps) {
    std::vector<fs::path> read;
    for (std::size_t i = 0; i < steps.count(); ++i) {
        const LoadedState state = steps.at(i);
        if (steps.scene().read != read) {
            read = steps.scene().read;
            keep_apart(options, typed, wish, files_of(steps.scene()));
        }
        const Derived derived = derive(state.params, steps.scene(), Viewport{wish.picture.size_px});
        if (wish.kind != Kind::nothing) value_or_end(check_finite(derived), ExitStatus::nan_or_blank);
        refuse_beyond_budget(state.params, derived, steps.scene(), wish.picture.size_px);
    }
}

/// Returns what takes the pictures; null if only numbers are written.
std::unique_ptr<SweepResult> begin_result(const TypedSweep& typed, const SweepPlan& wish, std::size_t count) {
    switch (wish.kind) {
        case Kind::film:
            return begin_film(*typed.output, wish.ending, wish.picture.size_px, wish.fps);
        case Kind::folder:
            return begin_folder(*typed.output, wish.picture, count);
        case Kind::sheet:
            return begin_sheet(*typed.output, wish.columns);
        case Kind::nothing:
            break;
    }
    return nullptr;
}

ExitStatus run_sweep(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    TypedSweep typed;
    declare(options, typed);
    if (!options.parse(arguments)) return ExitStatus::done;
    const LoadedState start = state_arguments.load();
    SweepPlan wish = checked(options, typed, start.flight != nullptr);
    const std::vector<Stop> stops = checked_stops(options, typed, wish, start.flight.get());
    check_sheet(options, typed, wish, stops.size());
    keep_apart(options, typed, wish, state_arguments.files());
    Steps steps(start, stops);
    check_pictures(options, typed, wish, steps);

    Headless headless(device_option(options, typed.device));
    const std::unique_ptr<SweepResult> result = begin_result(typed, wish, steps.count());
    std::string table = head(typed, wish);
    std::optional<Params> drawn;  // the parameters that `image` shows
    Image image;
    for (std::size_t i = 0; i < steps.count(); ++i) {
        const LoadedState state = steps.at(i);
        if (typed.csv)
            table +=
                row(typed, steps.settings(i), state, start, steps.scene(), headless.renderer(), wish.picture.size_px);
        if (!result) continue;
        if (drawn != state.params)
            image = headless.drawn(draw_picture(headless.renderer(), state, steps.scene(), wish.picture),
                                   status_of_trouble(wish.picture.view));
        drawn = state.params;
        result->add(image, state.params, steps.settings(i));
    }
    headless.require_no_errors();
    Outputs outputs;
    if (result) result->finish(outputs);
    if (typed.csv) outputs.add(*typed.csv, table);
    outputs.write();
    return ExitStatus::done;
}

}  // namespace

constinit const Command sweep_command{
    "sweep",
    "[STATE] --vary PATH=FROM:TO:COUNT [--vary …] | FLIGHT.json -o OUT.mp4|gif|webp|png|DIR [OPTIONS]",
    "varies a field, or replays a flight: a film, a sheet of pictures, a table",
    "Every picture is the one that snapshot draws of the state with that value. Numbers and lists of numbers change "
    "evenly from value to value; everything else (a format, a name) stays until the next value. With two fields a "
    "sheet has a row for each value of the first and a column for each of the second. A flight (F9 in the window) "
    "needs no --vary: a folder, a sheet or a table has a picture for its start and for each recorded change; a film "
    "shows the screen at each time. Films are encoded by ffmpeg, if it is installed.",
    "sweep --vary light.position[0]=-3:3:61 -o light.mp4 --ease smooth --back\n"
    "sweep depth-fighting --vary projection.near=0.01:1:9 --size 320x180 -o near.png\n"
    "sweep --vary light.position[1]=1:6:4 --vary shadow.opacity=0.25:1:4 --size 320x180 -o sheet.png\n"
    "sweep --vary light.position[1]=1:6:6 --csv table.csv --value S[0][0] --value facts.plane_dot_light\n"
    "sweep --vary camera.position=[3.9,3,6.6]:[0,3,7]:[-4,2,6]:90 -o frames\n"
    "sweep flight-20260301-101500.json -o flight.mp4",
    "0234589",
    run_sweep};

}  // namespace viewing
