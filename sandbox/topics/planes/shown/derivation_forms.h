// The lecture's three forms of the shadow matrix: for y = 0, with d, and with 4-vectors.
#pragma once

#include "topics/planes/numbers/derivation.h"

namespace viewing {

/// Shows the forms, side by side if they fit, each with its slide's symbols under the numbers. Also shows the largest
/// difference between the forms.
void show_three_forms(const ShadowForms& forms);

}  // namespace viewing
