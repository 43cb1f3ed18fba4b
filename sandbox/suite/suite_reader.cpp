// Reads suite files as strictly as states: every mistake is reported in one sentence that names the file and the field.
#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "image/image_size.h"
#include "lesson/tree.h"
#include "platform/file.h"
#include "state/file/form.h"
#include "state/file/schema.h"
#include "state/file/state_json.h"
#include "suite/results.h"
#include "suite/suite.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

using form::Object;
using Names = std::vector<std::string>;
using Measures = std::vector<SuiteMeasure>;

constexpr std::size_t most_suite_entries = 100'000, most_masks = 1'000;
constexpr int largest_worst = 255;
constexpr std::array measure_names{"fighting", "visibility", "mirror", "order"};
enum class Each { preset, fixed_preset, scene };
constexpr std::array each_names{"preset", "mended", "scene"};

template <typename T>
void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

// ---- settings ------------------------------------------------------------------------------------------------------

/// {"projection.near": 0.1, …} or ["projection.near=0.1", …].
form::Form<Names> set_form() {
    const auto has_value = [](const std::string& setting, const Where& where) {
        if (setting.find('=') == std::string::npos) where.refuse("must be PATH=VALUE");
    };
    const auto setting = form::name().then(has_value, {{"pattern", "="}});
    return form::either<Names>("an object of fields and their values, or a list of PATH=VALUE",
                               {form::settings(), form::list(setting, "a list of PATH=VALUE", {max_object_keys})});
}

form::Form<std::optional<int>> samples_form() {
    const char* const what = "0, 4 or \"state\" (the value of the state)";
    const auto read = [=](const Json& value, const Where& where) -> std::optional<int> {
        if (value == "state") return std::nullopt;
        if (value != 0 && value != 4) refuse_value(value, where, what);
        return value.get<int>();
    };
    return {what, {}, read, [](Json&) { return Json{{"enum", {0, 4, "state"}}}; }};
}

/// A rectangle [x, y, width, height], or the file name of a picture, relative to the suite's folder.
form::Form<MaskSource> mask_form(const fs::path& folder) {
    const auto place = form::whole(0, largest_image_side), side = form::whole(1, largest_image_side);
    const auto picture = [folder](const std::string& name) { return MaskSource{{}, {folder / name}}; };
    const auto rectangle = [](const std::vector<int>& at) { return MaskSource{{{at[0], at[1], at[2], at[3]}}, {}}; };
    return form::either<MaskSource>(
        "a picture's file, or [x, y, width, height]",
        {form::name().then(picture),
         form::list<int>({place, place, side, side}, "[x, y, width, height]", {4, 4, "must be [x, y, width, height]"})
             .then(rectangle)});
}

Object<SuiteMeasure> tolerance() {
    constexpr double most_tolerance = 1e9;
    return Object<SuiteMeasure>().optional("tolerance", form::number({0.0, most_tolerance}), &SuiteMeasure::tolerance);
}

form::Form<SuiteMeasure> measure_form() {
    const auto name = [](int index) { return std::string(measure_names[index]); };
    const auto what = form::choice(measure_names).then(name);
    return form::either<SuiteMeasure>(what.what + ", or an object with \"what\"",
                                      {what.then([](const std::string& named) { return SuiteMeasure{named}; }),
                                       tolerance().required("what", what, &SuiteMeasure::what).form()});
}

form::Form<Measures> measures_form() {
    const auto each_once = [](const Measures& all, const Where& where) {
        for (auto one = all.begin(); one != all.end(); ++one)
            if (std::any_of(all.begin(), one, [&](const SuiteMeasure& earlier) { return earlier.what == one->what; }))
                where.at(static_cast<std::size_t>(one - all.begin())).refuse("measures " + one->what + " twice");
    };
    return form::either<Measures>(
        "a measurement, or a list of measurements",
        {form::list(measure_form(), "a list of measurements, each once", {measure_names.size()}).then(each_once),
         measure_form().then([](const SuiteMeasure& one) { return Measures{one}; })});
}

form::Form<std::optional<double>> matrices_form() {
    return form::either<std::optional<double>>(
        "true, false or an object with \"tolerance\"",
        {form::boolean().then([](bool are_checked) { return are_checked ? std::optional(0.0) : std::nullopt; }),
         tolerance().form().then([](const SuiteMeasure& matrices) { return std::optional(matrices.tolerance); })});
}

