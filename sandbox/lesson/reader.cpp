// Lesson files: read with the same care as states. Every message names the file, the step and the field.
#include <algorithm>
#include <cmath>
#include <map>

#include "lesson/expression.h"
#include "lesson/lesson.h"
#include "lesson/targets.h"
#include "state/json.h"
#include "state/reader.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_steps = 200, most_entries = 64;
constexpr std::size_t longest_text = 4000;  // bytes
constexpr double longest_reveal_s = 60.0;

constexpr const char* kind_names[] = {"choice", "number",  "vector", "matrix", "sequence",
                                      "order",  "product", "subset", "goal"};

bool has(const Json& object, const char* key) {
    return object.contains(key);
}

/// An object whose keys are all known.
void require_keys(const Json& object, const Where& where, const std::vector<std::string>& known) {
    require_object(object, where, "an object");
    for (const auto& [key, value] : object.items()) require_known_key(key, where, known);
}

std::string read_plain_text(const Json& value, const Where& where) {
    if (!value.is_string()) refuse_value(value, where, "a text");
    std::string text = value.get<std::string>();
    if (text.size() > longest_text) where.refuse("longer than " + std::to_string(longest_text) + " bytes");
    if (std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
        where.refuse("has a line break or another control character");
    return text;
}

LessonText read_text_of(const Json& value, const Where& where) {
    LessonText text;
    if (value.is_string()) {
        text.by_language.front() = read_plain_text(value, where);
        return text;
    }
    if (!value.is_object()) refuse_value(value, where, "a text or {\"en\": …, \"ko\": …}");
    const std::span<const char* const> languages = names_of<Language>();
    require_keys(value, where, {languages.begin(), languages.end()});
    if (!has(value, "en")) where.key("en").refuse("is missing");
    for (std::size_t i = 0; i < languages.size(); ++i)
        if (has(value, languages[i]))
            text.by_language[i] = read_plain_text(value[languages[i]], where.key(languages[i]));
    return text;
}

LessonText text_at(const Json& object, const char* key, const Where& where, bool is_needed) {
    if (!has(object, key)) {
        if (is_needed) where.key(key).refuse("is missing: a text");
        return {};
    }
    LessonText text = read_text_of(object[key], where.key(key));
    if (is_needed && text.empty()) where.key(key).refuse("must not be empty");
    return text;
}

std::vector<std::string> names_at(const Json& object, const char* key, const Where& where) {
    std::vector<std::string> names;
    if (!has(object, key)) return names;
    const Where inside = where.key(key);
    require_array(object[key], inside, most_entries, "a list of names");
    for (std::size_t i = 0; i < object[key].size(); ++i) names.push_back(read_name(object[key][i], inside.at(i)));
    return names;
}

/// What a step covers or points out.
std::vector<std::string> targets_at(const Json& object, const char* key, const Where& where) {
    std::vector<std::string> targets = names_at(object, key, where);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        Result<std::string> target = read_target(targets[i]);
        if (!target) where.key(key).at(i).refuse(target.error());
        targets[i] = *std::move(target);
    }
    return targets;
}

std::string expression_in(const Json& value, const Where& where) {
    const std::string expression = value.is_number() ? value.dump() : read_plain_text(value, where);
    if (const Status fine = check_expression(expression); !fine) where.refuse(fine.error());
    return expression;
}

std::string expression_at(const Json& object, const char* key, const Where& where, bool is_needed) {
    if (!has(object, key)) {
        if (is_needed) where.key(key).refuse("is missing: an expression");
        return "";
    }
    return expression_in(object[key], where.key(key));
}

std::vector<std::string> expressions_at(const Json& object, const char* key, const Where& where) {
    std::vector<std::string> expressions;
    if (!has(object, key)) return expressions;
    const Where inside = where.key(key);
    require_array(object[key], inside, most_entries, "a list of expressions");
    for (std::size_t i = 0; i < object[key].size(); ++i)
        expressions.push_back(expression_in(object[key][i], inside.at(i)));
    return expressions;
}

/// {"projection.near": 0.1, …} as PATH=VALUE.
std::vector<std::string> settings_in(const Json& object, const Where& where) {
    require_object(object, where, "an object of paths and values");
    std::vector<std::string> settings;
    for (const auto& [path, value] : object.items()) settings.push_back(path + "=" + value.dump());
    return settings;
}

std::vector<std::string> settings_at(const Json& object, const char* key, const Where& where) {
    return has(object, key) ? settings_in(object[key], where.key(key)) : std::vector<std::string>();
}

