#include "lesson/step_reader.h"

#include <algorithm>
#include <cmath>

#include "lesson/expression.h"
#include "lesson/targets.h"
#include "lesson/typed_matrix.h"
#include "state/file/json.h"
#include "state/file/schema.h"
#include "state/scene.h"
#include "text/words.h"

namespace viewing {
namespace {

using form::Object;
using Names = std::vector<std::string>;

constexpr int most_tiles = 12;
constexpr Range any_number{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
constexpr const char* kind_names[] = {"choice", "number",  "vector", "matrix", "sequence",
                                      "order",  "product", "subset", "goal"};

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

Params changed(const Params& params, const std::vector<std::string>& settings, const Where& where) {
    Result<Params> result =
        apply_settings(params, settings, where.prefix + (where.path.empty() ? "" : where.path + ": "));
    if (!result) throw Refusal(result.error());
    return *std::move(result);
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
    layout.optional("target", target.form(), &LessonStep::target);
    for (const LayoutPlace& place : layout_places) {
        const auto change = [place](LessonStep& step, const Json* value, const Where& where) {
            step.start.params = changed(step.start.params, {std::string(place.path) + "=" + value->dump()}, where);
        };
        const auto schema = [place](Json&) { return field_schema(field(place.path)); };
        layout.optional(place.key, form::value("a value", schema), change);
    }
    return layout;
}

// ---- questions -----------------------------------------------------------------------------------------------------

template <typename V>
auto in_ask(V Ask::*member) {
    return [member](LessonStep& step) -> V& { return step.ask.*member; };
}

/// Returns that member of the wrong answer that is being read.
template <typename V>
auto in_wrong(V WrongAnswer::*member) {
    return [member](LessonStep& step) -> V& { return step.ask.wrong.back().*member; };
}

form::Form<std::vector<LessonChoice>> choices_form() {
    const auto has_reason = [](const LessonChoice& choice, const Where& where) {
        if (!choice.right && choice.why.empty())
            where.key("why").refuse("is missing: every wrong answer needs a reason");
    };
    const Json reason = Json::parse(R"([{"properties": {"right": {"const": true}}, "required": ["right"]},
        {"properties": {"why": {"$ref": "#/$defs/needed_text"}}, "required": ["why"]}])");
    const auto choice = Object<LessonChoice>()
                            .required("say", text_form(true), &LessonChoice::say)
                            .optional("right", form::boolean(), &LessonChoice::right)
                            .optional("why", text_form(false), &LessonChoice::why)
                            .optional("tag", form::name(), &LessonChoice::tag)
                            .form()
                            .then(has_reason, {{"anyOf", reason}})
                            .strict();
    const char* const rule = "must have at least two answers, exactly one with \"right\": true";
    const auto has_one_right = [rule](const std::vector<LessonChoice>& choices, const Where& where) {
        if (std::count_if(choices.begin(), choices.end(), [](const LessonChoice& one) { return one.right; }) != 1)
            where.refuse(rule);
    };
    return form::list(choice, "a list of two to nine answers", {9, 2, rule})
        .then(has_one_right, {{"contains", reason[0]}, {"maxContains", 1}});
}

form::Form<std::vector<int>> items_form() {
    return form::list(form::whole(0, most_tiles - 1), "a list of item indices, from 0", {most_entries});
}

void check_items(const std::vector<int>& items, const Ask& ask, const Where& where) {
    for (std::size_t i = 0; i < items.size() && !ask.items.empty(); ++i)  // empty: they have a mistake
        if (items[i] >= std::ssize(ask.items))
            where.at(i).refuse("must be a whole number from 0 to " + std::to_string(ask.items.size() - 1));
}

/// One list of indices, or several lists that are equally right.
form::Form<std::vector<std::vector<int>>> expected_items_form() {
    using Lists = std::vector<std::vector<int>>;
    auto several = form::list(items_form(), "a list of lists", {most_entries, 1});
    several.takes = [](const Json& value) { return value.is_array() && !value.empty() && value[0].is_array(); };
    return form::either<Lists>("a list of item indices, from 0",
                               {several, items_form().then([](const std::vector<int>& one) { return Lists{one}; })});
}

/// A goal's numbers, which it shows beside the required ones.
form::Form<std::vector<GoalNumber>> progress_form(const LessonReading& reading) {
    const auto number = Object<GoalNumber>()
                            .required("name", text_form(true), &GoalNumber::name)
                            .required("value", expression_form(reading), &GoalNumber::value)
                            .required("needed", text_form(true), &GoalNumber::needed);
    return form::list(number.form(), "a list of numbers to show", {3}).strict();
}

/// A wrong answer, which is recognized by an expression, by an example, or both.
Object<LessonStep> wrong_form(AskKind kind, const LessonReading& reading) {
    auto wrong = Object<LessonStep>()
                     .add("when", expression_form(reading), in_wrong(&WrongAnswer::when), kind == AskKind::goal)
                     .required("say", text_form(true), in_wrong(&WrongAnswer::say))
                     .optional("tag", form::name(), in_wrong(&WrongAnswer::tag))
                     .optional("points", form::whole(1, 99), in_wrong(&WrongAnswer::points));
    if (kind == AskKind::goal)
        return wrong.ignored({"value"}).optional("try", form::settings(),
                                                 [](LessonStep& step, const Names& settings, const Where& where) {
                                                     changed(step.start.params, settings, where);
                                                     step.ask.wrong.back().settings = settings;
                                                 });
    for (const char* const key : {"try", "value"}) {  // the value counts if both are given
        if (has_items(kind))
            wrong.optional(key, items_form(), [](LessonStep& step, const std::vector<int>& items, const Where& where) {
                check_items(items, step.ask, where);
                step.ask.wrong.back().sample.items = items;
            });
        else
            wrong.optional(
                key, numbers_form("sample", any_number, 16),
                [](LessonStep& step, const std::vector<double>& numbers, const Where& where) {
                    if (std::ssize(numbers) != step.ask.rows * step.ask.columns)
                        where.refuse("must have " + std::to_string(step.ask.rows * step.ask.columns) + " numbers");
                    step.ask.wrong.back().sample.numbers = numbers;
                });
    }
    const auto is_recognized = [](const Json& object, const Where& where) {
        const auto has_items_at = [&](const char* key) { return has(object, key) && object[key] != Json::array(); };
        if (!has(object, "when") && !has_items_at("value") && !has_items_at("try"))
            where.key("when").refuse("is missing: an expression, or \"value\"");
    };
    return wrong.rule({is_recognized, Json::parse(R"({"anyOf": [{"required": ["when"]}, {"required": ["value"]},
        {"required": ["try"]}]})")});
}

/// The parts of a question that all kinds have. Without a kind, it has one that is not known.
Object<LessonStep> question_form(std::optional<AskKind> kind) {
    auto kinds = form::choice<AskKind>(kind_names);
    if (kind) kinds.schema = [kind](Json&) { return Json{{"const", kind_names[static_cast<std::size_t>(*kind)]}}; };
    const auto set_kind = [](LessonStep& step, AskKind read) {
        step.ask.kind = read;
        step.ask.rows = read == AskKind::vector ? 3 : read == AskKind::matrix ? 4 : 1;
        step.ask.columns = read == AskKind::matrix ? 4 : 1;
    };
    return Object<LessonStep>()
        .required("kind", kinds, set_kind)
        .required("question", text_form(true), in_ask(&Ask::question))
        .optional("hints", form::list(text_form(false), "a list of strings", {9}), in_ask(&Ask::hints));
}

void add_items(Object<LessonStep>& question, AskKind kind, const LessonReading& reading) {
    const auto expect = [](LessonStep& step, const std::vector<std::vector<int>>& lists, const Where& where) {
        for (const std::vector<int>& items : lists) check_items(items, step.ask, where);
        step.ask.expected_items = lists;
    };
    question
        .required("items",
                  form::list(text_form(false), "a list of two to twelve strings",
                             {most_tiles, 2, "must have at least two items"})
                      .strict(),
                  in_ask(&Ask::items))
        .required("expect", expected_items_form(), expect);
    if (kind == AskKind::product || kind == AskKind::sequence)
        question.optional("factors", expressions_form(reading), in_ask(&Ask::factors))
            .optional("shows_as", form::name(), in_ask(&Ask::shows_as))
            .need({"shows_as"}, "factors");
}

void add_goal(Object<LessonStep>& question, const LessonReading& reading) {
    const auto is_field = [](const std::string& path, const Where& where) {
        if (!find_field(path) && !is_group(path)) refuse_unknown({where.prefix, path});
    };
    const auto model = form::settings().then(
        [](const Names& settings, const Where& where) {
            if (settings.empty()) where.refuse("is missing: the settings that reach the goal");
        },
        {{"minProperties", 1}});
    const auto set_model = [](LessonStep& step, const Names& settings, const Where& where) {
        step.revealed = changed(step.start.params, settings, where);
        step.ask.model = settings;
    };
    const auto allow = form::list(form::name().then(is_field), "a list of names", {most_entries});
    question.required("until", expression_form(reading), in_ask(&Ask::until))
        .optional("progress", progress_form(reading), in_ask(&Ask::progress))
        .optional("allow", allow, in_ask(&Ask::allow))
        .required("model", model, set_model);
}

void add_typed(Object<LessonStep>& question, AskKind kind, const LessonReading& reading) {
    const auto set_size = [](LessonStep& step, int size) {
        step.ask.rows = size;
        if (step.ask.kind == AskKind::matrix) step.ask.columns = size;
    };
    const auto tolerance = form::number({0.0, 1e12});
    question.required("expect", expression_form(reading), in_ask(&Ask::expect))
        .optional("tol", tolerance, in_ask(&Ask::tolerance))
        .optional("tol_rel", tolerance, in_ask(&Ask::relative_tolerance))
        .optional("up_to_factor", form::boolean(), in_ask(&Ask::up_to_factor));
    if (kind != AskKind::number) question.optional("size", form::whole(2, kind == AskKind::vector ? 12 : 4), set_size);
    if (kind == AskKind::matrix) question.optional("shows_as", form::name(), in_ask(&Ask::shows_as));
}

/// A question of one kind. Other kinds have further members, which are allowed but not read.
Object<LessonStep> question_of(std::optional<AskKind> kind, const LessonReading& reading) {
    Object<LessonStep> question = question_form(kind);
    if (kind == AskKind::choice) question.required("choices", choices_form(), in_ask(&Ask::choices));
    if (kind == AskKind::goal) add_goal(question, reading);
    if (kind && has_items(*kind)) add_items(question, *kind, reading);
    if (kind && is_typed(*kind)) add_typed(question, *kind, reading);
    if (kind) {
        const auto next = [](LessonStep& step) { step.ask.wrong.emplace_back(); };
        question.each("wrong", wrong_form(*kind, reading), "a list of wrong answers", {most_entries}, next);
        question.refused("factors", "belongs to questions of the kinds product and sequence");
        question.refused("shows_as", "belongs to a matrix, or to tiles with factors");
    }
    return question.ignored({"choices", "items", "expect", "factors", "shows_as", "until", "progress", "allow", "model",
                             "tol", "tol_rel", "up_to_factor", "size", "wrong"});
}

/// Adds a question, which is read as one of its kind.
void add_ask(Object<LessonStep>& step_form, const LessonReading& reading) {
    const auto kinds = std::make_shared<std::vector<Object<LessonStep>>>();
    for (std::size_t kind = 0; kind < std::size(kind_names); ++kind)
        kinds->push_back(question_of(static_cast<AskKind>(kind), reading));
    kinds->push_back(question_of(std::nullopt, reading));
    const auto schema = [kinds](Json& definitions) {
        Json schemas = Json::array();
        for (std::size_t kind = 0; kind < std::size(kind_names); ++kind) schemas.push_back((*kinds)[kind](definitions));
        return Json{{"anyOf", std::move(schemas)}};
    };
    const auto read = [kinds](LessonStep& step, const Json* value, const Where& where) {
        const std::string kind =
            value->is_object() && has(*value, "kind") && (*value)["kind"].is_string() ? (*value)["kind"] : "";
        step.revealed = step.start.params;
        const auto at = std::find(std::begin(kind_names), std::end(kind_names), kind) - std::begin(kind_names);
        if (where.part([&] { (*kinds)[static_cast<std::size_t>(at)].read_into(step, *value, where); }))
            check_shown_matrix(step.ask, where);
    };
    step_form.required("ask", form::value("every step must ask a question", schema), read);
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
