// The list of the question kinds' entries, and the form of a question of each kind.
#include "lesson/questions/question_form.h"

#include <algorithm>
#include <array>
#include <memory>

#include "lesson/questions/typed_matrix.h"

namespace viewing {

namespace question_kinds {
constexpr std::array all{VIEWING_QUESTION_KINDS(VIEWING_ADDRESS)};
}

namespace {

using form::Object;

constexpr const char* kind_names[] = {VIEWING_QUESTION_KINDS(VIEWING_NAME)};

/// A wrong answer, which is recognized by an expression, by an example, or both.
Object<LessonStep> wrong_form(const QuestionKind& kind, const LessonReading& reading) {
    auto wrong = Object<LessonStep>()
                     .add("when", expression_form(reading), in_wrong(&WrongAnswer::when), kind.is_on_screen)
                     .required("say", text_form(true), in_wrong(&WrongAnswer::say))
                     .optional("tag", form::name(), in_wrong(&WrongAnswer::tag))
                     .optional("points", form::whole(1, 99), in_wrong(&WrongAnswer::points));
    kind.read_wrong(wrong);
    if (kind.is_on_screen) return wrong;
    const auto is_recognized = [](const Json& object, const Where& where) {
        const auto has_items_at = [&](const char* key) { return has(object, key) && object[key] != Json::array(); };
        if (!has(object, "when") && !has_items_at("value") && !has_items_at("try"))
            where.key("when").refuse("is missing: an expression, or \"value\"");
    };
    return wrong.rule({is_recognized, Json::parse(R"({"anyOf": [{"required": ["when"]}, {"required": ["value"]},
        {"required": ["try"]}]})")});
}

/// The parts of a question that all kinds have. `kind` is empty for a question whose kind is unknown.
Object<LessonStep> question_form(std::optional<AskKind> kind) {
    auto kinds = form::choice<AskKind>(kind_names);
    if (kind) kinds.schema = [kind](Json&) { return Json{{"const", kind_names[static_cast<std::size_t>(*kind)]}}; };
    const auto set_kind = [](LessonStep& step, AskKind read) {
        step.ask.kind = read;
        step.ask.rows = kind_of(step.ask).rows;
        step.ask.columns = kind_of(step.ask).columns;
    };
    return Object<LessonStep>()
        .required("kind", kinds, set_kind)
        .required("question", text_form(true), in_ask(&Ask::question))
        .optional("hints", form::list(text_form(false), "a list of strings", {9}), in_ask(&Ask::hints));
}

/// A question of one kind. Members that only other kinds have are allowed but not read, except factors and shows_as,
/// which are refused.
Object<LessonStep> question_of(std::optional<AskKind> kind, const LessonReading& reading) {
    Object<LessonStep> question = question_form(kind);
    if (kind) {
        const QuestionKind& entry = *question_kinds::all[static_cast<std::size_t>(*kind)];
        entry.read(question, reading);
        const auto next = [](LessonStep& step) { step.ask.wrong.emplace_back(); };
        question.each("wrong", wrong_form(entry, reading), "a list of wrong answers", {most_entries}, next);
        question.refused("factors", "belongs to questions of the kinds product and sequence");
        question.refused("shows_as", "belongs to a matrix, or to tiles with factors");
    }
    return question.ignored({"choices", "items", "expect", "factors", "shows_as", "until", "progress", "allow", "model",
                             "tol", "tol_rel", "up_to_factor", "size", "wrong"});
}

}  // namespace

const QuestionKind& kind_of(const Ask& ask) {
    return *question_kinds::all[static_cast<std::size_t>(ask.kind)];
}

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
        if (where.part([&] { (*kinds)[at].read_into(step, *value, where); })) check_shown_matrix(step.ask, where);
    };
    step_form.required("ask", form::value("every step must ask a question", schema), read);
}

}  // namespace viewing
