// Reports the matrices of a state with their properties, as JSON. Read frame/derive.h for their computation.
#pragma once

#include <vector>

#include "frame/derive.h"
#include "frame/problems.h"
#include "state/file/document.h"

namespace viewing {

/// Returns the matrices as rows, under the names used in state files; "followed" is present only if a point is
/// followed.
Json matrices_as_json(const Derived& derived, const std::vector<Problem>& problems);

}  // namespace viewing
