#include "app/desktop/full_screen.h"

#include <algorithm>
#include <cstdint>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace viewing {
namespace {

/// In screen coordinates.
struct Area {
    glm::ivec2 min{0}, size{0};
};

Area window_area(GLFWwindow* window) {
    Area area;
    glfwGetWindowPos(window, &area.min.x, &area.min.y);
    glfwGetWindowSize(window, &area.size.x, &area.size.y);
    return area;
}

/// Returns the monitor that shows most of the window; null if there are no monitors.
GLFWmonitor* monitor_of(GLFWwindow* window) {
    const Area of_window = window_area(window);
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = nullptr;
    std::int64_t largest = -1;
    for (int i = 0; i < count; ++i) {
        glm::ivec2 corner(0);
        glfwGetMonitorPos(monitors[i], &corner.x, &corner.y);
        const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
        if (!mode) continue;
        const glm::ivec2 end = glm::min(of_window.min + of_window.size, corner + glm::ivec2(mode->width, mode->height));
        const glm::ivec2 shared = glm::max(end - glm::max(of_window.min, corner), glm::ivec2(0));
        const std::int64_t area = std::int64_t{shared.x} * shared.y;
        if (area > largest) {
            largest = area;
            best = monitors[i];
        }
    }
    return best;
}

bool is_only_monitor() {
    int count = 0;
    glfwGetMonitors(&count);
    return count == 1;
}

void set_place(GLFWwindow* window, const Area& area) {
    glfwSetWindowMonitor(window, nullptr, area.min.x, area.min.y, area.size.x, area.size.y, GLFW_DONT_CARE);
}

/// Moves the notes to the right side of the screen, and lets the stage fill the rest.
void share(GLFWmonitor* monitor, GLFWwindow* stage, GLFWwindow* notes) {
    constexpr int least_notes_width = 360;
    Area screen, border;  // border: left and top in min, right and bottom in size
    glfwGetMonitorWorkarea(monitor, &screen.min.x, &screen.min.y, &screen.size.x, &screen.size.y);
    glfwGetWindowFrameSize(notes, &border.min.x, &border.min.y, &border.size.x, &border.size.y);
    const int notes_width = std::max(screen.size.x / 4, least_notes_width);
    const int stage_width = screen.size.x - notes_width;
    if (glfwGetWindowAttrib(stage, GLFW_MAXIMIZED) == GLFW_TRUE) glfwRestoreWindow(stage);
    glfwSetWindowAttrib(stage, GLFW_DECORATED, GLFW_FALSE);
    set_place(stage, {screen.min, {stage_width, screen.size.y}});
    set_place(notes, {screen.min + glm::ivec2(stage_width, 0) + border.min,
                      glm::ivec2(notes_width, screen.size.y) - border.min - border.size});
}

}  // namespace

void FullScreen::apply(GLFWwindow* window, GLFWwindow* notes) {
    const Way way = !is_full_ ? Way::windowed : notes && is_only_monitor() ? Way::beside_notes : Way::whole;
    if (way == way_) return;
    GLFWmonitor* const monitor = monitor_of(window);
    if (way != Way::windowed && !monitor) return;
    if (way_ == Way::windowed) {
        const Area area = window_area(window);
        position_ = area.min;
        size_ = area.size;
    }
    way_ = way;
    if (way == Way::beside_notes) return share(monitor, window, notes);
    glfwSetWindowAttrib(window, GLFW_DECORATED, GLFW_TRUE);
    if (way == Way::windowed) return set_place(window, {position_, size_});
    const GLFWvidmode& mode = *glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(window, monitor, 0, 0, mode.width, mode.height, mode.refreshRate);
}

WindowPlace FullScreen::place(GLFWwindow* window, const std::optional<WindowPlace>& before) const {
    if (way_ != Way::windowed) return {position_, size_, false};
    const Area area = window_area(window);
    WindowPlace place{area.min, area.size, false};
    if (glfwGetWindowAttrib(window, GLFW_MAXIMIZED) != GLFW_TRUE) return place;
    place = before.value_or(place);
    place.maximized = true;
    return place;
}

}  // namespace viewing
