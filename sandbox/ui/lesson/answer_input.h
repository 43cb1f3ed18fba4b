// How the user answers each kind of question in the window. Each kind of VIEWING_QUESTION_KINDS has an entry,
// most of them in answers.cpp. lesson/questions/question_kind.h has the part of each kind that does not depend on the
// window.
#pragma once

#include "ui/lesson/answers.h"

namespace viewing {

struct AnswerInput {
    /// See answers_height().
    float (*height)(const Ask& ask, float width, const widgets::Context& context, bool presents);
    /// See draw_answers(), which first enlarges the fonts for an audience.
    bool (*draw)(LessonRun& run, const AnswerStyle& style, float width);
};

namespace answer_inputs {
using Entry = AnswerInput;
VIEWING_QUESTION_KINDS(VIEWING_ENTRY)
}  // namespace answer_inputs

}  // namespace viewing
