// The lecture's three forms of the shadow matrix: for y = 0, with d, and with 4-vectors.
#pragma once

#include "frame/planes/derivation.h"

namespace viewing {

/// Shows each form with its slide's symbols under the numbers, side by side if they fit, and the largest difference
/// between them.
void show_three_forms(const ShadowForms& forms);

}  // namespace viewing
