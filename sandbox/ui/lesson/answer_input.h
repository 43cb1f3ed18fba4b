// How a kind of question is answered in the window. Each kind of VIEWING_QUESTION_KINDS has an entry, in answers.cpp or
// in a source of its own; lesson/question_kind.h has its other half.
#pragma once

#include "ui/lesson/answers.h"

namespace viewing {

struct AnswerInput {
    /// See answers_height().
    float (*height)(const Ask& ask, float width, const widgets::Context& context, bool presents);
    /// See draw_answers(), which has already made the fonts larger for an audience.
    bool (*draw)(LessonRun& run, const AnswerStyle& style, float width);
};

namespace answer_inputs {
using Entry = AnswerInput;
VIEWING_QUESTION_KINDS(VIEWING_ENTRY)
}  // namespace answer_inputs

}  // namespace viewing