Params changed(const Params& params, const std::vector<std::string>& settings, const Where& where) {
    Result<Params> result =
        apply_settings(params, settings, where.prefix + (where.path.empty() ? "" : where.path + ": "));
    if (!result) throw Refusal(result.error());
    return *std::move(result);
}

// ---- a step's state ------------------------------------------------------------------------------------------------

/// What a step may say of the window, and where the state has it.
struct LayoutPlace {
    const char *key, *path;
};
constexpr LayoutPlace layout_places[] = {{"big", "view.layout.big"},
                                         {"matrices", "view.layout.matrices"},
                                         {"controls", "view.layout.controls"},
                                         {"folded", "view.layout.folded"},
                                         {"lower_left", "view.lower_left"},
                                         {"lower_right", "view.lower_right"},
                                         {"pin", "view.pin"}};

Params laid_out(const Params& params, const Json& layout, const Where& where) {
    std::vector<std::string> known{"target"};
    for (const LayoutPlace& place : layout_places) known.emplace_back(place.key);
    require_keys(layout, where, known);
    Params result = params;
    for (const LayoutPlace& place : layout_places)
        if (has(layout, place.key))
            result = changed(result, {std::string(place.path) + "=" + layout[place.key].dump()}, where.key(place.key));
    return result;
}

/// Presets by name, each read once a lesson.
class PresetShelf {
public:
    const LoadedState& get(const std::string& name, const Where& where) {
        const auto known = states_.find(name);
        if (known != states_.end()) return known->second;
        if (name == "-" || name.find('/') != std::string::npos || name.ends_with(".json"))
            where.refuse("must be the name of a preset, got \"" + excerpt(name) + "\"");
        Result<LoadedState> state = load_state(name);
        if (!state) where.refuse(state.error());
        return states_.emplace(name, *std::move(state)).first->second;
    }

private:
    std::map<std::string, LoadedState> states_;
};

/// A preset with settings on top; without either, the opening.
LoadedState state_at(const Json& object, const char* key, const fs::path& folder, PresetShelf& presets,
                     const Where& where) {
    if (!has(object, key)) return presets.get("opening", where);
    const Json& state = object[key];
    const Where inside = where.key(key);
    require_keys(state, inside, {"preset", "set"});
    const std::string preset = has(state, "preset") ? read_name(state["preset"], inside.key("preset")) : "opening";
    LoadedState loaded = presets.get(preset, inside.key("preset"));
    const SceneSource scene = loaded.params.scene;
    loaded.params = changed(loaded.params, settings_at(state, "set", inside), inside.key("set"));
    if (loaded.params.scene != scene) loaded.base = folder;
    return loaded;
}

LoadedState read_start(const Json& object, const fs::path& folder, PresetShelf& presets, const Where& where) {
    LoadedState start = state_at(object, "state", folder, presets, where);
    if (has(object, "layout")) start.params = laid_out(start.params, object["layout"], where.key("layout"));
    start.preset = nullptr;  // a step is no preset: nothing departs from it
    start.scene_origin = where.prefix + "scene";
    return start;
}

std::optional<LessonTarget> read_target(const Json& object, const Where& where) {
    if (!has(object, "layout") || !has(object["layout"], "target")) return std::nullopt;
    const Json& target = object["layout"]["target"];
    const Where inside = where.key("layout").key("target");
    require_keys(target, inside, {"point", "label"});
    if (!has(target, "point")) inside.key("point").refuse("is missing: [x, y, z]");
    return LessonTarget{read_vec3(target["point"], inside.key("point"), {-1e6, 1e6}, "[x, y, z]"),
                        text_at(target, "label", inside, false)};
}

// ---- questions -----------------------------------------------------------------------------------------------------

std::vector<LessonChoice> read_choices(const Json& ask, const Where& where) {
    const Where inside = where.key("choices");
    if (!has(ask, "choices")) inside.refuse("is missing: a list of answers");
    require_array(ask["choices"], inside, 9, "a list of two to nine answers");
    std::vector<LessonChoice> choices;
    for (std::size_t i = 0; i < ask["choices"].size(); ++i) {
        const Json& choice = ask["choices"][i];
        const Where at = inside.at(i);
        require_keys(choice, at, {"say", "right", "why", "tag"});
        LessonChoice read{
            text_at(choice, "say", at, true), has(choice, "right") && read_bool(choice["right"], at.key("right")),
            text_at(choice, "why", at, false), has(choice, "tag") ? read_name(choice["tag"], at.key("tag")) : ""};
        if (!read.right && read.why.empty()) at.key("why").refuse("is missing: a wrong answer is told why");
        choices.push_back(std::move(read));
    }
    const auto right =
        std::count_if(choices.begin(), choices.end(), [](const LessonChoice& choice) { return choice.right; });
    if (choices.size() < 2 || right != 1) inside.refuse("must be two or more, one of them \"right\": true");
    return choices;
}

