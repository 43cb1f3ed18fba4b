// Regrades hand-ins from the course, the student's number, the answers, and the changed settings alone. Each hand-in
// has its own budget, so that none of them delays a whole class. Read lesson/hand_in.h for the file.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grading/measurer.h"
#include "lesson/exercise.h"
#include "lesson/hand_in.h"
#include "lesson/questions/judge.h"

namespace viewing {

/// Judges an attempt at a step with a question. A change that the goal does not allow is wrong, and so is an answer
/// that does not fit the question. The error comes from an expression or from drawing.
Result<Verdict> judge_attempt(const LessonStep& step, const Attempt& attempt, const Measurer& measurer);

enum class Standing {
    right,
    partly,
    wrong,
    missing,        ///< no answer was given
    other_variant,  ///< not this student's variant
    not_judged      ///< `trouble` gives the reason
};

/// One student's result for one exercise.
struct ItemGrade {
    std::string exercise;
    std::size_t variant = 0;
    Standing standing = Standing::missing;
    int points = 0, of = 0;
    int tries = 0, hints = 0;
    bool at_first_try = false;
    /// One verdict per answer, in order; empty for an answer that exceeds the budget or was not judged in time.
    std::vector<std::optional<Verdict>> verdicts;
    std::string trouble;

    /// Returns the tag of the last answer; "" if that answer is right, not recognized, or not judged.
    std::string last_tag() const;
    std::size_t judged() const;  ///< number of answers with a verdict
};

struct StudentGrade {
    std::string file;
    std::string error;  ///< the reason why the file cannot be read; everything else is then empty
    HandIn hand_in;
    std::vector<ItemGrade> items;    ///< for all requested exercises, in their order
    std::vector<std::string> notes;  ///< hints for the lecturer; never a judgment
    bool is_cut = false;             ///< time ran out before all answers within the budget were judged

    /// What names the hand-in: the student number or, without one, the file.
    const std::string& name() const { return hand_in.student.empty() ? file : hand_in.student; }
    int points() const;
    int of() const;
    int tried() const, at_first_try() const, hints() const;
    bool is_all_right() const;
};

/// A misconception with its counts for a class.
struct TagCount {
    std::string tag;
    LessonText text;
    int students = 0;     ///< number of students with an answer that shows it
    int at_last = 0;      ///< number of students whose last answer to an exercise shows it
    int students_of = 0;  ///< number of students who tried an exercise that has this tag
};

/// Returns the order in which the answers to one exercise are judged while the budget lasts: the last one, the first
/// one, then those that the file calls right, and then all others; each of the last two groups goes from the latest to
/// the earliest. `answers` are the attempts without the hints; the result contains indices into it.
std::vector<std::size_t> order_of_judging(const std::vector<const Attempt*>& answers);

/// The budget of one file: each different answer costs 1, or cost_of_measured if it needs measured pictures. The last
/// and the first answer to each exercise are judged even if the budget is used up.
inline constexpr int budget_of_file = 2048, cost_of_measured = 100;

class Grader {
public:
    Grader(std::vector<Exercise> exercises, const Measurer& measurer);
    /// Sets the ids of exercises that a file may contain although they are not to be graded.
    void also_know(std::vector<std::string> ids) { also_known_ = std::move(ids); }

    /// Stops judging once `is_over` returns true; `why` then becomes ItemGrade::trouble for each exercise that has not
    /// been judged.
    void stop_when(std::function<bool()> is_over, std::string why);

    const std::vector<Exercise>& exercises() const { return exercises_; }
    /// Grades a hand-in. `course`, if given, replaces the course in the file. What was left out gets a note; an
    /// exercise without a readable answer is then not judged instead of missing.
    StudentGrade grade(ReadableHandIn handed_in, const std::string& file, const std::optional<std::string>& course);
    /// Returns the step for a variant; each step is made only once.
    const Result<LessonStep>& step(std::size_t exercise, std::size_t variant);

private:
    struct Turns;
    ItemGrade before_judging(std::size_t exercise, const ReadableHandIn& handed_in, const std::string& course);
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
    Measurer measurer_;
    std::map<std::pair<std::size_t, std::size_t>, Result<LessonStep>> steps_;
    std::map<std::string, Result<Verdict>> verdicts_;  ///< keyed by exercise, variant and answer
};

/// Adds notes about files with the same attempt times or the same replay, about several files from one student, and
/// about answers to another student's variant.
void compare_hand_ins(std::vector<StudentGrade>& grades);

/// Counts the tags in all readable files. Returns them with the most frequent one first.
std::vector<TagCount> count_tags(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades);

}  // namespace viewing
