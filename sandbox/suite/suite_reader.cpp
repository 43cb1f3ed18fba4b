// Reads suite files as strictly as states: every mistake is reported in one sentence that names the file and the field.
#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "image/image_size.h"
#include "lesson/tree.h"
#include "platform/file.h"
#include "state/file/json.h"
#include "suite/form.h"
#include "suite/results.h"
#include "suite/suite.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

namespace form = suite_form;
using form::each_names, form::measure_names;

/// The keys of an entry's settings, which are also allowed in "defaults".
const std::vector<std::string> setting_keys{"set",   "view",  "size",  "samples",  "picture", "profile", "worst",
                                            "share", "reach", "masks", "matrices", "measure", "problems"};

std::vector<std::string> with_setting_keys(std::vector<std::string> keys) {
    keys.insert(keys.end(), setting_keys.begin(), setting_keys.end());
    return keys;
}

// ---- settings ------------------------------------------------------------------------------------------------------

/// Reads {"projection.near": 0.1, …} or ["projection.near=0.1", …].
std::vector<std::string> read_set(const Json& value, const Where& where) {
    if (value.is_object()) return read_settings(value, where);
    require_array(value, where, form::most_settings, "an object of fields and their values, or a list of PATH=VALUE");
    std::vector<std::string> settings;
    for (std::size_t i = 0; i < value.size(); ++i) {
        settings.push_back(read_name(value[i], where.at(i)));
        if (settings.back().find('=') == std::string::npos) where.at(i).refuse("must be PATH=VALUE");
    }
    return settings;
}

glm::ivec2 read_size(const Json& value, const Where& where) {
    require_array(value, where, 2, "[width, height]");
    if (value.size() != 2) where.refuse("must be [width, height]");
    return {read_whole(value[0], where.at(0), 1, largest_image_side),
            read_whole(value[1], where.at(1), 1, largest_image_side)};
}

/// Reads a rectangle [x, y, width, height], or the file name of a picture, relative to the suite's folder.
void read_mask(const Json& value, const Where& where, const fs::path& folder, SuiteEntry& entry) {
    if (value.is_string()) {
        entry.mask.pictures.push_back(folder / read_name(value, where));
        return;
    }
    if (!value.is_array() || value.size() != 4)
        refuse_value(value, where, "a picture's file, or [x, y, width, height]");
    std::array<int, 4> sides{};
    for (std::size_t i = 0; i < 4; ++i) sides[i] = read_whole(value[i], where.at(i), i < 2 ? 0 : 1, largest_image_side);
    entry.mask.rects.push_back({sides[0], sides[1], sides[2], sides[3]});
}

double read_tolerance(const Json& object, const Where& where) {
    return object.contains("tolerance")
               ? read_number(object["tolerance"], where.key("tolerance"), {0.0, form::most_tolerance})
               : 0.0;
}

SuiteMeasure read_measure(const Json& value, const Where& where) {
    if (value.is_string()) return {measure_names[static_cast<std::size_t>(read_choice(value, where, measure_names))]};
    require_keys(value, where, {"what", "tolerance"});
    if (!has(value, "what")) where.key("what").refuse("is missing: fighting, visibility, mirror or order");
    const int what = read_choice(value["what"], where.key("what"), measure_names);
    return {measure_names[static_cast<std::size_t>(what)], read_tolerance(value, where)};
}

std::vector<SuiteMeasure> read_measures(const Json& value, const Where& where) {
    if (!value.is_array()) return {read_measure(value, where)};
    require_array(value, where, measure_names.size(), "a list of measurements, each once");
    std::vector<SuiteMeasure> measures;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const SuiteMeasure measure = read_measure(value[i], where.at(i));
        if (std::any_of(measures.begin(), measures.end(),
                        [&](const SuiteMeasure& earlier) { return earlier.what == measure.what; }))
            where.at(i).refuse("measures " + measure.what + " twice");
        measures.push_back(measure);
    }
    return measures;
}

std::optional<double> read_matrices(const Json& value, const Where& where) {
    if (value.is_boolean()) return value.get<bool>() ? std::optional(0.0) : std::nullopt;
    require_keys(value, where, {"tolerance"});
    return read_tolerance(value, where);
}

