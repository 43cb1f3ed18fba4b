// The numbers of any state for expressions, each with its own scene: for exercises, whose variants are computed and
// judged far from the window's one state.
#pragma once

#include <memory>

#include "lesson/exercise.h"
#include "report/lesson_numbers.h"

namespace viewing {

/// Of `now`, with `start` as the beginning that it is compared with. The error is the scene's. `renderer` may be null,
/// as LessonNumbers takes it, and outlives what is returned.
Result<Surroundings> numbers_of(const LoadedState& now, const Params& start, Renderer* renderer);

/// The same of a start itself, as variants ask for it.
NumbersAt numbers_at_start(Renderer* renderer);

}  // namespace viewing
