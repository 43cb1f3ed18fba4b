// What the commands that open a window share.
#pragma once

#include "app/desktop/window.h"
#include "cli/exit_status.h"

namespace viewing {

/// Until it is closed. Throws Failure: no display, no GL, or an error of GL where VIEWING_SANDBOX_CHECK_GL asks for it.
ExitStatus show_window(Session session, const WindowStart& start, WindowMemory& memory);

}  // namespace viewing
