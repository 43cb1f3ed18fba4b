#include "app/desktop/imgui_window.h"

#include <utility>

#include "ui/parts/imgui_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace viewing {
namespace {

constexpr std::pair<ImGuiKey, int> imgui_keys[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                                                   {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                                   {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                                   {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                                   {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                                   {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                                   {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                                   {ImGuiKey_Home, GLFW_KEY_HOME},
                                                   {ImGuiKey_End, GLFW_KEY_END},
                                                   {ImGuiKey_Insert, GLFW_KEY_INSERT},
                                                   {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                                   {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                                   {ImGuiKey_Space, GLFW_KEY_SPACE},
                                                   {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                                   {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                                   {imgui_keypad_enter, GLFW_KEY_KP_ENTER},
                                                   {ImGuiKey_A, GLFW_KEY_A},
                                                   {ImGuiKey_C, GLFW_KEY_C},
                                                   {ImGuiKey_V, GLFW_KEY_V},
                                                   {ImGuiKey_X, GLFW_KEY_X},
                                                   {ImGuiKey_Y, GLFW_KEY_Y},
                                                   {ImGuiKey_Z, GLFW_KEY_Z}};

/// Returns GLFW's standard shape for the cursor; 0 stands for the arrow.
int shape_of(ImGuiMouseCursor cursor) {
    switch (cursor) {
        case ImGuiMouseCursor_TextInput:
            return GLFW_IBEAM_CURSOR;
        case ImGuiMouseCursor_ResizeNS:
            return GLFW_VRESIZE_CURSOR;
        case ImGuiMouseCursor_ResizeEW:
            return GLFW_HRESIZE_CURSOR;
        case ImGuiMouseCursor_Hand:
            return GLFW_HAND_CURSOR;
#ifdef GLFW_RESIZE_ALL_CURSOR  // GLFW 3.4
        case ImGuiMouseCursor_ResizeAll:
            return GLFW_RESIZE_ALL_CURSOR;
        case ImGuiMouseCursor_ResizeNESW:
            return GLFW_RESIZE_NESW_CURSOR;
        case ImGuiMouseCursor_ResizeNWSE:
            return GLFW_RESIZE_NWSE_CURSOR;
        case ImGuiMouseCursor_NotAllowed:
            return GLFW_NOT_ALLOWED_CURSOR;
#endif
        default:
            return 0;
    }
}

}  // namespace

void map_imgui_keys() {
    for (const auto& [imgui, glfw] : imgui_keys) ImGui::GetIO().KeyMap[imgui] = glfw;
}

ImGuiWindow::ImGuiWindow(GLFWwindow* window) : window_(window) {
    map_imgui_keys();
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = window;
    io.GetClipboardTextFn = [](void* held) -> const char* {
        return glfwGetClipboardString(static_cast<GLFWwindow*>(held));
    };
    io.SetClipboardTextFn = [](void* held, const char* text) {
        glfwSetClipboardString(static_cast<GLFWwindow*>(held), text);
    };
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
}

ImGuiWindow::~ImGuiWindow() {
    for (GLFWcursor* shape : shapes_)
        if (shape) glfwDestroyCursor(shape);
}

void ImGuiWindow::show_pointer() {
    const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
    if (wanted == shown_ || wanted == ImGuiMouseCursor_None) return;
    shown_ = wanted;
    GLFWcursor*& shape = shapes_[wanted];
    if (const int standard = shape_of(wanted); !shape && standard != 0) shape = glfwCreateStandardCursor(standard);
    glfwSetCursor(window_, shape);
}

}  // namespace viewing
