// The shadow matrix as the lecture has it three times: for y = 0, with d, and as 4-vectors.
#pragma once

#include "frame/planes/derivation.h"

namespace viewing {

/// With the symbols of its slide under each number, side by side where there is room, and how far they differ.
void show_three_forms(const ShadowForms& forms);

}  // namespace viewing
