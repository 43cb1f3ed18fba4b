// Reports the matrices of a state with their properties, as JSON. Read frame/derive.h for their computation.
#pragma once

#include <vector>

#include "frame/derive.h"
#include "frame/problems.h"
#include "state/file/document.h"

namespace viewing {

/// Returns the matrices, each as a list of rows, under names such as "clip_from_view"; "followed" is present only if a
/// point is followed.
Json matrices_as_json(const Derived& derived, const std::vector<Problem>& problems);

}  // namespace viewing
