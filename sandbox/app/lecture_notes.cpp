#include "app/lecture_notes.h"

#include <unistd.h>

#include <cstdio>

#include "platform/file.h"
#include "report/lesson_numbers.h"

namespace viewing {

Status LectureNotes::follow(const Guide& guide, const Session& session, double presented_s) {
    const LessonRun* const run = guide.run();
    if (target_.empty() || !run) return std::monostate{};
    const StepPhase phase = !run->is_revealed()    ? StepPhase::asks
                            : guide.is_revealing() ? StepPhase::shows
                                                   : StepPhase::answered;
    const Shown now{run->shared_lesson(), run->index(), phase, static_cast<int>(presented_s / 60.0),
                    session.scene_version()};
    if (shown_ == now) return std::monostate{};
    shown_ = now;
    const Params& start = run->step().start.params;
    LessonNumbers numbers(start, start, session.scene(), nullptr);
    const std::string page = notes_page(*run, phase, numbers.surroundings(), presented_s);
    if (target_ != "terminal") return write_file(target_, page);
    // A screen of its own for each page; piped, one page follows another.
    const bool is_screen = isatty(STDOUT_FILENO) == 1;
    std::fputs(((is_screen ? "\033[H\033[2J" : "") + page + (is_screen ? "" : "\n")).c_str(), stdout);
    std::fflush(stdout);
    return std::monostate{};
}

}  // namespace viewing
