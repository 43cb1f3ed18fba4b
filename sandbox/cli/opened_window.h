// A function shared by the commands that open a window.
#pragma once

#include "app/desktop/window.h"
#include "cli/exit_status.h"

namespace viewing {

/// Shows the window with this state until it is closed. Errors in the state's scene are reported before the window
/// opens, unless loading takes too long. Throws Failure for such errors, and also if there is no display or no GL, or
/// if VIEWING_SANDBOX_CHECK_GL is set and GL reports an error.
ExitStatus show_window(const LoadedState& state, const WindowStart& start, WindowMemory& memory);

}  // namespace viewing
