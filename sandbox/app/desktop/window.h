// The window on screen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/picture.h"
#include "app/window_memory.h"
#include "lesson/hand_in.h"
#include "session/session.h"
#include "text/result.h"

namespace viewing {

/// How the window begins.
struct WindowStart {
    std::optional<LessonPicture> lesson;  ///< and leads through this one from there
    bool shows_lessons = false;           ///< the page of all lessons
    std::optional<HandIn> hand_in;        ///< and shows what this student handed in
    std::string exercise;                 ///< of it: which one
    bool replays = false;                 ///< plays how it was done
    std::string notes;                    ///< where the lecturer's notes go, as LectureNotes takes it
};

/// Opens the window on a session and returns when it is closed. The error says why there is none (no display, no
/// GL 3.3). When the display goes away meanwhile, the process ends with `lost_display_status` and one sentence on
/// stderr. Theme, scale and the window's place are remembered in `memory`. `gl_errors`: takes what GL complained of, of
/// a context that checks every call; null: GL is not watched.
Status run_window(Session session, const WindowStart& start, WindowMemory& memory, int lost_display_status,
                  std::vector<std::string>* gl_errors = nullptr);

}  // namespace viewing
