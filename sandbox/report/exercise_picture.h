// An exercise of one student as it can be drawn: how it begins, or what a hand-in made of it.
#pragma once

#include <string>

#include "lesson/hand_in.h"
#include "render/renderer.h"

namespace viewing {

struct ExercisePicture {
    Lesson lesson;  ///< a sheet of this one exercise
    Params params;  ///< its beginning; after the changes of the latest attempt at a goal
};

/// `exercise`: an id or a short one, of the program's. The error: there is none of that name, or the file's changes
/// cannot be made.
Result<ExercisePicture> exercise_picture(const HandIn& hand_in, const std::string& exercise, Renderer& renderer);

}  // namespace viewing