bool has_items(AskKind kind) {
    return kind == AskKind::sequence || kind == AskKind::order || kind == AskKind::product || kind == AskKind::subset;
}

std::vector<int> read_items(const Json& value, std::size_t count, const Where& where) {
    require_array(value, where, most_entries, "a list of items' places, from 0 on");
    std::vector<int> items;
    for (std::size_t i = 0; i < value.size(); ++i)
        items.push_back(read_whole(value[i], where.at(i), 0, static_cast<int>(count) - 1));
    return items;
}

/// One list of places, or several that are as right.
std::vector<std::vector<int>> read_expected_items(const Json& ask, std::size_t count, const Where& where) {
    const Where inside = where.key("expect");
    if (!has(ask, "expect")) inside.refuse("is missing: a list of items' places, from 0 on");
    const Json& value = ask["expect"];
    const bool are_several = value.is_array() && !value.empty() && value[0].is_array();
    if (!are_several) return {read_items(value, count, inside)};
    std::vector<std::vector<int>> lists;
    for (std::size_t i = 0; i < value.size(); ++i) lists.push_back(read_items(value[i], count, inside.at(i)));
    return lists;
}

std::vector<double> read_numbers(const Json& value, const Where& where) {
    if (value.is_number()) return {value.get<double>()};
    require_array(value, where, 16, "a number or a list of numbers");
    std::vector<double> numbers;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::vector<double> row = read_numbers(value[i], where.at(i));
        numbers.insert(numbers.end(), row.begin(), row.end());
    }
    return numbers;
}

Answer read_sample(const Json& value, const Ask& ask, const Where& where) {
    Answer sample;
    if (has_items(ask.kind))
        sample.items = read_items(value, ask.items.size(), where);
    else
        sample.numbers = read_numbers(value, where);
    if (!has_items(ask.kind) && std::ssize(sample.numbers) != ask.rows * ask.columns)
        where.refuse("must have " + std::to_string(ask.rows * ask.columns) + " numbers");
    return sample;
}

WrongAnswer read_wrong(const Json& object, const Ask& ask, const Where& where) {
    require_keys(object, where, {"when", "value", "try", "tag", "say"});
    WrongAnswer wrong{expression_at(object, "when", where, false),
                      text_at(object, "say", where, true),
                      has(object, "tag") ? read_name(object["tag"], where.key("tag")) : "",
                      {},
                      {}};
    if (ask.kind == AskKind::goal) {
        if (wrong.when.empty()) where.key("when").refuse("is missing: an expression");
        wrong.settings = settings_at(object, "try", where);
        return wrong;
    }
    const char* const key = has(object, "value") ? "value" : "try";
    if (has(object, key)) wrong.sample = read_sample(object[key], ask, where.key(key));
    if (wrong.when.empty() && wrong.sample.empty()) where.key("when").refuse("is missing: an expression, or \"value\"");
    return wrong;
}

double tolerance_at(const Json& ask, const char* key, const Where& where) {
    return has(ask, key) ? read_number(ask[key], where.key(key), {0.0, 1e12}) : 0.0;
}

void read_typed(const Json& object, Ask& ask, const Where& where) {
    ask.expect = expression_at(object, "expect", where, true);
    ask.tolerance = tolerance_at(object, "tol", where);
    ask.relative_tolerance = tolerance_at(object, "tol_rel", where);
    ask.up_to_factor = has(object, "up_to_factor") && read_bool(object["up_to_factor"], where.key("up_to_factor"));
    if (ask.kind == AskKind::vector)
        ask.rows = has(object, "size") ? read_whole(object["size"], where.key("size"), 2, 4) : 3;
    if (ask.kind == AskKind::matrix)
        ask.rows = ask.columns = has(object, "size") ? read_whole(object["size"], where.key("size"), 2, 4) : 4;
}

