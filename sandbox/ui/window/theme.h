// Returns the palette of the state's theme, since widgets know nothing about the state.
#pragma once

#include "state/params.h"
#include "widgets/widgets.h"

namespace viewing {

const widgets::Palette& palette_of(Theme theme);

}  // namespace viewing
