// What a person sees first: the lessons as pictures in the order of the lecture, with how far one is in each; or the
// way past them. Also the page of a lesson's steps.
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

/// A picture of a lesson's step before its answer: its name, and how its state is had, beside the window.
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

    /// Reads the list of lessons when it is wanted first.
    const std::vector<LessonFile>& lessons();

    /// Over everything. Opens what is chosen; true: the exercises, by whoever has them. `recent`: files that were
    /// opened before, the latest first.
    bool draw(Guide& guide, Session& session, const LessonsProgress& progress, const std::vector<std::string>& recent,
              const Pictures& pictures);
    /// Pictures that it shows.
    std::vector<CardPicture> wanted_pictures();

private:
    bool is_open_ = false;
    std::optional<std::vector<LessonFile>> lessons_;
};

/// The steps of the lesson that is open, over everything; a click goes there.
void draw_overview(PresenterMode& presenter, Guide& guide, Session& session, const Pictures& pictures);
std::vector<CardPicture> overview_pictures(const Guide& guide);

}  // namespace viewing
