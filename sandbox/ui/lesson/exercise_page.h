// Two pages: one shows the student, the progress, and the list of exercises; the other compares a typed matrix with the
// right one. See session/exercise_desk.h for the data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/exercise_desk.h"
#include "session/guide.h"
#include "ui/lesson/start_page.h"

namespace viewing {

class ExercisePage {
public:
    bool is_open() const { return is_open_; }
    /// Reads the exercises on first use.
    void open(ExerciseDesk& desk);
    void close() {
        is_open_ = false;
        chosen_.clear();
    }

    struct Wishes {
        bool save = false, open_answers = false;
    };
    /// Draws the page over the whole window. Starts the exercise that the user chooses.
    Wishes draw(ExerciseDesk& desk, Guide& guide, Session& session, const Pictures& pictures);
    std::vector<CardPicture> wanted_pictures(const ExerciseDesk& desk) const;

private:
    std::vector<std::size_t> shown(const ExerciseDesk& desk) const;
    static void draw_student(ExerciseDesk& desk, Guide& guide);
    /// Says whether this is practice and what that means; lets the student switch between practice and their own sheet.
    static void draw_whose(ExerciseDesk& desk, Guide& guide);

    bool is_open_ = false;
    int set_ = 0;         ///< 0: all
    std::string chosen_;  ///< the exercise to start once all exercises are generated
};

/// A page with two large pictures: the scene with the typed matrix, and the scene with the right one.
class TypedMatrix {
public:
    bool is_open() const { return mine_.has_value(); }
    /// Opens the page for the step that `run` is at. The step's answer must be a matrix or a product, and its
    /// Ask::shows_as must not be empty.
    void open(const LessonRun& run);
    void close() { mine_.reset(); }
    void draw(const Pictures& pictures);
    std::vector<CardPicture> wanted_pictures() const;

private:
    std::optional<CardPicture> mine_, right_;
    std::string trouble_;  ///< why the typed matrix has no picture
};

}  // namespace viewing
