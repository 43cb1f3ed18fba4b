// Ends the program when the X server goes away while the window is open.
#pragma once

namespace viewing {

/// Makes the loss of the X server end the process with this exit status and one sentence on stderr; Xlib alone would
/// exit with 1. Does nothing if GLFW does not use X. Call after glfwInit().
void end_when_display_is_lost(int exit_status);

}  // namespace viewing
