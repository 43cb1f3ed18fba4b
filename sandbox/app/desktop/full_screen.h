// Switches the window between its normal position and full screen. If the notes window is visible and there is only one
// screen, full screen gives the notes the right side and the window (the stage) the rest, so that neither covers the
// other.
#pragma once

#include <optional>

#include "state/person/remembered.h"

struct GLFWwindow;

namespace viewing {

class FullScreen {
public:
    void toggle() { is_full_ = !is_full_; }
    void set(bool is_full) { is_full_ = is_full; }

    /// Call once a frame. Applies the latest request, on the monitor that shows most of the window. `notes` is the
    /// notes window while it is visible, else null.
    void apply(GLFWwindow* window, GLFWwindow* notes);

    /// Returns the position and size that the window has outside full screen, to be remembered. For a maximized window,
    /// returns those in `before`: the ones it had before it was maximized.
    WindowPlace place(GLFWwindow* window, const std::optional<WindowPlace>& before) const;

private:
    enum class Way { windowed, whole, beside_notes };

    bool is_full_ = false;
    Way way_ = Way::windowed;
    glm::ivec2 position_{0}, size_{1280, 720};  ///< before full screen, in screen coordinates
};

}  // namespace viewing
