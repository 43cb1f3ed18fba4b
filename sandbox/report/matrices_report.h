// The matrices of a state with their facts, as JSON. Read frame/derive.h for where they come from.
#pragma once

#include <vector>

#include "frame/derive.h"
#include "frame/problems.h"
#include "state/file/document.h"

namespace viewing {

/// Rows of numbers by the names of the state file; "followed" stands only where a point is followed.
Json matrices_as_json(const Derived& derived, const std::vector<Problem>& problems);

}  // namespace viewing
