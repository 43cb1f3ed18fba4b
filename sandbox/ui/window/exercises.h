// The exercises in the window: the student's work, the pages that show it, and the exercise that is to open.
#pragma once

#include <string>

#include "session/replay.h"
#include "ui/lesson/exercise_page.h"
#include "ui/window/dialogs.h"

namespace viewing {

class Exercises {
public:
    ExerciseDesk desk;  ///< the current student's
    ExercisePage page;
    TypedMatrix typed_matrix;

    void open_page() { page.open(desk); }
    /// Goes to an exercise of the student's sheet once it is generated. `replays`: also plays the recorded solution.
    void go_to(const std::string& id, bool replays);
    /// Called once a frame: opens the wanted exercise, and records the student's work.
    void follow(Guide& guide, Replay& replay, Session& session);
    /// Draws the pages that are open. Uses the dialog to choose files with answers.
    void draw(Guide& guide, Session& session, FileDialog& dialog, const Pictures& pictures);

private:
    std::string wanted_;  ///< the exercise to open once it is generated
    bool wants_replay_ = false;
};

}  // namespace viewing