Ask read_ask(const Json& object, const LessonStep& step, const Where& where) {
    require_keys(object, where,
                 {"kind", "question", "hints", "choices", "items", "size", "expect", "tol", "tol_rel", "up_to_factor",
                  "until", "allow", "model", "wrong"});
    Ask ask;
    if (!has(object, "kind")) where.key("kind").refuse("is missing: one of " + joined(kind_names));
    ask.kind = static_cast<AskKind>(read_choice(object["kind"], where.key("kind"), kind_names));
    ask.question = text_at(object, "question", where, true);
    if (has(object, "hints")) {
        require_array(object["hints"], where.key("hints"), 9, "a list of texts");
        for (std::size_t i = 0; i < object["hints"].size(); ++i)
            ask.hints.push_back(read_text_of(object["hints"][i], where.key("hints").at(i)));
    }
    if (ask.kind == AskKind::choice) {
        ask.choices = read_choices(object, where);
    } else if (has_items(ask.kind)) {
        const Where items = where.key("items");
        if (!has(object, "items")) items.refuse("is missing: a list of texts");
        require_array(object["items"], items, 12, "a list of two to twelve texts");
        for (std::size_t i = 0; i < object["items"].size(); ++i)
            ask.items.push_back(read_text_of(object["items"][i], items.at(i)));
        if (ask.items.size() < 2) items.refuse("must be two or more");
        ask.expected_items = read_expected_items(object, ask.items.size(), where);
    } else if (ask.kind == AskKind::goal) {
        ask.until = expression_at(object, "until", where, true);
        ask.allow = names_at(object, "allow", where);
        for (std::size_t i = 0; i < ask.allow.size(); ++i)
            if (!find_field(ask.allow[i]) && !is_group(ask.allow[i])) refuse_unknown({where.prefix, ask.allow[i]});
        ask.model = settings_at(object, "model", where);
        if (ask.model.empty()) where.key("model").refuse("is missing: the settings that reach the goal");
        changed(step.start.params, ask.model, where.key("model"));
    } else {
        read_typed(object, ask, where);
    }
    if (has(object, "wrong")) {
        require_array(object["wrong"], where.key("wrong"), most_entries, "a list of wrong answers");
        for (std::size_t i = 0; i < object["wrong"].size(); ++i) {
            ask.wrong.push_back(read_wrong(object["wrong"][i], ask, where.key("wrong").at(i)));
            changed(step.start.params, ask.wrong.back().settings, where.key("wrong").at(i).key("try"));
        }
    }
    return ask;
}

void read_reveal(const Json& object, LessonStep& step, const Where& where) {
    require_keys(object, where, {"set", "over_s", "highlight", "say"});
    // A goal is reached by the one who answers: what the reveal adds, it adds to the model.
    const Params before = changed(step.start.params, step.ask.model, where);
    step.reveal.settings = settings_at(object, "set", where);
    step.revealed = changed(before, step.reveal.settings, where.key("set"));
    if (has(object, "over_s"))
        step.reveal.over_s = read_number(object["over_s"], where.key("over_s"), {0.0, longest_reveal_s});
    step.reveal.highlight = targets_at(object, "highlight", where);
    step.reveal.say = text_at(object, "say", where, true);
}

LessonStep read_step(const Json& object, const fs::path& folder, PresetShelf& presets, const Where& where) {
    require_keys(
        object, where,
        {"id", "state", "layout", "say", "cover", "highlight", "ask", "reveal", "claims", "claims_before", "note"});
    LessonStep step;
    if (!has(object, "id")) where.key("id").refuse("is missing: a name");
    step.id = read_name(object["id"], where.key("id"));
    const Where inside{where.prefix + "step " + excerpt(step.id) + ": ", ""};
    step.start = read_start(object, folder, presets, inside);
    step.target = read_target(object, inside);
    step.say = text_at(object, "say", inside, true);
    step.cover = targets_at(object, "cover", inside);
    step.highlight = targets_at(object, "highlight", inside);
    if (!has(object, "ask")) inside.key("ask").refuse("is missing: every step asks before it shows");
    step.ask = read_ask(object["ask"], step, inside.key("ask"));
    if (!has(object, "reveal")) inside.key("reveal").refuse("is missing");
    read_reveal(object["reveal"], step, inside.key("reveal"));
    step.claims_before = expressions_at(object, "claims_before", inside);
    step.claims = expressions_at(object, "claims", inside);
    step.note = text_at(object, "note", inside, false);
    return step;
}

// ---- the whole file ------------------------------------------------------------------------------------------------

std::vector<int> read_slides(const Json& object, const Where& where) {
    std::vector<int> slides;
    if (!has(object, "slides")) return slides;
    require_array(object["slides"], where.key("slides"), 100, "a list of slides' numbers");
    for (std::size_t i = 0; i < object["slides"].size(); ++i)
        slides.push_back(read_whole(object["slides"][i], where.key("slides").at(i), 1, 9999));
    return slides;
}

