// Between the place that the window has and the whole of a screen. Where the notes share the only screen, the stage
// takes what they leave of it: neither lies behind the other.
#pragma once

#include <optional>

#include "state/person/remembered.h"

struct GLFWwindow;

namespace viewing {

class FullScreen {
public:
    void toggle() { is_full_ = !is_full_; }
    void set(bool is_full) { is_full_ = is_full; }

    /// Called once a frame: gives the window what was last asked for, on the monitor that shows most of it. `notes`:
    /// the window of the notes while it is on show, else null.
    void apply(GLFWwindow* window, GLFWwindow* notes);

    /// The window's place without it. `before`: of a window that is maximised now.
    WindowPlace place(GLFWwindow* window, const std::optional<WindowPlace>& before) const;

private:
    enum class Way { windowed, whole, beside_notes };

    bool is_full_ = false;
    Way way_ = Way::windowed;
    glm::ivec2 position_{0}, size_{1280, 720};  ///< of the window, in screen coordinates, while it is not windowed
};

}  // namespace viewing
