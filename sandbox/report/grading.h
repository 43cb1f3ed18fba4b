// Hand-ins judged again, from nothing but the student's number, the answers and the changes. Read lesson/hand_in.h for
// the file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lesson/exercise.h"
#include "lesson/hand_in.h"
#include "lesson/judge.h"
#include "render/renderer.h"

namespace viewing {

/// What an attempt is worth at a step that asks. A change of what the goal does not allow, and an answer that cannot be
/// one to the question, are wrong. The error is that of an expression or of a drawing.
Result<Verdict> judge_attempt(const LessonStep& step, const Attempt& attempt, Renderer& renderer);

enum class Standing {
    right,
    partly,
    wrong,
    missing,        ///< no answer was given
    other_variant,  ///< it is not this student's variant
    not_judged      ///< `trouble` says why
};

/// One exercise of one student.
struct ItemGrade {
    std::string exercise;
    std::size_t variant = 0;
    Standing standing = Standing::missing;
    int points = 0, of = 0;
    int tries = 0, hints = 0;
    bool at_first_try = false;
    std::vector<Verdict> verdicts;  ///< of every answer, in order
    std::string trouble;

    /// Of the last answer that was told apart; "" where none was.
    std::string last_tag() const;
};

struct StudentGrade {
    std::string file;
    std::string error;  ///< why the file cannot be read; all else is empty then
    HandIn hand_in;
    std::vector<ItemGrade> items;    ///< of all exercises that are asked for, in their order
    std::vector<std::string> notes;  ///< what somebody might look at; never a judgement

    int points() const;
    int of() const;
    int tried() const, at_first_try() const, hints() const;
    bool is_all_right() const;
};

/// A misconception over a class.
struct TagCount {
    std::string tag;
    LessonText text;
    int students = 0;     ///< who showed it at all
    int at_last = 0;      ///< for whom it was the last answer to an exercise
    int students_of = 0;  ///< who tried an exercise that knows it
};

class Grader {
public:
    Grader(std::vector<Exercise> exercises, Renderer& renderer);
    /// Ids that may stand in a file though they are not asked for.
    void also_know(std::vector<std::string> ids) { also_known_ = std::move(ids); }

    const std::vector<Exercise>& exercises() const { return exercises_; }
    /// `course`: in place of what the file says.
    StudentGrade grade(HandIn hand_in, const std::string& file, const std::optional<std::string>& course);
    /// The step of a variant, made once.
    const Result<LessonStep>& step(std::size_t exercise, std::size_t variant);

private:
    ItemGrade grade_item(std::size_t exercise, const HandIn& hand_in, const std::string& course);
    const Result<Verdict>& verdict(std::size_t exercise, std::size_t variant, const Attempt& attempt);

    std::vector<Exercise> exercises_;
    std::vector<std::string> also_known_;
    Renderer& renderer_;
    std::map<std::pair<std::size_t, std::size_t>, Result<LessonStep>> steps_;
    std::map<std::string, Result<Verdict>> verdicts_;  ///< by exercise, variant and answer
};

/// Adds notes on what two files have alike: times of attempts, and replays.
void compare_hand_ins(std::vector<StudentGrade>& grades);

/// The most frequent first; those of students who could be read.
std::vector<TagCount> count_tags(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades);

}  // namespace viewing
