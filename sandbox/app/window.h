// The window on screen.
#pragma once

#include "state/presets.h"
#include "text/result.h"

namespace viewing {

/// Opens the window and returns when it is closed. The error says why there is none (no display, no GL 3.3). When the
/// display goes away meanwhile, the process ends with `lost_display_status` and one sentence on stderr.
Status run_window(const LoadedState& state, int lost_display_status);

}  // namespace viewing
