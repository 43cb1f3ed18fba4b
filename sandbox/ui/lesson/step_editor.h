// An editor beside the shown step of the user's own lesson. It edits the step's texts and answers, the order of the
// steps, and the states of the step's question and answer. Each edit is written to the file, which the guide then reads
// again.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lesson/edit_steps.h"
#include "session/guide.h"
#include "ui/parts/layout.h"

namespace viewing {

class StepEditor {
public:
    void open() { is_open_ = true; }
    void close() { is_open_ = false; }
    bool is_open() const { return is_open_; }
    /// Draws the editor over `area` if a lesson of the user's own is shown.
    void draw(Guide& guide, Session& session, const Rect& area);
    /// Returns the texts that the editor shows, so that the fonts can be loaded with their characters.
    std::vector<std::string> texts() const;

private:
    /// Reads the file again if the guide has done so, and reads the parts of the shown step.
    void follow(const LessonRun& run);
    /// Writes an edited file. If the edited text is not a lesson, does not write it, and shows the error.
    void write(const Result<std::string>& text, Guide& guide);
    void draw_steps(Guide& guide, Session& session);
    void draw_states(Guide& guide, Session& session);
    void draw_parts(Guide& guide);

    bool is_open_ = false;
    std::shared_ptr<const Lesson> lesson_;  ///< the lesson whose file `source_` holds
    std::size_t step_ = 0;
    Language language_ = Language::en;
    LessonSource source_;
    std::vector<StepPart> parts_;
    std::vector<std::string> earlier_;  ///< the file's texts before each edit
    std::string error_;
};

}  // namespace viewing
