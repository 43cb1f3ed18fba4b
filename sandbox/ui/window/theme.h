// Returns the widgets' palette for the state's theme. The widgets themselves know nothing about the state.
#pragma once

#include "state/params.h"
#include "widgets/widgets.h"

namespace viewing {

const widgets::Palette& palette_of(Theme theme);

}  // namespace viewing
