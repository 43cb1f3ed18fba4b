// A question that is answered by changing the state on the screen until a condition holds.
#include "lesson/questions/question_form.h"
#include "state/fields.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

using form::Object;
using Names = std::vector<std::string>;

/// The numbers that a goal shows, each beside the value that it must reach.
form::Form<std::vector<GoalNumber>> progress_form(const LessonReading& reading) {
    const auto number = Object<GoalNumber>()
                            .required("name", text_form(true), &GoalNumber::name)
                            .required("value", expression_form(reading), &GoalNumber::value)
                            .required("needed", text_form(true), &GoalNumber::needed);
    return form::list(number.form(), "a list of numbers to show", {3}).strict();
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

/// Returns "z-near = 0.3" for "projection.near=0.3", using the label that the panel shows.
std::string setting_in_words(const std::string& setting) {
    const std::size_t end = setting.find('=');
    const Field* const field = find_field(std::string_view(setting).substr(0, end));
    if (!field || end == std::string::npos) return setting;
    return std::string(tr_part(field->label)) + " = " + setting.substr(end + 1);
}

}  // namespace

constexpr QuestionKind question_kinds::goal{
    .read = add_goal,
    .read_wrong =
        [](Object<LessonStep>& wrong) {
            wrong.ignored({"value"}).optional("try", form::settings(),
                                              [](LessonStep& step, const Names& settings, const Where& where) {
                                                  changed(step.start.params, settings, where);
                                                  step.ask.wrong.back().settings = settings;
                                              });
        },
    .is_right = [](const Ask& ask, const Answer&,
                   const Surroundings& surroundings) { return holds(ask.until, surroundings); },
    .model = [](const Ask&, const Surroundings&) -> Result<Answer> { return Answer{}; },
    .in_words =
        [](const Ask& ask, const Answer&) {
            std::string words;
            for (const std::string& setting : ask.model)
                words += (words.empty() ? "" : ", ") + setting_in_words(setting);
            return words;
        },
    .is_on_screen = true,
};

}  // namespace viewing