Lesson read_lesson(const Json& document, const fs::path& folder, const Where& where) {
    require_keys(document, where, {"lesson", "id", "title", "slides", "minutes", "picture", "needs", "tags", "steps"});
    if (!has(document, "lesson") || document["lesson"] != 1)
        where.key("lesson").refuse("must be 1, the version of the form that this program reads");
    Lesson lesson;
    if (!has(document, "id")) where.key("id").refuse("is missing: a name");
    lesson.id = read_name(document["id"], where.key("id"));
    lesson.title = text_at(document, "title", where, true);
    lesson.slides = read_slides(document, where);
    if (has(document, "minutes")) lesson.minutes = read_whole(document["minutes"], where.key("minutes"), 1, 600);
    lesson.needs = names_at(document, "needs", where);
    if (has(document, "tags")) {
        require_object(document["tags"], where.key("tags"), "an object of names and texts");
        for (const auto& [tag, text] : document["tags"].items())
            lesson.tags.emplace_back(tag, read_text_of(text, where.key("tags").key(tag)));
    }
    const Where steps = where.key("steps");
    if (!has(document, "steps")) steps.refuse("is missing: a list of steps");
    require_array(document["steps"], steps, most_steps, "a list of 1 to 200 steps");
    if (document["steps"].empty()) steps.refuse("must have one step or more");
    PresetShelf presets;
    if (has(document, "picture")) lesson.picture = state_at(document, "picture", folder, presets, where);
    for (std::size_t i = 0; i < document["steps"].size(); ++i) {
        lesson.steps.push_back(read_step(document["steps"][i], folder, presets, steps.at(i)));
        const std::string& id = lesson.steps.back().id;
        if (std::count_if(lesson.steps.begin(), lesson.steps.end(),
                          [&](const LessonStep& step) { return step.id == id; }) > 1)
            steps.at(i).key("id").refuse("another step has the id " + excerpt(id));
    }
    return lesson;
}

/// As much as a list shows, whatever else may be wrong with the file.
LessonFile glance_at(const fs::path& path) {
    LessonFile file{path.stem().string(), {path.stem().string(), ""}, {}, 0, 0, path};
    const Result<std::string> text = read_text_file(path);
    if (!text) return file;
    const auto glance = guarded([&] {
        const Json document = parse_document(*text, "");
        const Where root{"", ""};
        if (document.contains("id")) file.id = read_name(document["id"], root);
        if (document.contains("title")) file.title = read_text_of(document["title"], root);
        file.slides = read_slides(document, root);
        if (document.contains("minutes")) file.minutes = read_whole(document["minutes"], root, 1, 600);
        if (document.contains("steps")) file.steps = static_cast<int>(document["steps"].size());
        return true;
    });
    (void)glance;  // what could not be read stays as it was
    return file;
}

}  // namespace

Result<Lesson> parse_lesson(std::string_view json, const std::string& source, const fs::path& folder) {
    return guarded([&] {
        const Where root{source + ": ", ""};
        return read_lesson(parse_document(json, root.prefix), folder, root);
    });
}

std::vector<LessonFile> lessons() {
    std::vector<fs::path> paths;
    const fs::path assets = assets_directory();
    std::error_code error;
    for (fs::directory_iterator entry(assets / "lessons", error), end; !assets.empty() && !error && entry != end;
         entry.increment(error))
        if (entry->path().extension() == ".json") paths.push_back(entry->path());
    std::sort(paths.begin(), paths.end());
    std::vector<LessonFile> files;
    for (const fs::path& path : paths) files.push_back(glance_at(path));
    return files;
}

Result<Lesson> load_lesson(const std::string& argument) {
    fs::path path(argument);
    std::string source = argument;
    if (!path.has_parent_path() && path.extension() != ".json") {
        const std::vector<LessonFile> known = lessons();
        const auto at =
            std::find_if(known.begin(), known.end(), [&](const LessonFile& file) { return file.id == argument; });
        if (at == known.end()) {
            std::vector<std::string> ids;
            for (const LessonFile& file : known) ids.push_back(file.id);
            return Error{one_line(argument) +
                         ": neither a file nor a lesson (viewing-sandbox lesson --list lists them)" +
                         suggestion(argument, ids)};
        }
        path = at->path;
        source = path.filename().string();
    }
    const Result<std::string> text = read_text_file(path);
    if (!text) return Error{text.error()};
    Result<Lesson> lesson = parse_lesson(*text, source, path.parent_path());
    if (lesson) lesson->file = path;
    return lesson;
}

}  // namespace viewing
