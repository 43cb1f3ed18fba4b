// The strip below the views during a lesson: the step's text, its question with the answers, and the buttons. In
// presenter mode it has no buttons. See session/guide.h for the effect of each button.
#pragma once

#include <string>

#include "lesson/lesson_run.h"
#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

struct StripLook {
    bool presents = false;     ///< for an audience: choices in larger type, no buttons
    bool departs = false;      ///< the state differs from the step's, which a dot indicates
    std::string clock;         ///< the timer's text; empty if there is no timer
    bool is_checking = false;  ///< a measurement is still running
    bool can_edit = false;     ///< the lesson is the user's own: adds a button that edits the step
};

/// The buttons pressed in this frame.
struct StripWishes {
    bool next = false, previous = false, again = false, check = false, leave = false, overview = false;
    bool paste = false, show_matrix = false, edit = false;
};

/// Returns the height in pixels that the step needs at this width, both before and after its answer, so that nothing
/// jumps. Also works outside a frame.
float strip_height(const LessonRun& run, float width, const widgets::Context& context, const StripLook& look);

/// Returns the height of the tallest step in the lesson or, for a lecture, in its current part, so that the strip stays
/// in place from step to step.
float tallest_strip(const LessonRun& run, float width, const widgets::Context& context, const StripLook& look);

/// Draws the strip and edits the run's answer. If the user presses Hint, shows the next hint.
StripWishes draw_strip(LessonRun& run, const Rect& rect, const StripLook& look);

}  // namespace viewing