void read_problems(const Json& value, const Where& where, SuiteEntry& entry) {
    require_keys(value, where, {"must", "must_not", "none"});
    entry.wanted_problems = names_at(value, "must", where);
    entry.unwanted_problems = names_at(value, "must_not", where);
    entry.allows_no_problem = has(value, "none") && read_bool(value["none"], where.key("none"));
    if (entry.allows_no_problem && !entry.wanted_problems.empty())
        where.key("none").refuse("cannot be true together with \"must\"");
}

/// Reads the keys of `setting_keys`, overriding the settings of the entry.
void read_settings_of(const Json& object, const Where& where, const fs::path& folder, SuiteEntry& entry) {
    const auto with = [&](const char* key, const auto& read) {
        if (has(object, key)) read(object[key], where.key(key));
    };
    with("set", [&](const Json& value, const Where& at) {
        for (std::string& setting : read_set(value, at)) entry.settings.push_back(std::move(setting));
    });
    with("view", [&](const Json& value, const Where& at) {
        entry.view = static_cast<PictureView>(read_choice(value, at, picture_view_names));
    });
    with("size", [&](const Json& value, const Where& at) { entry.size_px = read_size(value, at); });
    with("samples", [&](const Json& value, const Where& at) {
        entry.samples.reset();
        if (value == "state") return;
        entry.samples = read_whole(value, at, 0, 4);
        if (*entry.samples != 0 && *entry.samples != 4) at.refuse("must be 0, 4 or \"state\" (the value of the state)");
    });
    with("picture", [&](const Json& value, const Where& at) { entry.checks_picture = read_bool(value, at); });
    with("profile", [&](const Json& value, const Where& at) {
        entry.limits = options_of(static_cast<CompareProfile>(read_choice(value, at, profile_names)));
    });
    with("worst",
         [&](const Json& value, const Where& at) { entry.limits.worst = read_whole(value, at, 0, form::most_worst); });
    with("share", [&](const Json& value, const Where& at) { entry.limits.share = read_number(value, at, {0.0, 1.0}); });
    with("reach", [&](const Json& value, const Where& at) {
        entry.limits.reach_px = read_whole(value, at, 0, form::most_reach_px);
    });
    with("masks", [&](const Json& value, const Where& at) {
        require_array(value, at, form::most_masks, "a list of rectangles [x, y, width, height] and picture files");
        for (std::size_t i = 0; i < value.size(); ++i) read_mask(value[i], at.at(i), folder, entry);
    });
    with("matrices", [&](const Json& value, const Where& at) { entry.matrices_tolerance = read_matrices(value, at); });
    with("measure", [&](const Json& value, const Where& at) { entry.measures = read_measures(value, at); });
    with("problems", [&](const Json& value, const Where& at) { read_problems(value, at, entry); });
}

// ---- subjects ------------------------------------------------------------------------------------------------------

/// Resolves a file name relative to the suite's folder and returns the file's path; if there is no such file, returns
/// the name itself, which may be that of a built-in lesson or preset.
std::string found_from(const fs::path& folder, const std::string& name) {
    std::error_code unknown;
    const fs::path file = folder / name;
    return fs::is_regular_file(file, unknown) ? file.string() : name;
}

void read_state(const Json& value, const Where& where, const fs::path& folder, SuiteEntry& entry) {
    if (value.is_string()) {
        entry.state = found_from(folder, read_name(value, where));
        if (entry.state == "-") where.refuse("must be a preset, a file or a state, not standard input");
        return;
    }
    require_object(value, where, "a preset's name, a file, or a state written out");
    entry.inline_state = value.dump();
    const Result<Params> params = parse_state(entry.inline_state, where.prefix + where.path);  // checks the state now
    if (!params) throw Refusal(params.error());
}

SuiteStep read_lesson_step(const Json& object, const Where& where, const fs::path& folder) {
    SuiteStep step;
    step.lesson = found_from(folder, name_at(object, "lesson", where));
    if (has(object, "step")) step.step = read_whole(object["step"], where.key("step"), 1, form::most_step);
    step.revealed = has(object, "revealed") && read_bool(object["revealed"], where.key("revealed"));
    step.presents = has(object, "present") && read_bool(object["present"], where.key("present"));
    return step;
}

