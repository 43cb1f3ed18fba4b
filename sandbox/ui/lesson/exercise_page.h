// The page of exercises: whose they are, what is done, and the way to each; and what a typed matrix does, beside the
// right one. Read session/exercise_desk.h for what stands behind it.
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
    /// Reads the exercises when they are wanted first.
    void open(ExerciseDesk& desk);
    void close() {
        is_open_ = false;
        chosen_.clear();
    }

    struct Wishes {
        bool save = false, open_answers = false;
    };
    /// Over everything. Begins what is chosen.
    Wishes draw(ExerciseDesk& desk, Guide& guide, Session& session, const Pictures& pictures);
    std::vector<CardPicture> wanted_pictures(const ExerciseDesk& desk) const;

private:
    std::vector<std::size_t> shown(const ExerciseDesk& desk) const;
    static void draw_student(ExerciseDesk& desk, Guide& guide);
    /// Whether it is practice, what that means, and the ways between practice and one's own sheet.
    static void draw_whose(ExerciseDesk& desk, Guide& guide);

    bool is_open_ = false;
    int set_ = 0;         ///< 0: all
    std::string chosen_;  ///< the exercise that is begun when all are made
};

/// Two pictures, larger: what a typed S or R makes of the scene, and what the right one does.
class TypedMatrix {
public:
    bool is_open() const { return mine_.has_value(); }
    /// Of a step that asks for S or R (Ask::shows_as).
    void open(const LessonRun& run);
    void close() { mine_.reset(); }
    void draw(const Pictures& pictures);
    std::vector<CardPicture> wanted_pictures() const;

private:
    std::optional<CardPicture> mine_, right_;
    std::string trouble_;  ///< why there is no picture of it
};

}  // namespace viewing
