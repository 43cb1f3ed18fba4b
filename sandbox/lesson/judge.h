// Judges answers and picks the feedback. Pure, except for values that the surroundings look up.
#pragma once

#include <string>

#include "lesson/expression.h"
#include "lesson/lesson.h"

namespace viewing {

struct Verdict {
    bool right = false;
    LessonText say;   ///< why the answer is wrong; empty if it is right or not a known mistake
    std::string tag;  ///< the misconception
    int points = 0;   ///< in an exercise: points earned although the answer is not right
    int place = 0;    ///< for an unknown mistake: the row or entry with the largest difference, counted from 1
    bool operator==(const Verdict&) const = default;
};

/// Returns the names that the step defines, as an object; empty if there are none.
Json constants_of(const Ask& ask);
/// Returns the surroundings with the step's names as constants.
Surroundings with_constants(const Ask& ask, Surroundings surroundings);

/// Whether judging an answer needs a measurement, which may take a second.
bool is_measured(const Ask& ask);

/// Returns the answer as expressions see it: a number, a list of numbers, a list of rows, or a list of indices.
Json answer_as_json(const Ask& ask, const Answer& answer);

/// Computes the right answer in these surroundings; the result is empty for a goal. Fails with the expression's error.
Result<Answer> model_answer(const Ask& ask, const Surroundings& surroundings);

/// Judges an answer; for a goal, ignores `answer` and judges whether the goal is reached. Fills in
/// `surroundings.answer` itself. Reports the first known wrong answer that matches. Fails with an expression's error.
Result<Verdict> judge(const Ask& ask, const Answer& answer, Surroundings surroundings);

}  // namespace viewing
