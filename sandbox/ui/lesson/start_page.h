// The first page: what the program is, where to begin, and the lessons in groups by topic, each with its progress.
// Buttons bypass the lessons and lead to a recent file, the exercises, or the free view. draw_overview() draws the page
// that shows a lesson's steps.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "session/guide.h"
#include "state/person/lesson_progress.h"
#include "ui/lesson/cards.h"
#include "ui/lesson/presenter.h"
#include "ui/views/views.h"

namespace viewing {

/// A picture to render in addition to the window: its key, and a function that loads its state. For a lesson step, this
/// is the state before the answer.
struct CardPicture {
    std::string key;
    std::function<Result<LoadedState>()> load;
    glm::ivec2 size_px{384, 216};
};

/// What the user has done before, now or in earlier runs of the program.
class Past {
public:
    LessonsProgress progress;         ///< in every lesson
    std::string last_lesson;          ///< the id of the lesson that was open last; "" for none
    std::vector<std::string> recent;  ///< opened files, latest first

    /// Notes the step that is shown and the steps that are done, except in a sheet of exercises or a lecture.
    void note(LessonRun& run);
    /// Called once a frame: notes a file as soon as it is open.
    void note_opened(const Session& session);

private:
    std::string opening_;      ///< the file being read
    std::string opened_mesh_;  ///< the scene's file, if the scene is a mesh file
};

class StartPage {
public:
    bool is_open() const { return is_open_; }
    void open() {
        is_open_ = true;
        gives_lecture_ = false;
    }
    void close() { is_open_ = false; }

    /// Returns the lessons; reads the list on first use.
    const std::vector<LessonFile>& lessons();

    /// Draws the page over the whole window and opens the lesson that the user chooses; for a lecture, opens it on
    /// stage. Returns true if the caller should open the exercises.
    bool draw(Guide& guide, PresenterMode& presenter, Session& session, const Past& past, const Pictures& pictures);
    /// Returns true once if the user has just chosen this lesson and had already done all of its steps.
    bool is_finished(const std::string& id) {
        if (id != finished_) return false;
        finished_.clear();
        return true;
    }
    /// Returns the pictures that the page shows.
    std::vector<CardPicture> wanted_pictures();

private:
    /// Draws the buttons that lead directly to a lesson. Returns the chosen lesson's index in lessons(), or none.
    std::optional<std::size_t> draw_beginnings(const Past& past);
    std::optional<std::size_t> draw_groups(const Past& past, const Pictures& pictures);

    bool is_open_ = false;
    bool gives_lecture_ = false;  ///< the next lesson is opened on stage
    bool continues_ = false;      ///< the chosen lesson is opened where the user left it, not at its beginning
    std::string finished_;        ///< the id of the chosen lesson if all of its steps are done, otherwise ""
    std::optional<std::vector<LessonFile>> lessons_;
};

/// Draws the steps of the open lesson over the whole window; a click jumps to a step.
void draw_overview(PresenterMode& presenter, Guide& guide, Session& session, const Pictures& pictures);
std::vector<CardPicture> overview_pictures(const Guide& guide);

}  // namespace viewing
