// Leads a session through a lesson: puts in each step's state, waits with the answer, and shows it. What a person does
// in between is theirs; one call brings the step back. Read lesson/run.h for where one is in the lesson.
#pragma once

#include <optional>
#include <string>

#include "lesson/linked_step.h"
#include "lesson/run.h"
#include "platform/background.h"
#include "session/session.h"

namespace viewing {

class Guide {
public:
    /// Whether what is revealed moves there; else it is there at once, as people wish who are disturbed by motion.
    bool moves = true;

    /// A lesson's name or a file, read beside the window; `step` counts from 0 on.
    void open(const std::string& argument, std::size_t step = 0);
    /// The step that a lesson's link names.
    void open(const Link& link);
    /// One that is read already, whose step begins in the session at once.
    void begin(Lesson lesson, std::size_t step, Session& session);
    /// The same with what was done before.
    void begin(LessonRun run, Session& session);
    /// Called once a frame: takes what was read, and moves a reveal on by `dt_s`.
    void update(Session& session, double dt_s);

    /// The way through the lesson that is open; null without one.
    LessonRun* run() { return run_ ? &*run_ : nullptr; }
    const LessonRun* run() const { return run_ ? &*run_ : nullptr; }
    /// Whether it is to be seen; else it waits until one comes back to it.
    bool is_shown() const { return run_ && is_shown_; }
    bool is_reading() const { return reading_.is_running(); }

    /// Exploring freely, with the state as it is.
    void leave() { is_shown_ = false; }
    /// Back to the step.
    void resume(Session& session);
    /// Ends the lesson; nothing waits any more.
    void close();

    /// Whether what leads is a student's sheet of exercises: they are gone through in any order, and only a right
    /// answer shows what is covered.
    bool is_sheet() const { return run_ && run_->lesson().sheet.has_value(); }
    /// The next thing: the question's answer, then the next step's question. Nothing after the last one.
    void next(Session& session);
    /// The previous thing: the question again, then the step before, whole.
    void previous(Session& session);
    /// The question of that step, answered before or not.
    void go_to(std::size_t step, Session& session);
    /// The one that was shown before the last go_to().
    void go_back(Session& session);
    /// Shows the answer: what the reveal changes, and of a goal that is not reached its model.
    void reveal(Session& session);
    /// The step as it was written, before or after its answer.
    void return_to_step(Session& session);
    /// The parameters before the answer while it is held: a comparator by blinking. Nothing while a reveal goes on.
    void hold_before(bool is_held, Session& session);

    bool is_revealing() const { return reveal_.has_value(); }
    /// Whether the state is no longer the step's; theme and scale are the person's.
    bool departs(const Session& session) const;

private:
    struct Revealing {
        Params from, to;
        double over_s = 0.0, passed_s = 0.0;
    };
    /// What the step looks like now.
    const Params& shown() const { return run_->is_revealed() ? run_->step().revealed : run_->step().start.params; }
    void put(const Params& params, Session& session);
    /// The step that one has come to, with its question; of a sheet as one has left it.
    void arrive(Session& session);

    std::optional<LessonRun> run_;
    bool is_shown_ = false;
    std::size_t before_jump_ = 0;
    std::optional<Revealing> reveal_;
    std::optional<Params> held_;  ///< what comes back when the state before is let go
    BackgroundTask<LinkedStep> reading_;
};

}  // namespace viewing