SuiteStep read_exercise(const Json& object, const Where& where) {
    SuiteStep step;
    step.exercise = name_at(object, "exercise", where);
    if (has(object, "course")) step.course = read_name(object["course"], where.key("course"));
    if (has(object, "student")) step.student = read_name(object["student"], where.key("student"));
    return step;
}

void read_subject(const Json& object, const Where& where, const fs::path& folder, SuiteEntry& entry) {
    int subjects = 0;
    for (const char* const key : {"state", "lesson", "exercise"}) subjects += has(object, key) ? 1 : 0;
    if (subjects > 1) where.refuse("has more than one of \"state\", \"lesson\" and \"exercise\"");
    if (has(object, "state")) read_state(object["state"], where.key("state"), folder, entry);
    if (has(object, "lesson")) entry.step = read_lesson_step(object, where, folder);
    if (has(object, "exercise")) entry.step = read_exercise(object, where);
    for (const char* const key : {"step", "revealed", "present"})
        if (has(object, key) && !has(object, "lesson")) where.key(key).refuse("needs \"lesson\"");
    for (const char* const key : {"course", "student"})
        if (has(object, key) && !has(object, "exercise")) where.key(key).refuse("needs \"exercise\"");
    const auto is_look = [](const std::string& setting) { return setting.starts_with("ui."); };
    if (entry.step && !std::all_of(entry.settings.begin(), entry.settings.end(), is_look))
        where.key("set").refuse("a lesson's step and an exercise have their own state: only ui.… can be set");
}

std::string about_at(const Json& object, const Where& where) {
    return has(object, "about") ? read_name(object["about"], where.key("about")) : "";
}

SuiteEntry read_entry(const Json& object, const Where& where, const fs::path& folder, const SuiteEntry& defaults) {
    require_keys(object, where,
                 with_setting_keys({"name", "about", "state", "lesson", "step", "revealed", "present", "exercise",
                                    "course", "student"}));
    SuiteEntry entry = defaults;
    entry.name = name_at(object, "name", where);
    entry.about = about_at(object, where);
    if (has(object, "lesson") || has(object, "exercise")) entry.view = PictureView::window;
    read_settings_of(object, where, folder, entry);
    read_subject(object, where, folder, entry);
    return entry;
}

/// Reads, for example, {"each": "preset", "name": "preset-{}", …}, which makes one entry for each preset.
std::vector<SuiteEntry> read_each(const Json& object, const Where& where, const fs::path& folder,
                                  const SuiteEntry& defaults) {
    require_keys(object, where, with_setting_keys({"each", "name", "about", "except"}));
    const int each = read_choice(object["each"], where.key("each"), each_names);
    const std::string pattern = name_at(object, "name", where);
    const std::size_t place = pattern.find("{}");
    if (place == std::string::npos)
        where.key("name").refuse("must contain {}, which stands for the name of the preset or scene");
    const std::vector<std::string> except = names_at(object, "except", where);
    SuiteEntry like = defaults;
    like.about = about_at(object, where);
    read_settings_of(object, where, folder, like);

    const bool are_scenes = each_names[static_cast<std::size_t>(each)] == std::string_view("scene");
    const bool are_fixed = each_names[static_cast<std::size_t>(each)] == std::string_view("mended");
    const std::vector<NamedFile> files = are_scenes ? scenes() : presets();
    if (files.empty()) where.key("each").refuse("there are none: the assets were not found");
    for (const std::string& name : except)
        if (std::none_of(files.begin(), files.end(), [&](const NamedFile& file) { return file.name == name; }))
            where.key("except").refuse("there is no " + excerpt(name));
    std::vector<SuiteEntry> entries;
    for (const NamedFile& file : files) {
        if (are_fixed && file.fixed_by.empty()) continue;
        if (std::find(except.begin(), except.end(), file.name) != except.end()) continue;
        SuiteEntry entry = like;
        entry.name = pattern.substr(0, place) + file.name + pattern.substr(place + 2);
        if (are_scenes)
            entry.inline_state = Json{{"scene", file.name}}.dump();
        else
            entry.state = file.name;
        if (are_fixed) entry.settings.insert(entry.settings.begin(), file.fixed_by);
        entries.push_back(std::move(entry));
    }
    return entries;
}

