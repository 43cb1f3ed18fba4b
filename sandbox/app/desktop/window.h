// The window on screen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/picture.h"
#include "app/window_memory.h"
#include "lesson/hand_in.h"
#include "session/session.h"
#include "state/file/link.h"
#include "text/result.h"

namespace viewing {

/// The content that the window shows first.
struct WindowStart {
    std::optional<LessonPicture> lesson;     ///< the lesson to begin, and the step to begin with
    bool shows_lessons = false;              ///< shows the page of all lessons
    std::optional<HandIn> hand_in;           ///< a student's hand-in to show
    std::string exercise;                    ///< the exercise to show from the hand-in
    bool replays = false;                    ///< replays how the student solved the exercise
    std::string notes;                       ///< destination of the lecturer's notes, as in LectureNotes
    std::string link_address = link_base();  ///< the part of a link before its #
};

/// Opens the window on a session and returns when it is closed. The error says why there is no window (no display, or
/// no GL 3.3). If the display is lost while the window is open, the process ends with `lost_display_status` and one
/// sentence on stderr. `memory` remembers theme, scale and the window's position. `gl_errors` receives GL's error
/// messages, from a context that checks every call; if it is null, GL is not checked.
Status run_window(Session session, const WindowStart& start, WindowMemory& memory, int lost_display_status,
                  std::vector<std::string>* gl_errors = nullptr);

}  // namespace viewing
