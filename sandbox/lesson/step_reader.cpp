#include "lesson/step_reader.h"

#include <algorithm>
#include <cmath>

#include "lesson/formulas/expression.h"
#include "lesson/questions/question_form.h"
#include "lesson/target_names.h"
#include "state/file/schema.h"
#include "state/file/state_json.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {
namespace {

using form::Object;
using Names = std::vector<std::string>;

constexpr Range any_number{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

form::Form<Names> targets_form() {
    const auto in_window = [](const std::string& name, const Where& where) {
        Result<std::string> target = read_target(name);
        if (!target) where.refuse(target.error());
        return *std::move(target);
    };
    return form::list(form::name().then(in_window), "a list of names", {most_entries});
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

Params changed(const Params& params, const std::vector<std::string>& settings, const Where& where) {
    Result<Params> result =
        apply_settings(params, settings, where.prefix + (where.path.empty() ? "" : where.path + ": "));
    if (!result) throw Refusal(result.error());
    return *std::move(result);
}

const LoadedState& PresetShelf::get(const std::string& name, const Where& where) {
    const auto known = states_.find(name);
    if (known != states_.end()) return known->second;
    if (name == "-" || name.find('/') != std::string::npos || name.ends_with(".json"))
        where.refuse("must be the name of a preset, got \"" + excerpt(name) + "\"");
    Result<LoadedState> state = load_state(name);
    if (!state) where.refuse(state.error());
    return states_.emplace(name, *std::move(state)).first->second;
}

form::Form<std::string> expression_form(const LessonReading& reading) {
    const auto read = [&](const Json& value, const Where& where) {
        if (!value.is_string() && !value.is_number() && !value.is_array())
            refuse_value(value, where, "an expression, a number or a list of numbers");
        const std::string expression = value.is_string() ? value.get<std::string>() : as_expression(value, where);
        if (!reading.constants) return expression;
        if (const Status fine = check_expression(expression, *reading.constants); !fine) where.refuse(fine.error());
        return expression;
    };
    return {"an expression", {}, read, [](Json& definitions) {
                const Json numbers = numbers_form("numbers", any_number, most_entries).schema(definitions);
                return Json{{"$comment", "Only the program checks expressions."},
                            {"anyOf", {{{"type", "string"}}, numbers}}};
            }};
}

form::Form<Names> expressions_form(const LessonReading& reading) {
    return form::list(expression_form(reading), "a list of expressions", {most_entries});
}

form::Form<LoadedState> state_form(LessonReading& reading) {
    const auto load = [&](const std::string& name, const Where& where) { return reading.presets.get(name, where); };
    const auto change = [&](LoadedState& state, const Names& settings, const Where& where) {
        const SceneSource scene = state.params.scene;
        state.params = changed(state.params, settings, where);
        if (state.params.scene != scene) state.base = reading.folder;
    };
    return Object<LoadedState>()
        .optional("preset", form::name().then(load), std::identity())
        .optional("set", form::settings(), change)
        .form([&] { return reading.presets.get("opening", {}); })
        .strict();
}

LoadedState read_start(const Json* state, LessonReading& reading, const Where& where) {
    LoadedState start = state ? state_form(reading).read(*state, where) : reading.presets.get("opening", where);
    start.preset = nullptr;  // a step is not a preset, so the window never marks it as changed
    start.scene_origin = where.prefix + "scene";
    return start;
}

namespace {

/// If the step names one lower view and the state shows the same one in the other place, shows a neutral one there.
void avoid_twins(LessonStep& step) {
    ViewParams& view = step.start.params.view;
    if (view.lower_left != view.lower_right || step.names_lower_left == step.names_lower_right) return;
    Topic& other = step.names_lower_left ? view.lower_right : view.lower_left;
    other = neutral_beside(other);
}

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

Object<LessonStep> layout_form() {
    const auto point = form::vec3({-1e6, 1e6}, "[x, y, z]");
    const auto target = Object<LessonTarget>()
                            .required("point", point, &LessonTarget::point_world)
                            .optional("label", text_form(false), &LessonTarget::label);
    Object<LessonStep> layout;
    layout.optional("target", target.form(), &LessonStep::target)
        .optional("keeps_lens", form::boolean(), &LessonStep::keeps_lens);
    for (const LayoutPlace& place : layout_places) {
        const auto change = [place](LessonStep& step, const Json* value, const Where& where) {
            step.start.params = changed(step.start.params, {std::string(place.path) + "=" + value->dump()}, where);
            avoid_twins(step);
        };
        const auto schema = [place](Json&) { return field_schema(field(place.path)); };
        layout.optional(place.key, form::value("a value", schema), change);
    }
    return layout;
}

// ---- steps ---------------------------------------------------------------------------------------------------------

/// The names that a step defines, each with a constant value: a JSON object as text.
form::Form<std::string> constants_form(LessonReading& reading) {
    const auto read = [&](const Json& value, const Where& where) {
        reading.constants.reset();
        require_object(value, where, "an object of names and values");
        for (const auto& [name, constant] : value.items()) require_constant_name(name, where);
        reading.constants = keys_of(value);
        return value.dump();
    };
    return {"an object of names and values", {}, read, [](Json&) { return Json{{"type", "object"}}; }};
}

Object<LessonStep> reveal_form() {
    const auto set = [](LessonStep& step, const Names& settings, const Where& where) {
        step.reveal.settings = settings;
        step.revealed = changed(step.revealed, settings, where);
    };
    return Object<LessonStep>()
        .optional("set", form::settings(), set)
        .with(Object<Reveal>()
                  .optional("over_s", form::number({0.0, 60.0}), &Reveal::over_s)
                  .optional("highlight", targets_form(), &Reveal::highlight)
                  .required("say", text_form(true), &Reveal::say),
              &LessonStep::reveal);
}

}  // namespace

form::Form<LessonStep> step_form(LessonReading& reading) {
    const auto start = [&](LessonStep& step, const Json* state, const Where& where) {
        step.start = read_start(state, reading, where);
    };
    auto form = Object<LessonStep>()
                    .required("id", form::name(), &LessonStep::id)
                    .optional("slides", form::slides(), &LessonStep::slides)
                    .optional("state", form::value("a state", state_form(reading).schema), start)
                    .nested("layout", layout_form(), false)
                    .required("say", text_form(true), &LessonStep::say)
                    .optional("cover", targets_form(), &LessonStep::cover)
                    .optional("highlight", targets_form(), &LessonStep::highlight)
                    .optional("note", text_form(false), &LessonStep::note)
                    .optional("let", constants_form(reading), in_ask(&Ask::constants));
    add_ask(form, reading);
    form.nested("reveal", reveal_form(), true)
        .optional("claims_before", expressions_form(reading), &LessonStep::claims_before)
        .optional("claims", expressions_form(reading), &LessonStep::claims);
    const auto read = [&, form](const Json& value, const Where& where) {
        require_object(value, where, "an object");
        Where inside = where;
        if (has(value, "id") && value["id"].is_string())
            inside = {where.prefix + "step " + excerpt(value["id"].get<std::string>()) + ": ", "", where.mistakes};
        LessonStep step;
        step.start = read_start(nullptr, reading, inside);
        const bool shows_both = !has(value, "layout");  // as in a step saved in the window
        step.names_lower_left = shows_both || has(value["layout"], "lower_left");
        step.names_lower_right = shows_both || has(value["layout"], "lower_right");
        reading.constants.emplace();
        return form.read(value, inside, std::move(step));
    };
    return {"a step", &Json::is_object, read, form};
}

}  // namespace viewing
