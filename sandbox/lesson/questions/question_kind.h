// The entry of a kind of question: how questions of this kind are read, judged and described. Every kind in
// VIEWING_QUESTION_KINDS has an entry; related kinds share a file: choice_kind.cpp, number_kinds.cpp, item_kinds.cpp,
// goal_kind.cpp. ui/lesson/answer_input.h draws the questions.
#pragma once

#include <string>

#include "lesson/questions/judge.h"

namespace viewing {

namespace form {
template <typename T>
class Object;
}
struct LessonReading;

struct QuestionKind {
    /// Adds the question's members in a file.
    void (*read)(form::Object<LessonStep>& question, const LessonReading& reading);
    /// Adds the members that hold an example of a wrong answer.
    void (*read_wrong)(form::Object<LessonStep>& wrong);
    /// Whether the answer is right. Fails with an expression's error.
    Result<bool> (*is_right)(const Ask& ask, const Answer& answer, const Surroundings& surroundings);
    /// Whether the answer equals a wrong answer's example; null for kinds that never compare the two.
    bool (*are_same)(const Ask& ask, const Answer& answer, const Answer& sample) = nullptr;
    /// Says what is right about an answer that matches no known mistake; null if there is nothing to say.
    Verdict (*near)(const Ask& ask, const Answer& answer, const Surroundings& surroundings) = nullptr;
    /// See model_answer().
    Result<Answer> (*model)(const Ask& ask, const Surroundings& surroundings);
    /// Writes the model answer as words for the lecturer's notes.
    std::string (*in_words)(const Ask& ask, const Answer& model);
    int rows = 1, columns = 1;   ///< of the entered answer, unless the file says otherwise
    const char* between = ", ";  ///< between items in words
    bool is_on_screen = false;   ///< the answer is the state on the screen, which is judged whenever it changes
    bool is_typed = false;       ///< the answer is entered as numbers
    bool has_items = false;      ///< the answer consists of items that are chosen or put in order
    bool is_ordered = false;     ///< the order of these items counts
    bool sorts = false;          ///< the answer always has all items, and the user moves them
    bool needs_check = false;    ///< the answer is submitted with the Check button
};

namespace question_kinds {
using Entry = QuestionKind;
VIEWING_QUESTION_KINDS(VIEWING_ENTRY)
}  // namespace question_kinds

const QuestionKind& kind_of(const Ask& ask);

}  // namespace viewing
