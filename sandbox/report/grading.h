// Hand-ins judged again, from nothing but the student's number, the answers and the changes, each within a budget of
// its own so that none holds up a class. Read lesson/hand_in.h for the file.
#pragma once

#include <functional>
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
    /// Of every answer, in order; none of one beyond the budget, or that the time did not suffice for.
    std::vector<std::optional<Verdict>> verdicts;
    std::string trouble;

    /// Of the last answer that was told apart; "" where none was.
    std::string last_tag() const;
    std::size_t judged() const;  ///< how many answers have a verdict
};

struct StudentGrade {
    std::string file;
    std::string error;  ///< why the file cannot be read; all else is empty then
    HandIn hand_in;
    std::vector<ItemGrade> items;    ///< of all exercises that are asked for, in their order
    std::vector<std::string> notes;  ///< what somebody might look at; never a judgement
    bool is_cut = false;             ///< the time ran out before all was judged that should be

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

/// In which order so many answers of one exercise are judged while the budget lasts: the last one, the first one, those
/// that the file calls right from the latest on, then the others from the latest on. `answers`: the attempts without
/// the hints; the places are theirs.
std::vector<std::size_t> order_of_judging(const std::vector<const Attempt*>& answers);

/// What one file may cost: 1 for each different answer, more for one that pictures are measured for. The last and the
/// first answer of each exercise are judged beyond it.
inline constexpr int budget_of_file = 2048, cost_of_measured = 100;

class Grader {
public:
    Grader(std::vector<Exercise> exercises, Renderer& renderer);
    /// Ids that may stand in a file though they are not asked for.
    void also_know(std::vector<std::string> ids) { also_known_ = std::move(ids); }

    /// No answer is judged any more once `is_over`; `why` is then what an exercise says that has not been judged.
    void stop_when(std::function<bool()> is_over, std::string why);

    const std::vector<Exercise>& exercises() const { return exercises_; }
    /// `course`: in place of what the file says.
    StudentGrade grade(HandIn hand_in, const std::string& file, const std::optional<std::string>& course);
    /// The step of a variant, made once.
    const Result<LessonStep>& step(std::size_t exercise, std::size_t variant);

private:
    struct Turns;
    ItemGrade before_judging(std::size_t exercise, const HandIn& hand_in, const std::string& course);
    std::vector<Turns> turns_of(StudentGrade& grade);
    void judge_by_turns(StudentGrade& grade);
    void judge_next(Turns& turns);
    void sum_up(ItemGrade& item, bool is_cut) const;
    const Result<Verdict>& verdict(const std::string& key, const LessonStep& step, const Attempt& attempt);
    bool is_over() const { return is_over_ && is_over_(); }

    std::vector<Exercise> exercises_;
    std::vector<std::string> also_known_;
    std::function<bool()> is_over_;
    std::string why_over_;
    Renderer& renderer_;
    std::map<std::pair<std::size_t, std::size_t>, Result<LessonStep>> steps_;
    std::map<std::string, Result<Verdict>> verdicts_;  ///< by exercise, variant and answer
};

/// Adds notes on what two files have alike: times of attempts, and replays.
void compare_hand_ins(std::vector<StudentGrade>& grades);

/// The most frequent first; those of students who could be read.
std::vector<TagCount> count_tags(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades);

}  // namespace viewing
