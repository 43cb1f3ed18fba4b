// What happens when the X server goes away under the window.
#pragma once

namespace viewing {

/// From now on, losing the connection to the X server ends the process with this exit status and one sentence on
/// stderr; Xlib by itself would end it with 1. Does nothing where GLFW uses no X. Call after glfwInit().
void end_when_display_is_lost(int exit_status);

}  // namespace viewing