// ---- the suite -----------------------------------------------------------------------------------------------------

/// Assigns file names to entries. Refuses two that differ only in case, since on some systems they are the same file.
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

/// Gives entries the thresholds listed in "loosened", and adds the reason to each entry's description.
void loosen(const Json& list, const Where& where, std::vector<SuiteEntry>& entries) {
    require_array(list, where, form::most_entries, "a list of names with thresholds and a reason");
    std::map<std::string, SuiteEntry*> by_name;
    for (SuiteEntry& entry : entries) by_name.emplace(entry.name, &entry);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Where at = where.at(i);
        require_keys(list[i], at, {"name", "about", "profile", "worst", "share", "reach"});
        const std::string name = name_at(list[i], "name", at);
        const auto found = by_name.find(name);
        if (found == by_name.end()) at.key("name").refuse("there is no entry " + excerpt(name));
        SuiteEntry* const entry = found->second;
        const std::string reason = name_at(list[i], "about", at);
        entry->about += (entry->about.empty() ? "" : "; ") + reason;
        Json thresholds = list[i];
        thresholds.erase("name");
        thresholds.erase("about");
        read_settings_of(thresholds, at, {}, *entry);
    }
}

fs::path folder_at(const Json& object, const char* key, const Where& where, const fs::path& folder) {
    return folder / (has(object, key) ? read_name(object[key], where.key(key)) : key);
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
                                    (entry.limits.worst == form::most_worst || entry.limits.share >= 1.0);
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

Suite read_suite(const Json& document, const fs::path& file, const Where& where) {
    require_keys(document, where,
                 {"$schema", "suite", "title", "references", "report", "defaults", "entries", "loosened"});
    if (!has(document, "suite") || document["suite"] != 1)
        where.key("suite").refuse("must be 1, the version of the format that this program reads");
    Suite suite;
    suite.argument = file;
    suite.folder = file.parent_path();
    suite.name = has(document, "title") ? read_name(document["title"], where.key("title")) : file.stem().string();
    suite.references = folder_at(document, "references", where, suite.folder);
    suite.report = folder_at(document, "report", where, suite.folder);
    SuiteEntry defaults;
    if (has(document, "defaults")) {
        require_keys(document["defaults"], where.key("defaults"), setting_keys);
        read_settings_of(document["defaults"], where.key("defaults"), suite.folder, defaults);
    }
    const Where entries = where.key("entries");
    if (!has(document, "entries")) entries.refuse("is missing: a list of entries");
    require_array(document["entries"], entries, form::most_entries, "a list of entries");
    std::size_t bytes = 0;  // including each entry's copy of the defaults
    const auto add = [&](SuiteEntry entry) {
        constexpr std::size_t most_bytes = 128U << 20U;
        bytes += bytes_of(entry);
        if (suite.entries.size() == form::most_entries)
            entries.refuse("are more than " + std::to_string(form::most_entries) + ", counting all those of \"each\"");
        if (bytes > most_bytes)
            entries.refuse("have more than " + std::to_string(most_bytes >> 20U) +
                           " MiB of settings, masks and texts, including the defaults");
        suite.entries.push_back(std::move(entry));
    };
    for (std::size_t i = 0; i < document["entries"].size(); ++i) {
        const Json& object = document["entries"][i];
        require_object(object, entries.at(i), "an object");
        if (has(object, "each"))
            for (SuiteEntry& entry : read_each(object, entries.at(i), suite.folder, defaults)) add(std::move(entry));
        else
            add(read_entry(object, entries.at(i), suite.folder, defaults));
    }
    if (has(document, "loosened")) loosen(document["loosened"], where.key("loosened"), suite.entries);
    for (const SuiteEntry& entry : suite.entries) check_entry_of(entry, entries);
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