form::Form<SuiteEntry> problems_form() {
    const auto can_be = [](const SuiteEntry& entry, const Where& where) {
        if (entry.allows_no_problem && !entry.wanted_problems.empty())
            where.key("none").refuse("cannot be true together with \"must\"");
    };
    return Object<SuiteEntry>()
        .optional("must", names_form(), &SuiteEntry::wanted_problems)
        .optional("must_not", names_form(), &SuiteEntry::unwanted_problems)
        .optional("none", form::boolean(), &SuiteEntry::allows_no_problem)
        .form()
        .then(can_be, {{"not", Json::parse(R"({"properties": {"none": {"const": true}, "must": {"minItems": 1}},
                                               "required": ["none", "must"]})")}});
}

Object<CompareOptions> thresholds() {
    return Object<CompareOptions>()
        .optional("profile", form::choice<CompareProfile>(profile_names),
                  [](CompareOptions& limits, CompareProfile profile) { limits = options_of(profile); })
        .optional("worst", form::whole(0, largest_worst), &CompareOptions::worst)
        .optional("share", form::number({0.0, 1.0}), &CompareOptions::share)
        .optional("reach", form::whole(0, 16), &CompareOptions::reach_px);
}

/// The settings of an entry, which are also allowed in "defaults".
Object<SuiteEntry> settings(const fs::path& folder) {
    const auto side = form::whole(1, largest_image_side);
    const auto size =
        form::list(side, "[width, height]", {2, 2, "must be [width, height]"}).then([](const std::vector<int>& sides) {
            return glm::ivec2(sides[0], sides[1]);
        });
    const char* const masks = "a list of rectangles [x, y, width, height] and picture files";
    return Object<SuiteEntry>()
        .optional("set", set_form(), [](SuiteEntry& entry, const Names& set) { append(entry.settings, set); })
        .optional("view", form::choice<PictureView>(picture_view_names), &SuiteEntry::view)
        .optional("size", size, &SuiteEntry::size_px)
        .optional("samples", samples_form(), &SuiteEntry::samples)
        .optional("picture", form::boolean(), &SuiteEntry::checks_picture)
        .with(thresholds(), &SuiteEntry::limits)
        .optional("masks", form::list(mask_form(folder), masks, {most_masks}),
                  [](SuiteEntry& entry, const std::vector<MaskSource>& all) {
                      for (const MaskSource& mask : all) {
                          append(entry.mask.rects, mask.rects);
                          append(entry.mask.pictures, mask.pictures);
                      }
                  })
        .optional("matrices", matrices_form(), &SuiteEntry::matrices_tolerance)
        .optional("measure", measures_form(), &SuiteEntry::measures)
        .optional("problems", problems_form(), [](SuiteEntry& entry, const SuiteEntry& read) {
            entry.wanted_problems = read.wanted_problems;
            entry.unwanted_problems = read.unwanted_problems;
            entry.allows_no_problem = read.allows_no_problem;
        });
}

// ---- entries -------------------------------------------------------------------------------------------------------

/// The name of a file, relative to the suite's folder, or of a built-in lesson or preset. If there is such a file, the
/// name becomes the file's path; otherwise, it is kept.
form::Form<std::string> file_form(const fs::path& folder) {
    return form::name().then([folder](const std::string& name) {
        std::error_code unknown;
        const fs::path file = folder / name;
        return fs::is_regular_file(file, unknown) ? file.string() : name;
    });
}

/// A state by its name, or written out: the values of `state` and `inline_state`.
form::Form<std::pair<std::string, std::string>> state_form(const fs::path& folder) {
    using State = std::pair<std::string, std::string>;
    const auto named = [](const std::string& name, const Where& where) {
        if (name == "-") where.refuse("must be a preset, a file or a state, not standard input");
        return State{name, ""};
    };
    const auto read = [](const Json& value, const Where& where) {
        const Result<Params> params = parse_state(value.dump(), where.prefix + where.path);  // checks the state now
        if (!params) throw Refusal(params.error());
        return State{"", value.dump()};
    };
    return form::either<State>("a preset's name, a file, or a state written out",
                               {file_form(folder).then(named, {{"not", {{"const", "-"}}}}),
                                {"a state", &Json::is_object, read, state_definition}});
}

form::Form<SuiteEntry> entry_form(const fs::path& folder, const SuiteEntry& defaults) {
    const auto step = [](SuiteEntry& entry) -> SuiteStep& {
        if (!entry.step) entry.view = PictureView::window;
        return entry.step ? *entry.step : entry.step.emplace();
    };
    const auto can_set = [](const SuiteEntry& entry, const Where& where) {
        const auto is_look = [](const std::string& setting) { return setting.starts_with("ui."); };
        if (entry.step && !std::all_of(entry.settings.begin(), entry.settings.end(), is_look))
            where.key("set").refuse("a lesson's step and an exercise have their own state: only ui.… can be set");
    };
    return Object<SuiteEntry>()
        .required("name", form::name(), &SuiteEntry::name)
        .optional("about", form::name(), &SuiteEntry::about)
        .optional("state", state_form(folder),
                  [](SuiteEntry& entry, const auto& state) { std::tie(entry.state, entry.inline_state) = state; })
        .with(Object<SuiteStep>()
                  .optional("lesson", file_form(folder), &SuiteStep::lesson)
                  .optional("step", form::whole(1, 1'000), &SuiteStep::step)
                  .optional("revealed", form::boolean(), &SuiteStep::revealed)
                  .optional("present", form::boolean(), &SuiteStep::presents)
                  .optional("exercise", form::name(), &SuiteStep::exercise)
                  .optional("course", form::name(), &SuiteStep::course)
                  .optional("student", form::name(), &SuiteStep::student)
                  .need({"step", "revealed", "present"}, "lesson")
                  .need({"course", "student"}, "exercise"),
              step)
        .at_most_one({"state", "lesson", "exercise"})
        .with(settings(folder), std::identity())
        .form([&defaults] { return defaults; })
        .then(can_set);
}

/// Entries for all presets or scenes: {"each": "preset", "name": "preset-{}", …}.
struct Several {
    Each each = Each::preset;
    std::string name;  ///< with {} in place of the preset's or the scene's
    Names except;
    SuiteEntry like;
};

form::Form<Several> several_form(const fs::path& folder, const SuiteEntry& defaults) {
    const auto has_place = [](const std::string& name, const Where& where) {
        if (name.find("{}") == std::string::npos)
            where.refuse("must contain {}, which stands for the name of the preset or scene");
    };
    return Object<Several>()
        .required("each", form::choice<Each>(each_names), &Several::each)
        .required("name", form::name().then(has_place, {{"pattern", "\\{\\}"}}), &Several::name)
        .optional(
            "about", form::name(), [](Several & several) -> auto& { return several.like.about; })
        .optional("except", names_form(), &Several::except)
        .with(settings(folder), &Several::like)
        .form(
            [&defaults] {
                return Several{Each::preset, "", {}, defaults};
            },
            "each");
}

std::vector<SuiteEntry> entries_of(const Several& several, const Where& where) {
    const std::vector<NamedFile> files = several.each == Each::scene ? scenes() : presets();
    if (files.empty()) where.key("each").refuse("there are none: the assets were not found");
    for (const std::string& name : several.except)
        if (std::none_of(files.begin(), files.end(), [&](const NamedFile& file) { return file.name == name; }))
            where.key("except").refuse("there is no " + excerpt(name));
    std::vector<SuiteEntry> entries;
    for (const NamedFile& file : files) {
        if (several.each == Each::fixed_preset && file.fixed_by.empty()) continue;
        if (std::find(several.except.begin(), several.except.end(), file.name) != several.except.end()) continue;
        SuiteEntry& entry = entries.emplace_back(several.like);
        entry.name = several.name;
        entry.name.replace(several.name.find("{}"), 2, file.name);
        if (several.each == Each::scene)
            entry.inline_state = Json{{"scene", file.name}}.dump();
        else
            entry.state = file.name;
        if (several.each == Each::fixed_preset) entry.settings.insert(entry.settings.begin(), file.fixed_by);
    }
    return entries;
}

// ---- the suite -----------------------------------------------------------------------------------------------------

/// Assigns file names to entries. Refuses two names that differ at most in case, since some systems ignore case.
void name_files(Suite& suite, const std::string& prefix) {
    std::map<std::string, std::string> taken;
    for (SuiteEntry& entry : suite.entries) {
        entry.file_name = safe_file_name(entry.name);
        const auto [other, is_new] = taken.emplace(in_lower_case(entry.file_name), entry.name);
        if (!is_new)
            throw Refusal(prefix + "the entries " + excerpt(other->second) + " and " + excerpt(entry.name) +
                          " would have the same file name");
    }
}

/// Returns the approximate amount of memory that an entry uses.
std::size_t bytes_of(const SuiteEntry& entry) {
    std::size_t bytes = sizeof(SuiteEntry) + entry.name.size() + entry.about.size() + entry.state.size() +
                        entry.inline_state.size() + entry.mask.rects.size() * sizeof(MaskRect) +
                        entry.measures.size() * sizeof(SuiteMeasure);
    for (const fs::path& file : entry.mask.pictures) bytes += sizeof(fs::path) + file.native().size();
    for (const std::vector<std::string>* const texts :
         {&entry.settings, &entry.wanted_problems, &entry.unwanted_problems})
        for (const std::string& text : *texts) bytes += sizeof(std::string) + text.size();
    return bytes;
}

/// Whether any check of the entry can fail at all.
bool tests_something(const SuiteEntry& entry) {
    const bool passes_any_picture = entry.limits.profile == CompareProfile::strict &&
                                    (entry.limits.worst == largest_worst || entry.limits.share >= 1.0);
    return (entry.checks_picture && !passes_any_picture) || entry.matrices_tolerance || !entry.measures.empty() ||
           !entry.wanted_problems.empty() || !entry.unwanted_problems.empty() || entry.allows_no_problem;
}

/// Makes the checks that are possible only after the defaults, the entry and "loosened" have been combined.
void check_entry_of(const SuiteEntry& entry, const Where& where) {
    if (const Status fits = check_picture_size(entry.view, entry.size_px); !fits)
        where.refuse(excerpt(entry.name) + ": size: " + fits.error());
    if (!entry.measures.empty() && !is_image_size(entry.size_px.x, entry.size_px.y, most_measured_pixels))
        where.refuse(excerpt(entry.name) + ": size: for measuring, " + image_size_rule(most_measured_pixels));
    if (!tests_something(entry))
        where.refuse(excerpt(entry.name) +
                     (entry.checks_picture
                          ? " cannot fail: \"worst\" 255 or \"share\" 1 lets every picture pass"
                          : " tests nothing: without \"picture\" it needs \"matrices\", \"measure\" or \"problems\""));
}

/// What is known while a suite is read.
struct Reading {
    fs::path folder;
    SuiteEntry defaults;
    std::vector<SuiteEntry> entries;
    std::size_t bytes = 0;                       ///< of all entries, each with its copy of the defaults
    std::map<std::string, SuiteEntry*> by_name;  ///< filled when the first entry is looked up

    void add(const SuiteEntry& entry, const Where& where) {
        constexpr std::size_t most_bytes = 128U << 20U;
        bytes += bytes_of(entry);
        if (entries.size() == most_suite_entries)
            where.refuse("are more than " + std::to_string(most_suite_entries) + ", counting all those of \"each\"");
        if (bytes > most_bytes)
            where.refuse("have more than " + std::to_string(most_bytes >> 20U) +
                         " MiB of settings, masks and texts, including the defaults");
        entries.push_back(entry);
    }

    SuiteEntry* find(const std::string& name, const Where& where) {
        if (by_name.empty())
            for (SuiteEntry& entry : entries) by_name.emplace(entry.name, &entry);
        const auto found = by_name.find(name);
        if (found == by_name.end()) where.refuse("there is no entry " + excerpt(name));
        return found->second;
    }
};

form::Form<bool> entries_form(Reading& reading) {
    const auto add = [&](const SuiteEntry& entry, const Where& where) {
        reading.add(entry, {where.prefix, "entries"});
        return true;
    };
    const auto add_all = [&](const Several& several, const Where& where) {
        for (const SuiteEntry& entry : entries_of(several, where)) reading.add(entry, {where.prefix, "entries"});
        return true;
    };
    return form::either<bool>("an object", {several_form(reading.folder, reading.defaults).then(add_all),
                                            entry_form(reading.folder, reading.defaults).then(add)});
}

/// New thresholds for an entry, and the reason for them, which is added to the entry's description.
form::Form<SuiteEntry*> loosened_form(Reading& reading) {
    const auto named = [&](const std::string& name, const Where& where) { return reading.find(name, where); };
    const auto explain = [](SuiteEntry* entry, const std::string& reason) {
        entry->about += (entry->about.empty() ? "" : "; ") + reason;
    };
    return Object<SuiteEntry*>()
        .required(
            "name", form::name().then(named), [](SuiteEntry * &entry) -> auto& { return entry; })
        .required("about", form::name(), explain)
        .with(
            thresholds(), [](SuiteEntry * entry) -> auto& { return entry->limits; })
        .form();
}

Object<Suite> suite_form(Reading& reading) {
    const auto subfolder = form::name().then([&](const std::string& name) { return reading.folder / name; });
    return Object<Suite>()
        .version("suite")
        .optional("title", form::name(), &Suite::name)
        .optional("references", subfolder, &Suite::references)
        .optional("report", subfolder, &Suite::report)
        .optional("defaults", settings(reading.folder).form(),
                  [&](Suite&, const SuiteEntry& defaults) { reading.defaults = defaults; })
        .checked("entries",
                 form::list(entries_form(reading), "a list of entries", {most_suite_entries, 1, "has no entries"}),
                 true)
        .checked("loosened", form::list(loosened_form(reading), "a list of names with thresholds and a reason",
                                        {most_suite_entries}));
}

Suite read_suite(const Json& document, const fs::path& file, const Where& where) {
    Reading reading{file.parent_path(), {}, {}, 0, {}};
    Suite suite = suite_form(reading).read(
        document, where,
        {file.stem().string(), file, reading.folder, reading.folder / "references", reading.folder / "report", {}});
    suite.entries = std::move(reading.entries);
    for (const SuiteEntry& entry : suite.entries) check_entry_of(entry, where.key("entries"));
    return suite;
}

Suite suite_of_folder(const fs::path& folder) {
    Suite suite;
    suite.argument = folder;
    suite.folder = folder;
    suite.name = fs::absolute(folder).lexically_normal().filename().string();
    if (suite.name.empty()) suite.name = fs::absolute(folder).parent_path().filename().string();
    suite.references = folder / "references";
    suite.report = folder / "report";
    for (const fs::path& file : files_in(folder, ".json")) {
        if (!is_utf8(file.filename().string()))
            throw Refusal(one_line(file.string()) + ": the file name is not UTF-8, which reports need");
        SuiteEntry entry;
        entry.name = file.stem().string();
        entry.state = file.string();
        suite.entries.push_back(std::move(entry));
    }
    return suite;
}

/// Refuses to let `run` and `accept` overwrite files that the suite reads.
void check_outputs(const Suite& suite, const Where& where) {
    if (are_same_file(suite.report, suite.references))
        where.key("report").refuse("must not be the folder of the references");
    const auto is_read = [&suite](const fs::path& written) {
        return are_same_file(suite.argument, written) ||
               std::any_of(suite.entries.begin(), suite.entries.end(),
                           [&](const SuiteEntry& entry) { return are_same_file(entry.state, written); });
    };
    for (const char* const name : {"report.json", "junit.xml", "index.html"})
        if (is_read(suite.report / name))
            where.key("report").refuse("must be another folder: " + std::string(name) +
                                       ", which is written there, is a file of the suite");
    for (const SuiteEntry& entry : suite.entries)
        for (const fs::path& file : {reference_picture(suite, entry), reference_numbers(suite, entry)})
            if (are_same_file(suite.argument, file) || are_same_file(entry.state, file))
                where.key("references")
                    .refuse("must be another folder: " + file.filename().string() +
                            ", which is written there, is a file of the suite");
}

}  // namespace

std::string safe_file_name(const std::string& name) {
    constexpr std::size_t longest = 150;
    std::string safe;
    for (const char c : name) {
        const bool is_inner_dot = c == '.' && !safe.empty();
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || is_inner_dot)
            safe += c;
        else if (c == ' ' || c == '/')
            safe += '-';
        else
            safe += percent_encoded(c);
    }
    if (safe.size() > longest) safe.resize(longest);
    while (!safe.empty() && safe.back() == '.') safe.back() = '_';
    // CON, NUL, COM1 and the like are devices on Windows, whatever their extension.
    static const std::vector<std::string> devices{"con", "prn", "aux", "nul"};
    const std::string stem = in_lower_case(safe.substr(0, safe.find('.')));
    const bool is_port = stem.size() == 4 && (stem.starts_with("com") || stem.starts_with("lpt")) &&
                         std::isdigit(static_cast<unsigned char>(stem[3])) != 0;
    if (is_port || std::find(devices.begin(), devices.end(), stem) != devices.end()) safe.insert(0, "_");
    return safe;
}

std::string suite_schema() {
    Reading none;
    return form::document("A suite of the Viewing Sandbox", suite_form(none));
}

Result<Suite> load_suite(const std::string& argument) {
    std::error_code unknown;
    const fs::path path(argument);
    const bool is_folder = fs::is_directory(path, unknown);
    if (!is_folder && !fs::exists(path, unknown))
        return Error{one_line(argument) + ": no such suite; give a .json file or a folder of states"};
    return guarded([&] {
        const std::string prefix = one_line(argument) + ": ";
        Suite suite;
        if (is_folder) {
            suite = suite_of_folder(path);
        } else {
            const Result<std::string> text = read_text_file(path);
            if (!text) throw Refusal(text.error());
            const Where root{prefix, ""};
            suite = read_suite(parse_document(*text, prefix), path, root);
        }
        if (suite.entries.empty()) throw Refusal(prefix + "has no entries");
        name_files(suite, prefix);
        check_outputs(suite, {prefix, ""});
        return suite;
    });
}

}  // namespace viewing
