#include "lesson/step_reader.h"

#include <algorithm>
#include <cmath>

#include "lesson/judge.h"
#include "lesson/progress.h"
#include "lesson/targets.h"
#include "lesson/typed_matrix.h"
#include "state/file/json.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr double longest_reveal_s = 60.0;
constexpr int most_points = 100, most_entries_of_vector = 12;

constexpr const char* kind_names[] = {"choice", "number",  "vector", "matrix", "sequence",
                                      "order",  "product", "subset", "goal"};

/// Reads the targets that a step covers or highlights.
std::vector<std::string> targets_at(const Json& object, const char* key, const Where& where, Mistakes& mistakes) {
    std::vector<std::string> targets;
    mistakes.part([&] { targets = names_at(object, key, where); });
    for (std::size_t i = 0; i < targets.size(); ++i)
        mistakes.part([&] {
            Result<std::string> target = read_target(targets[i]);
            if (!target) where.key(key).at(i).refuse(target.error());
            targets[i] = *std::move(target);
        });
    return targets;
}

/// Returns a number or a list of numbers in Lua's syntax.
std::string as_expression(const Json& value, const Where& where) {
    if (value.is_number()) return value.dump();
    require_array(value, where, most_entries, "an expression, a number or a list of numbers");
    std::string list;
    for (std::size_t i = 0; i < value.size(); ++i) list += (i == 0 ? "" : ", ") + as_expression(value[i], where.at(i));
    return "{" + list + "}";
}

}  // namespace

const LoadedState& PresetShelf::get(const std::string& name, const Where& where) {
    const auto known = states_.find(name);
    if (known != states_.end()) return known->second;
    if (name == "-" || name.find('/') != std::string::npos || name.ends_with(".json"))
        where.refuse("must be the name of a preset, got \"" + excerpt(name) + "\"");
    Result<LoadedState> state = load_state(name);
    if (!state) where.refuse(state.error());
    return states_.emplace(name, *std::move(state)).first->second;
}

std::string expression_in(const Json& value, const Where& where, const std::vector<std::string>& constants) {
    if (!value.is_string() && !value.is_number() && !value.is_array())
        refuse_value(value, where, "an expression, a number or a list of numbers");
    const std::string expression = value.is_string() ? value.get<std::string>() : as_expression(value, where);
    if (const Status fine = check_expression(expression, constants); !fine) where.refuse(fine.error());
    return expression;
}

namespace {

std::vector<std::string> expressions_at(const Json& object, const char* key, const Where& where,
                                        const std::vector<std::string>& constants, Mistakes& mistakes) {
    std::vector<std::string> expressions;
    if (!has(object, key)) return expressions;
    const Where inside = where.key(key);
    mistakes.part([&] {
        require_array(object[key], inside, most_entries, "a list of expressions");
        for (std::size_t i = 0; i < object[key].size(); ++i)
            mistakes.part([&] { expressions.push_back(expression_in(object[key][i], inside.at(i), constants)); });
    });
    return expressions;
}

std::string expression_at(const Json& object, const char* key, const Where& where, bool is_needed,
                          const std::vector<std::string>& constants) {
    if (!has(object, key)) {
        if (is_needed) where.key(key).refuse("is missing: an expression");
        return "";
    }
    return expression_in(object[key], where.key(key), constants);
}

std::vector<std::string> settings_at(const Json& object, const char* key, const Where& where) {
    return has(object, key) ? read_settings(object[key], where.key(key)) : std::vector<std::string>();
}

Params changed(const Params& params, const std::vector<std::string>& settings, const Where& where) {
    Result<Params> result =
        apply_settings(params, settings, where.prefix + (where.path.empty() ? "" : where.path + ": "));
    if (!result) throw Refusal(result.error());
    return *std::move(result);
}

// ---- a step's state ------------------------------------------------------------------------------------------------

/// A key of a step's layout, and its path in the state.
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

}  // namespace

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
    start.preset = nullptr;  // a step is not a preset, so the window never marks it as changed
    start.scene_origin = where.prefix + "scene";
    return start;
}

