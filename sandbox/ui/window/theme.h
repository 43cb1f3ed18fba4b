// The state's theme as the widgets know it: they know nothing of the state.
#pragma once

#include "state/params.h"
#include "widgets/widgets.h"

namespace viewing {

const widgets::Palette& palette_of(Theme theme);

}  // namespace viewing
