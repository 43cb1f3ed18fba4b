#include "lesson/questions/judge.h"

#include <algorithm>

#include "lesson/questions/goal_progress.h"
#include "lesson/questions/question_kind.h"

namespace viewing {

Json constants_of(const Ask& ask) {
    return ask.constants.empty() ? Json::object() : Json::parse(ask.constants);
}

Surroundings with_constants(const Ask& ask, Surroundings surroundings) {
    surroundings.constants = constants_of(ask);
    return surroundings;
}

bool is_measured(const Ask& ask) {
    return is_measured(ask.expect) || is_measured(ask.until) || has_measured_progress(ask) ||
           std::any_of(ask.wrong.begin(), ask.wrong.end(),
                       [](const WrongAnswer& wrong) { return is_measured(wrong.when); });
}

Result<Answer> model_answer(const Ask& ask, const Surroundings& surroundings) {
    return kind_of(ask).model(ask, surroundings);
}

namespace {

/// Returns the answer as expressions see it: a number, a list of numbers, a list of rows, or a list of indices.
Json answer_as_json(const Ask& ask, const Answer& answer) {
    if (answer.empty()) return nullptr;
    if (answer.numbers.empty()) return Json(answer.items);
    if (ask.rows * ask.columns == 1) return answer.numbers.front();
    if (ask.columns == 1) return Json(answer.numbers);
    Json rows = Json::array();
    const auto columns = static_cast<std::ptrdiff_t>(ask.columns);
    for (auto row = answer.numbers.begin(); row != answer.numbers.end(); row += columns)
        rows.push_back(Json(std::vector<double>(row, row + columns)));
    return rows;
}

Result<Verdict> judged(const Ask& ask, const Answer& answer, const Surroundings& surroundings) {
    const QuestionKind& kind = kind_of(ask);
    const Result<bool> right = kind.is_right(ask, answer, surroundings);
    if (!right) return Error{right.error()};
    if (*right) return Verdict{.right = true};
    if (!ask.choices.empty()) {
        if (answer.items.empty()) return Verdict{};
        const LessonChoice& chosen = ask.choices[answer.items.front()];
        return Verdict{.say = chosen.why, .tag = chosen.tag};
    }
    for (const WrongAnswer& wrong : ask.wrong) {
        const Result<bool> does_fit = wrong.when.empty()
                                          ? Result<bool>(kind.are_same && kind.are_same(ask, answer, wrong.sample))
                                          : holds(wrong.when, surroundings);
        if (!does_fit) return Error{does_fit.error()};
        if (*does_fit) return Verdict{.say = wrong.say, .tag = wrong.tag, .points = wrong.points};
    }
    return kind.near ? kind.near(ask, answer, surroundings) : Verdict{};
}

}  // namespace

Result<Verdict> judge(const Ask& ask, const Answer& answer, Surroundings surroundings) {
    surroundings = with_constants(ask, std::move(surroundings));
    surroundings.answer = answer_as_json(ask, answer);
    Result<Verdict> verdict = judged(ask, answer, surroundings);
    if (verdict) verdict->progress = progress_of(ask, surroundings);
    return verdict;
}

}  // namespace viewing