namespace {

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

std::vector<LessonChoice> read_choices(const Json& ask, const Where& where, Mistakes& mistakes) {
    const Where inside = where.key("choices");
    if (!has(ask, "choices")) inside.refuse("is missing: a list of answers");
    require_array(ask["choices"], inside, 9, "a list of two to nine answers");
    std::vector<LessonChoice> choices;
    bool are_read = true;
    for (std::size_t i = 0; i < ask["choices"].size(); ++i)
        are_read = mistakes.part([&] {
            const Json& choice = ask["choices"][i];
            const Where at = inside.at(i);
            require_keys(choice, at, {"say", "right", "why", "tag"});
            LessonChoice read{
                text_at(choice, "say", at, true), has(choice, "right") && read_bool(choice["right"], at.key("right")),
                text_at(choice, "why", at, false), has(choice, "tag") ? read_name(choice["tag"], at.key("tag")) : ""};
            if (!read.right && read.why.empty()) at.key("why").refuse("is missing: every wrong answer needs a reason");
            choices.push_back(std::move(read));
        }) && are_read;
    if (!are_read) return choices;
    const auto right =
        std::count_if(choices.begin(), choices.end(), [](const LessonChoice& choice) { return choice.right; });
    if (choices.size() < 2 || right != 1)
        inside.refuse("must have at least two answers, exactly one with \"right\": true");
    return choices;
}

std::vector<int> read_items(const Json& value, std::size_t count, const Where& where) {
    require_array(value, where, most_entries, "a list of item indices, from 0");
    std::vector<int> items;
    for (std::size_t i = 0; i < value.size(); ++i)
        items.push_back(read_whole(value[i], where.at(i), 0, static_cast<int>(count) - 1));
    return items;
}

/// Reads one list of indices, or several lists that are equally right.
std::vector<std::vector<int>> read_expected_items(const Json& ask, std::size_t count, const Where& where) {
    const Where inside = where.key("expect");
    if (!has(ask, "expect")) inside.refuse("is missing: a list of item indices, from 0");
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

WrongAnswer read_wrong(const Json& object, const Ask& ask, const std::vector<std::string>& constants,
                       const Where& where) {
    require_keys(object, where, {"when", "value", "try", "tag", "say", "points"});
    WrongAnswer wrong;
    wrong.when = expression_at(object, "when", where, false, constants);
    wrong.say = text_at(object, "say", where, true);
    if (has(object, "tag")) wrong.tag = read_name(object["tag"], where.key("tag"));
    if (has(object, "points")) wrong.points = read_whole(object["points"], where.key("points"), 1, most_points - 1);
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

void read_typed(const Json& object, Ask& ask, const std::vector<std::string>& constants, const Where& where) {
    ask.expect = expression_at(object, "expect", where, true, constants);
    ask.tolerance = tolerance_at(object, "tol", where);
    ask.relative_tolerance = tolerance_at(object, "tol_rel", where);
    ask.up_to_factor = has(object, "up_to_factor") && read_bool(object["up_to_factor"], where.key("up_to_factor"));
    if (ask.kind == AskKind::vector)
        ask.rows = has(object, "size") ? read_whole(object["size"], where.key("size"), 2, most_entries_of_vector) : 3;
    if (ask.kind == AskKind::matrix)
        ask.rows = ask.columns = has(object, "size") ? read_whole(object["size"], where.key("size"), 2, 4) : 4;
}

/// Reads the names that a step defines, each with a constant value. Returns a JSON object as text.
std::string read_constants(const Json& object, const Where& where) {
    require_object(object, where, "an object of names and values");
    for (const auto& [name, value] : object.items()) require_constant_name(name, where);
    return object.dump();
}

/// Reads the right answer. The kind of question is already known.
void read_right(const Json& object, const LessonStep& step, Ask& ask, const std::vector<std::string>& constants,
                const Where& where, Mistakes& mistakes) {
    if (ask.kind == AskKind::choice) {
        ask.choices = read_choices(object, where, mistakes);
    } else if (has_items(ask.kind)) {
        const Where items = where.key("items");
        if (!has(object, "items")) items.refuse("is missing: a list of strings");
        require_array(object["items"], items, 12, "a list of two to twelve strings");
        for (std::size_t i = 0; i < object["items"].size(); ++i)
            ask.items.push_back(read_text_of(object["items"][i], items.at(i)));
        if (ask.items.size() < 2) items.refuse("must have at least two items");
        ask.expected_items = read_expected_items(object, ask.items.size(), where);
    } else if (ask.kind == AskKind::goal) {
        ask.until = expression_at(object, "until", where, true, constants);
        ask.progress = read_progress(object, constants, where);
        ask.allow = names_at(object, "allow", where);
        for (std::size_t i = 0; i < ask.allow.size(); ++i)
            if (!find_field(ask.allow[i]) && !is_group(ask.allow[i])) refuse_unknown({where.prefix, ask.allow[i]});
        ask.model = settings_at(object, "model", where);
        if (ask.model.empty()) where.key("model").refuse("is missing: the settings that reach the goal");
        changed(step.start.params, ask.model, where.key("model"));
    } else {
        read_typed(object, ask, constants, where);
    }
    read_shown_matrix(object, ask, constants, where);
}

void read_ask(const Json& object, LessonStep& step, const Where& where, Mistakes& mistakes) {
    mistakes.part([&] {
        require_keys(object, where,
                     {"kind", "question", "hints", "choices", "items", "size", "expect", "tol", "tol_rel",
                      "up_to_factor", "factors", "shows_as", "until", "progress", "allow", "model", "wrong"});
    });
    if (!object.is_object()) return;
    Ask& ask = step.ask;
    const std::vector<std::string> constants = keys_of(constants_of(ask));
    const bool has_kind = mistakes.part([&] {
        if (!has(object, "kind")) where.key("kind").refuse("is missing: one of " + joined(kind_names));
        ask.kind = static_cast<AskKind>(read_choice(object["kind"], where.key("kind"), kind_names));
    });
    mistakes.part([&] { ask.question = text_at(object, "question", where, true); });
    mistakes.part([&] {
        if (!has(object, "hints")) return;
        require_array(object["hints"], where.key("hints"), 9, "a list of strings");
        for (std::size_t i = 0; i < object["hints"].size(); ++i)
            ask.hints.push_back(read_text_of(object["hints"][i], where.key("hints").at(i)));
    });
    if (!has_kind || !mistakes.part([&] { read_right(object, step, ask, constants, where, mistakes); })) return;
    if (!has(object, "wrong")) return;
    const Where wrong = where.key("wrong");
    mistakes.part([&] {
        require_array(object["wrong"], wrong, most_entries, "a list of wrong answers");
        for (std::size_t i = 0; i < object["wrong"].size(); ++i)
            mistakes.part([&] {
                ask.wrong.push_back(read_wrong(object["wrong"][i], ask, constants, wrong.at(i)));
                changed(step.start.params, ask.wrong.back().settings, wrong.at(i).key("try"));
            });
    });
}

void read_reveal(const Json& object, LessonStep& step, const Where& where, Mistakes& mistakes) {
    mistakes.part([&] { require_keys(object, where, {"set", "over_s", "highlight", "say"}); });
    if (!object.is_object()) return;
    mistakes.part([&] {
        // Showing the answer reaches the goal, so the reveal adds its changes to the goal's model.
        const Params before = changed(step.start.params, step.ask.model, where);
        step.reveal.settings = settings_at(object, "set", where);
        step.revealed = changed(before, step.reveal.settings, where.key("set"));
    });
    const Range range{0.0, longest_reveal_s};
    if (has(object, "over_s"))
        mistakes.part([&] { step.reveal.over_s = read_number(object["over_s"], where.key("over_s"), range); });
    step.reveal.highlight = targets_at(object, "highlight", where, mistakes);
    mistakes.part([&] { step.reveal.say = text_at(object, "say", where, true); });
}

}  // namespace

std::vector<std::string> expressions_at(const Json& object, const char* key, const Where& where,
                                        const std::vector<std::string>& constants) {
    Mistakes mistakes;
    std::vector<std::string> expressions = expressions_at(object, key, where, constants, mistakes);
    mistakes.refuse();
    return expressions;
}

LessonStep read_step(const Json& object, const fs::path& folder, PresetShelf& presets, const Where& where,
                     Mistakes& mistakes) {
    LessonStep step;
    mistakes.part([&] {
        require_keys(object, where,
                     {"id", "slides", "state", "layout", "let", "say", "cover", "highlight", "ask", "reveal", "claims",
                      "claims_before", "note"});
    });
    if (!object.is_object()) return step;
    Where inside = where;
    if (mistakes.part([&] { step.id = name_at(object, "id", where); }))
        inside = {where.prefix + "step " + excerpt(step.id) + ": ", ""};
    mistakes.part([&] { step.slides = read_slides(object, inside); });
    mistakes.part([&] { step.start = read_start(object, folder, presets, inside); });
    const bool shows_both = !has(object, "layout");  // as in a step saved in the window
    step.names_lower_left = shows_both || has(object["layout"], "lower_left");
    step.names_lower_right = shows_both || has(object["layout"], "lower_right");
    mistakes.part([&] { step.target = read_target(object, inside); });
    mistakes.part([&] { step.say = text_at(object, "say", inside, true); });
    step.cover = targets_at(object, "cover", inside, mistakes);
    step.highlight = targets_at(object, "highlight", inside, mistakes);
    mistakes.part([&] { step.note = text_at(object, "note", inside, false); });
    const bool has_constants = mistakes.part([&] {
        if (!has(object, "ask")) inside.key("ask").refuse("is missing: every step must ask a question");
        if (has(object, "let")) step.ask.constants = read_constants(object["let"], inside.key("let"));
    });
    if (has_constants) read_ask(object["ask"], step, inside.key("ask"), mistakes);
    mistakes.part([&] {
        if (!has(object, "reveal")) inside.key("reveal").refuse("is missing");
        read_reveal(object["reveal"], step, inside.key("reveal"), mistakes);
    });
    if (!has_constants) return step;  // expressions may use the missing constants
    const std::vector<std::string> constants = keys_of(constants_of(step.ask));
    step.claims_before = expressions_at(object, "claims_before", inside, constants, mistakes);
    step.claims = expressions_at(object, "claims", inside, constants, mistakes);
    return step;
}

}  // namespace viewing
