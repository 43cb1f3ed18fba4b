// One student's exercise, ready to draw: at its start, or after the answer in a hand-in.
#pragma once

#include <string>

#include "lesson/hand_in.h"
#include "render/renderer.h"

namespace viewing {

struct ExercisePicture {
    Lesson lesson;  ///< a sheet with only this exercise
    Params params;  ///< at the exercise's start; for a goal, after the changes of the latest attempt
};

/// Makes the picture of one exercise. `exercise` is the id of a built-in exercise, or its short form. The error says
/// that there is no such exercise, or that the changes in the file cannot be applied.
Result<ExercisePicture> exercise_picture(const HandIn& hand_in, const std::string& exercise, Renderer& renderer);

}  // namespace viewing
