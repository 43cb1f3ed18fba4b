// The strip below the views while a lesson leads: what the step says, its question with the answers, and what to do
// next. In front of a room it has nothing to press. Read session/guide.h for what its buttons do.
#pragma once

#include <string>

#include "lesson/run.h"
#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

struct StripLook {
    bool presents = false;     ///< to a room: larger than what is around it, and without buttons
    bool departs = false;      ///< the state is no longer the step's: a dot says so
    std::string clock;         ///< of the timer; empty: none
    std::string trouble;       ///< why an answer could not be judged; empty: it could
    bool is_checking = false;  ///< what is measured takes a moment
};

/// What was pressed.
struct StripWishes {
    bool next = false, previous = false, again = false, check = false, leave = false, overview = false;
    bool paste = false, show_matrix = false;
};

/// Pixels below each other that the step needs at this width, before and after its answer, so that nothing jumps; also
/// outside a frame.
float strip_height(const LessonRun& run, float width, const widgets::Context& context, bool presents);

/// Edits the answer in the run. Hints are shown here.
StripWishes draw_strip(LessonRun& run, const Rect& rect, const StripLook& look);

}  // namespace viewing
