// One person's way through a lesson: which step, what was answered, whether it is revealed. Knows no window and changes
// no parameters itself; session/lesson_session.h does what it says.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lesson/judge.h"

namespace viewing {

class LessonRun {
public:
    /// `step` counts from 0 on and is put into the lesson's range.
    explicit LessonRun(Lesson lesson, std::size_t step = 0);

    const Lesson& lesson() const { return *lesson_; }
    const std::shared_ptr<const Lesson>& shared_lesson() const { return lesson_; }
    std::size_t index() const { return index_; }
    const LessonStep& step() const { return lesson_->steps[index_]; }
    bool is_first() const { return index_ == 0; }
    bool is_last() const { return index_ + 1 == lesson_->steps.size(); }

    bool is_revealed() const { return now().revealed; }
    /// Whether the step shows its answer: by an answer that was right, or because it was asked to.
    void reveal() { now().revealed = true; }
    /// The question again.
    void cover() { now().revealed = false; }
    void go_to(std::size_t step);

    /// What is typed or chosen so far; kept for each step.
    Answer& answer() { return now().answer; }
    const Answer& answer() const { return now().answer; }
    /// The latest judgement of it; none before Check was pressed, or since it was changed.
    const std::optional<Verdict>& verdict() const { return now().verdict; }
    /// A right one reveals.
    void take(const Verdict& verdict);
    void forget_verdict() { now().verdict.reset(); }
    /// Of an exercise: what one had made of its state when one left it; none before anything was changed.
    std::optional<Params>& reached() { return now().reached; }
    const std::optional<Params>& reached() const { return now().reached; }

    int hints_shown() const { return now().hints; }
    void show_hint();
    /// Hands that were raised for each choice, as the lecturer counts them.
    std::vector<int>& votes() { return now().votes; }
    /// What was done at a step another time. `reached`: as reached() has it.
    void restore(std::size_t step, const Answer& answer, int hints, bool is_done, std::optional<Params> reached);
    bool is_done(std::size_t step) const { return visits_[step].done; }
    int done_count() const;
    void set_done(std::size_t step) { visits_[step].done = true; }

private:
    struct Visit {
        bool revealed = false, done = false;
        Answer answer;
        std::optional<Verdict> verdict;
        int hints = 0;
        std::vector<int> votes;
        std::optional<Params> reached;
    };
    Visit& now() { return visits_[index_]; }
    const Visit& now() const { return visits_[index_]; }

    std::shared_ptr<const Lesson> lesson_;  ///< shared with copies: it never changes
    std::size_t index_ = 0;
    std::vector<Visit> visits_;
};

}  // namespace viewing
