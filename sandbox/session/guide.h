// Guides a session through a lesson: sets each step's state, waits for the answer, and shows it. In between, the user
// may change anything; one call restores the step. Read lesson/lesson_run.h for the position in the lesson.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lesson/lesson_run.h"
#include "lesson/linked_step.h"
#include "platform/background.h"
#include "session/session.h"

namespace viewing {

class Guide {
public:
    /// Whether reveals are animated; otherwise they are instant, for users who are sensitive to motion.
    bool moves = true;

    /// Opens a lesson by its name or file, which is read in the background. `step` counts from 0.
    void open(const std::string& argument, std::size_t step = 0);
    /// Opens the step that a link to a lesson names.
    void open(const Link& link);
    /// Begins a lesson that has already been read; its step starts in the session immediately.
    void begin(Lesson lesson, std::size_t step, Session& session);
    /// Begins a run with earlier answers.
    void begin(LessonRun run, Session& session);
    /// Called once a frame: starts a lesson that has been read, rereads a lesson whose file has changed, and advances a
    /// reveal by `dt_s`.
    void update(Session& session, double dt_s);

    /// Returns the run of the open lesson; null if no lesson is open.
    LessonRun* run() { return run_ ? &*run_ : nullptr; }
    const LessonRun* run() const { return run_ ? &*run_ : nullptr; }
    /// Whether the lesson is visible; otherwise it waits for resume().
    bool is_shown() const { return run_ && is_shown_; }
    /// Whether the shown lesson comes from a user's own file, which may change. If so, update() must be called every
    /// second.
    bool watches_file() const;
    /// Makes the next update() check whether the lesson's file has changed.
    void look_at_file() { unwatched_s_ = 1e9; }
    bool is_reading() const { return reading_.is_running(); }

    /// Hides the lesson for free exploration, with the state unchanged.
    void leave() { is_shown_ = false; }
    /// Shows the lesson again and returns to its current step.
    void resume(Session& session);
    /// Ends the lesson, so that there is nothing to resume.
    void close();

    /// Whether a student's sheet of exercises is open: its steps can be taken in any order, and only a right answer
    /// reveals the covered parts.
    bool is_sheet() const { return run_ && run_->lesson().sheet.has_value(); }
    /// Goes to the question's answer, then to the next step's question; in a sheet, goes directly to the next step. If
    /// a reveal is in progress, only finishes it. The card that ends a lesson comes before the next step. After the
    /// last step and its card, does nothing.
    void next(Session& session);
    /// Goes back to the question, then to the previous step, with its answer if that was shown; in a sheet, goes
    /// directly to the previous step.
    void previous(Session& session);
    /// Goes to `step`. Shows the step's question even if it was answered before, except in a sheet.
    void go_to(std::size_t step, Session& session);
    /// Goes to the step that was shown before the last go_to().
    void go_back(Session& session);
    /// Shows the answer: the reveal's changes and, for a goal that was not reached, its model solution.
    void reveal(Session& session);
    /// Restores the step's state: the one after the answer if the answer is shown, otherwise the one before.
    void return_to_step(Session& session);
    /// Shows the parameters from before the answer while `is_held`, like a blink comparator. Does nothing during a
    /// reveal.
    void hold_before(bool is_held, Session& session);

    bool is_revealing() const { return reveal_.has_value(); }
    /// Whether the state differs from the step's state; theme, scale and language do not count.
    bool departs(const Session& session) const;

private:
    struct Revealing {
        Params from, to;
        double over_s = 0.0, passed_s = 0.0;
    };
    /// Returns the step's state: the one after the answer if the answer is shown, otherwise the one before.
    const Params& shown() const { return run_->is_revealed() ? run_->step().revealed : run_->step().start.params; }
    void put(const Params& params, Session& session);
    /// Reads the lesson again when its file has changed; stays at the current step, with its answer if that is shown.
    void follow_file(Session& session, double dt_s);
    /// Shows the new step with its question; in a sheet, restores the state in which the student left the step.
    void arrive(Session& session);

    std::optional<LessonRun> run_;
    bool is_shown_ = false;
    std::size_t before_jump_ = 0;
    std::optional<Revealing> reveal_;
    std::optional<Params> held_;  ///< restored when hold_before() ends
    BackgroundTask<LinkedStep> reading_;
    BackgroundTask<Lesson> reading_again_;
    std::optional<std::filesystem::file_time_type> file_time_;  ///< of the file as it was read
    double unwatched_s_ = 0.0;
};

}  // namespace viewing
