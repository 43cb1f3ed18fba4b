#include "app/desktop/lecture_notes.h"

#include <unistd.h>

#include <cstdio>

#include "grading/lesson_numbers.h"
#include "platform/file.h"

namespace viewing {

Status LectureNotes::follow(const Guide& guide, const Session& session, double presented_s) {
    const LessonRun* const run = guide.run();
    if (target_.empty() || !run) return std::monostate{};
    const StepPhase phase = run->shows_end()       ? StepPhase::ended
                            : !run->is_revealed()  ? StepPhase::asks
                            : guide.is_revealing() ? StepPhase::shows
                                                   : StepPhase::answered;
    const Shown now{run->shared_lesson(),    run->index(),     phase, static_cast<int>(presented_s / 60.0),
                    session.scene_version(), spoken_language()};
    if (shown_ == now) return std::monostate{};
    shown_ = now;
    const Params& start = run->step().start.params;
    LessonNumbers numbers(start, start, session.scene(), nullptr);
    return show(notes_of(*run, phase, numbers.surroundings(), presented_s));
}

Status LectureNotes::show(Notes notes) {
    if (wants_window()) {
        if (window_) window_->set(std::move(notes));
        return std::monostate{};
    }
    const std::string page = notes_page(notes);
    if (target_ != "terminal") return write_file(target_, page);
    // Clear the terminal before each page; pages in a pipe or file follow one another.
    const bool is_screen = isatty(STDOUT_FILENO) == 1;
    std::fputs(((is_screen ? "\033[H\033[2J" : "") + page + (is_screen ? "" : "\n")).c_str(), stdout);
    std::fflush(stdout);
    return std::monostate{};
}

void LectureNotes::draw(Theme theme, double device_scale) {
    if (window_) window_->draw(theme, device_scale);
}

}  // namespace viewing
