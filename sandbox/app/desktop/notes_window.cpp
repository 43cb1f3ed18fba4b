#include "app/desktop/notes_window.h"

#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <iostream>
#include <utility>

#include "app/looks.h"
#include "gl/dialect.h"
#include "ui/window/theme.h"

#define GLFW_INCLUDE_NONE  // the headers above already include the GL loader
#include <GLFW/glfw3.h>

namespace viewing {
namespace {

constexpr int first_width = 900, first_height = 700;
constexpr float design_width = 640.0F;  // in design pixels: text grows with the window

/// Makes another ImGui context current for a scope; ImGui has only one current context.
class InContext {
public:
    explicit InContext(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
        ImGui::SetCurrentContext(context);
    }
    ~InContext() { ImGui::SetCurrentContext(before_); }
    InContext(const InContext&) = delete;
    InContext& operator=(const InContext&) = delete;

private:
    ImGuiContext* before_;
};

/// Puts the notes on a monitor that does not show the first window, if there is one.
void place_beside(GLFWwindow* main, GLFWwindow* notes) {
    glm::ivec2 main_place(0), corner(0), size(0);
    glfwGetWindowPos(main, &main_place.x, &main_place.y);
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        glfwGetMonitorWorkarea(monitors[i], &corner.x, &corner.y, &size.x, &size.y);
        const glm::ivec2 inside = main_place - corner;
        if (inside.x >= 0 && inside.y >= 0 && inside.x < size.x && inside.y < size.y) continue;
        glfwSetWindowPos(notes, corner.x + size.x / 20, corner.y + size.y / 20);
        glfwSetWindowSize(notes, size.x * 9 / 10, size.y * 9 / 10);
        return;
    }
}

}  // namespace

std::unique_ptr<NotesWindow> NotesWindow::make(GLFWwindow* main) {
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_FALSE);
    GLFWwindow* const window = glfwCreateWindow(first_width, first_height, "Viewing Sandbox: notes", nullptr, main);
    if (!window) {
        std::cerr << "there is no window for the notes: the display refused a second window\n";
        return nullptr;
    }
    return std::unique_ptr<NotesWindow>(new NotesWindow(main, window));
}

NotesWindow::NotesWindow(GLFWwindow* main, GLFWwindow* window) : main_(main), window_(window) {
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(0);  // the main window sets the pace
    glfwMakeContextCurrent(main_);
    glfwSetWindowSizeLimits(window_, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
    place_beside(main_, window_);
    imgui_ = ImGui::CreateContext();
    const InContext ours(imgui_);
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().LogFilename = nullptr;
    ImGui_ImplOpenGL3_Init(gl::shader_version());
    glfwShowWindow(window_);
}

NotesWindow::~NotesWindow() {
    {
        const InContext ours(imgui_);
        ImGui_ImplOpenGL3_Shutdown();
    }
    ImGui::DestroyContext(imgui_);
    glfwMakeContextCurrent(window_);
    glDeleteFramebuffers(1, &shared_framebuffer_);
    glfwMakeContextCurrent(main_);
    glfwDestroyWindow(window_);
}

bool NotesWindow::is_shown() const {
    return glfwGetWindowAttrib(window_, GLFW_VISIBLE) == GLFW_TRUE;
}

void NotesWindow::set(Notes notes) {
    notes_ = std::move(notes);
    korean_.want(notes_.title);
    korean_.want(notes_.place);
    for (const Notes::Part& part : notes_.parts) {
        korean_.want(part.label);
        korean_.want(part.text);
    }
    is_stale_ = true;
}

/// Draws the notes with the labels in a separate column.
void NotesWindow::lay_out(float width) const {
    const widgets::Palette& palette = palette_of(theme_);
    const auto line = [](ImFont* font, ImU32 color, float x, float room, const std::string& text) {
        ImGui::SetCursorPosX(x);
        ImGui::PushFont(font);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(widgets::BrokenAtBlanks(text, room, *font).c_str());
        ImGui::PopStyleColor();
        ImGui::PopFont();
    };
    const float margin = ImGui::GetCursorPosX(), room = width - 2.0F * margin;
    line(fonts_.heading, palette.quiet, margin, room, notes_.title);
    line(fonts_.text, notes_.is_late ? palette.trouble : palette.quiet, margin, room, notes_.place);
    float column = 0.0F;
    for (const Notes::Part& part : notes_.parts)
        column =
            std::max(column, fonts_.text->CalcTextSizeA(fonts_.text->FontSize, FLT_MAX, 0.0F, part.label.c_str()).x);
    column += fonts_.text->FontSize;
    for (const Notes::Part& part : notes_.parts) {
        ImGui::Dummy({0.0F, fonts_.text->FontSize * 0.4F});
        const float top = ImGui::GetCursorPosY();
        ImGui::SetCursorPosY(top + fonts_.caption->Ascent - fonts_.text->Ascent);  // on the same baseline
        line(fonts_.text, palette.accent, margin, column, part.label);
        ImGui::SetCursorPosY(top);
        line(fonts_.caption, palette.text, margin + column, room - column, part.text);
    }
}

void NotesWindow::draw(Theme theme, double device_scale) {
    if (glfwWindowShouldClose(window_)) {  // only hidden: the lesson continues
        glfwSetWindowShouldClose(window_, GLFW_FALSE);
        glfwHideWindow(window_);
    }
    glm::ivec2 size_px(0);
    glfwGetFramebufferSize(window_, &size_px.x, &size_px.y);
    if (!is_shown() || size_px.x == 0 || size_px.y == 0) return;
    if (!is_stale_ && size_px == target_.size_px() && theme == theme_) return present();
    const InContext ours(imgui_);
    theme_ = theme;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size_px.x), static_cast<float>(size_px.y)};
    const float scale = std::max(static_cast<float>(device_scale), io.DisplaySize.x / design_width);
    if (scale != scale_ || korean_.has_new()) {
        fonts_ = upload_fonts(scale, korean_);
        scale_ = scale;
    }
    if (size_px != target_.size_px()) target_ = gl::ColorTarget(size_px);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {16.0F * scale, 12.0F * scale});
    ImGui::Begin("notes", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground);
    lay_out(io.DisplaySize.x);
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer());
    glViewport(0, 0, size_px.x, size_px.y);
    const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(palette_of(theme_).ground);
    glClearColor(ground.x, ground.y, ground.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    is_stale_ = false;
    present();
}

void NotesWindow::present() {
    glFlush();  // makes the drawing visible to the other context
    const glm::ivec2 size_px = target_.size_px();
    glfwMakeContextCurrent(window_);
    if (shared_framebuffer_ == 0) glGenFramebuffers(1, &shared_framebuffer_);
    // Attach the texture each time: only then is the other context's drawing guaranteed to be visible.
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shared_framebuffer_);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_.texture(), 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size_px.x, size_px.y, 0, 0, size_px.x, size_px.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(window_);
    glfwMakeContextCurrent(main_);
}

}  // namespace viewing
