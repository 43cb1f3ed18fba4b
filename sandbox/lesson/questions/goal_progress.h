// The progress toward a goal: numbers of the current state beside the required ones.
#pragma once

#include <string>
#include <vector>

#include "lesson/formulas/expression.h"
#include "lesson/lesson.h"
#include "lesson/tree.h"

namespace viewing {

/// Whether one of a goal's numbers is measured, which may take a second.
bool has_measured_progress(const Ask& ask);

/// Returns the goal's numbers in these surroundings, as text: "(0.2, 0, −6.1)"; "—" for one that has no value.
std::vector<std::string> progress_of(const Ask& ask, const Surroundings& surroundings);

}  // namespace viewing
