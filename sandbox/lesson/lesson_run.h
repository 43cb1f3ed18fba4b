// One user's progress through a lesson: the step, the answers and the reveals. Independent of windows. Never changes
// parameters itself; session/guide.h changes them.
#pragma once

#include <glm/mat4x4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lesson/filled_text.h"
#include "lesson/questions/judge.h"
#include "lesson/votes.h"

namespace viewing {

class LessonRun {
public:
    /// `step` counts from 0 and is clamped to the lesson's range.
    explicit LessonRun(Lesson lesson, std::size_t step = 0);

    const Lesson& lesson() const { return *lesson_; }
    const std::shared_ptr<const Lesson>& shared_lesson() const { return lesson_; }
    std::size_t index() const { return index_; }
    const LessonStep& step() const { return lesson_->steps[index_]; }
    bool is_first() const { return index_ == 0; }
    bool is_last() const { return index_ + 1 == lesson_->steps.size(); }

    bool is_revealed() const { return now().revealed || step().only_shows(); }
    /// Shows the step's answer, after a right answer or on request.
    void reveal() {
        now().revealed = true;
        now().trouble.clear();
    }
    /// Shows the question again.
    void cover() { now().revealed = false; }
    void go_to(std::size_t step);

    /// Returns the card that follows the last step of a lesson, or of a part of a lecture; null if no card follows this
    /// step.
    const LessonEnd* end() const;
    /// Whether that card is shown instead of the step. go_to() hides it.
    bool shows_end() const { return shows_end_; }
    void show_end(bool shows) { shows_end_ = shows && end(); }

    /// Returns the answer entered or chosen so far; each step keeps its own.
    Answer& answer() { return now().answer; }
    const Answer& answer() const { return now().answer; }
    /// Returns the latest verdict on the answer; none before Check is pressed, or after the answer has changed.
    const std::optional<Verdict>& verdict() const { return now().verdict; }
    /// Keeps the verdict; a right one reveals the answer.
    void take(const Verdict& verdict);
    void forget_verdict() {
        now().verdict.reset();
        now().trouble.clear();
    }
    /// Why the latest answer could not be judged or pasted, "" if it could. The next answer or step clears it.
    const std::string& trouble() const { return now().trouble; }
    void tell_trouble(std::string sentence) { now().trouble = std::move(sentence); }
    /// Returns, for each number to be entered, the typed text if it is not a number; otherwise an empty text.
    std::vector<std::string>& unread() { return now().unread; }
    /// Returns the first text in unread() that is not empty; "" if every number can be read.
    std::string first_unread() const;
    /// Whether this choice was checked and is wrong.
    bool is_tried(std::size_t choice) const;
    /// Returns the state in which the student left an exercise; none before any change.
    std::optional<Params>& reached() { return now().reached; }
    const std::optional<Params>& reached() const { return now().reached; }

    /// The progress toward a goal: a text for each number of Ask::progress, and the state that was judged.
    struct GoalProgress {
        std::optional<Params> at;
        std::vector<std::string> numbers;
    };
    GoalProgress& progress() { return now().progress; }
    const GoalProgress& progress() const { return now().progress; }

    /// The products of the tiles' factors, from left to right, with the state and the tiles that they belong to.
    struct Products {
        std::optional<Params> at;
        std::vector<int> items;
        std::vector<glm::dmat4> matrices;
    };
    Products& products() { return now().products; }
    const Products& products() const { return now().products; }
    /// Returns the tiles that are shown: the chosen ones or, after the reveal, the right ones.
    const std::vector<int>& shown_items() const;

    /// Returns the right answer of a typed question, once it has been computed after the reveal.
    std::optional<Answer>& model() { return now().model; }

    /// Returns what the reveal says, with its numbers filled in once take_reveal() has been called.
    const LessonText& reveal_say() const { return now().reveal_say.empty() ? step().reveal.say : now().reveal_say; }
    /// Whether the reveal's numbers are still to be filled in.
    bool wants_reveal() const { return now().reveal_say.empty() && has_places(step().reveal.say); }
    void take_reveal(LessonText say) { now().reveal_say = std::move(say); }

    int hints_shown() const { return now().hints; }
    void show_hint();
    /// Returns the audience's votes on the step's choices; each step keeps its own.
    Ballot& ballot() { return now().ballot; }
    const Ballot& ballot() const { return now().ballot; }
    /// Restores earlier work on a step. `reached` is the value that reached() returns.
    void restore(std::size_t step, const Answer& answer, int hints, bool is_done, std::optional<Params> reached);
    bool is_done(std::size_t step) const { return visits_[step].done; }
    void set_done(std::size_t step) { visits_[step].done = true; }

private:
    struct Visit {
        bool revealed = false, done = false;
        Answer answer;
        std::optional<Verdict> verdict;
        std::string trouble;
        std::vector<std::string> unread;
        std::vector<int> tried;  ///< wrong choices
        std::optional<Answer> model;
        LessonText reveal_say;  ///< with its numbers; empty until they are filled in, and for a text without any
        GoalProgress progress;
        Products products;
        int hints = 0;
        Ballot ballot;
        std::optional<Params> reached;
    };
    Visit& now() { return visits_[index_]; }
    const Visit& now() const { return visits_[index_]; }

    std::shared_ptr<const Lesson> lesson_;  ///< shared with copies, since it never changes
    std::size_t index_ = 0;
    bool shows_end_ = false;
    std::vector<Visit> visits_;
};

}  // namespace viewing
