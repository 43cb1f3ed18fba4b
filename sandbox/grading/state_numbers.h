// The numbers that expressions read from any state with its own scene. Exercises use them, because their variants are
// computed and judged independently of the window's current state.
#pragma once

#include <memory>

#include "grading/lesson_numbers.h"
#include "lesson/exercise.h"

namespace viewing {

/// Returns the numbers of `now`, with `start` as the start of the step. The error is that of loading the scene.
/// The renderer must outlive the result.
Result<Surroundings> numbers_of(const LoadedState& now, const Params& start, const Measurer& measurer);

/// Returns a function that calls numbers_of() for a state with itself as the start; used to compute variants.
NumbersAt numbers_at_start(const Measurer& measurer);

}  // namespace viewing
