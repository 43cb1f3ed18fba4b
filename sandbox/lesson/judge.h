// What is right and what is said to an answer. Pure, but for what the surroundings look up.
#pragma once

#include <string>

#include "lesson/expression.h"
#include "lesson/lesson.h"

namespace viewing {

struct Verdict {
    bool right = false;
    LessonText say;   ///< why it is wrong; empty where nothing fits, or where it is right
    std::string tag;  ///< the misconception
    int points = 0;   ///< of an exercise, though it is not right
    int place = 0;    ///< of what was typed and fits nothing: the row, or entry, with the largest difference, from 1 on
    bool operator==(const Verdict&) const = default;
};

/// The step's own names, an object; empty without any.
Json constants_of(const Ask& ask);
/// The same names and the step's own.
Surroundings with_constants(const Ask& ask, Surroundings surroundings);

/// Whether judging an answer measures something, which may take a second.
bool is_measured(const Ask& ask);

/// How the answer stands in expressions: a number, a list of numbers, a list of rows, or a list of places.
Json answer_as_json(const Ask& ask, const Answer& answer);

/// The right answer, computed for what the surroundings say; of a goal an empty one. The error is that of the
/// expression.
Result<Answer> model_answer(const Ask& ask, const Surroundings& surroundings);

/// Of a goal, whether it is reached; `answer` then is not looked at. `surroundings.answer` is set here. The first wrong
/// answer that fits is told. The error is that of an expression.
Result<Verdict> judge(const Ask& ask, const Answer& answer, Surroundings surroundings);

}  // namespace viewing
