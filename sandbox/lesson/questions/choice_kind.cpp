// A question with answers to choose from, one of which is right.
#include <algorithm>

#include "lesson/questions/question_form.h"

namespace viewing {
namespace {

using form::Object;

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

}  // namespace

constexpr QuestionKind question_kinds::choice{
    .read = [](Object<LessonStep>& question,
               const LessonReading&) { question.required("choices", choices_form(), in_ask(&Ask::choices)); },
    .read_wrong = read_wrong_numbers,
    .is_right = [](const Ask& ask, const Answer& answer, const Surroundings&) -> Result<bool> {
        return answer.items.size() == 1 && ask.choices[answer.items[0]].right;
    },
    .model = [](const Ask& ask, const Surroundings&) -> Result<Answer> {
        const auto right = std::find_if(ask.choices.begin(), ask.choices.end(),
                                        [](const LessonChoice& choice) { return choice.right; });
        return Answer{{}, {static_cast<int>(right - ask.choices.begin())}};
    },
    .in_words =
        [](const Ask& ask, const Answer& model) {
            const auto index = static_cast<std::size_t>(model.items.front());
            return std::string(1, static_cast<char>('A' + index)) + ": " + ask.choices[index].say.shown();
        },
};

}  // namespace viewing
