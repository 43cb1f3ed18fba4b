// The start page: the lessons as pictures in lecture order, each with its progress, and buttons that lead past them to
// a recent file, the exercises, or the free view. Also the page that shows a lesson's steps.
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

class StartPage {
public:
    bool is_open() const { return is_open_; }
    void open() { is_open_ = true; }
    void close() { is_open_ = false; }

    /// Returns the lessons; reads the list on first use.
    const std::vector<LessonFile>& lessons();

    /// Draws the page over the whole window and opens the lesson that the user chooses. Returns true if the caller
    /// should open the exercises. `recent`: recently opened files, latest first.
    bool draw(Guide& guide, Session& session, const LessonsProgress& progress, const std::vector<std::string>& recent,
              const Pictures& pictures);
    /// Returns the pictures that the page shows.
    std::vector<CardPicture> wanted_pictures();

private:
    bool is_open_ = false;
    std::optional<std::vector<LessonFile>> lessons_;
};

/// Draws the steps of the open lesson over the whole window; a click jumps to a step.
void draw_overview(PresenterMode& presenter, Guide& guide, Session& session, const Pictures& pictures);
std::vector<CardPicture> overview_pictures(const Guide& guide);

}  // namespace viewing
