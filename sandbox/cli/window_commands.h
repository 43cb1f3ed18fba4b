// A function shared by the commands that open a window.
#pragma once

#include "app/desktop/window.h"
#include "cli/exit_status.h"

namespace viewing {

/// Shows the window until it is closed. Throws Failure if there is no display or no GL, or if VIEWING_SANDBOX_CHECK_GL
/// is set and GL reports an error.
ExitStatus show_window(Session session, const WindowStart& start, WindowMemory& memory);

}  // namespace viewing
