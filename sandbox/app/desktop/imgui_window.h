// Connects a GLFW window to Dear ImGui: key names, clipboard, and pointer shape. ImGui's own GLFW backend is not used:
// from 1.87 on it has a second input queue, whose pointer runs ahead of the events that our queue still holds.
#pragma once

#include <array>

#include <imgui.h>

struct GLFWcursor;
struct GLFWwindow;

namespace viewing {

/// Maps the keys that ImGui itself reads to GLFW's key codes, which are the indices into io.KeysDown.
void map_imgui_keys();

/// Connects a window to the ImGui context that is current during this object's lifetime.
class ImGuiWindow {
public:
    explicit ImGuiWindow(GLFWwindow* window);
    ~ImGuiWindow();
    ImGuiWindow(const ImGuiWindow&) = delete;
    ImGuiWindow& operator=(const ImGuiWindow&) = delete;

    /// Gives the pointer the shape that the last frame requested.
    void show_pointer();

private:
    GLFWwindow* window_;
    ImGuiMouseCursor shown_ = ImGuiMouseCursor_Arrow;
    std::array<GLFWcursor*, ImGuiMouseCursor_COUNT> shapes_{};  ///< null: not created yet, or the system's arrow
};

}  // namespace viewing
