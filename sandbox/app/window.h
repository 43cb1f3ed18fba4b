// The window on screen.
#pragma once

#include "session/session.h"
#include "text/result.h"

namespace viewing {

/// Opens the window on a session and returns when it is closed. The error says why there is none (no display, no
/// GL 3.3). When the display goes away meanwhile, the process ends with `lost_display_status` and one sentence on
/// stderr.
Status run_window(Session session, int lost_display_status);

}  // namespace viewing
