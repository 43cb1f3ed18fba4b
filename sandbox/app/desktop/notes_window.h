// The lecturer's notes in a window of their own, on another screen where there is one: large type, nothing to click.
// Closing it hides it; keys that are pressed in it are the lesson's.
//
// It is drawn in the GL context of the first window, by a second ImGui context that gets no input, into a texture which
// the second window's context shares and copies to its screen. So ImGui's backends know one context, and a notes window
// that is slow or gone disturbs nobody.
#pragma once

#include <memory>
#include <optional>

#include "gl/target.h"
#include "lesson/notes.h"
#include "state/params.h"
#include "ui/window/syllables.h"
#include "widgets/widgets.h"

struct GLFWwindow;
struct ImGuiContext;

namespace viewing {

class NotesWindow {
public:
    /// `main`: the window whose context is current, now and after each call. Null with a sentence on stderr where the
    /// display gives no second window.
    static std::unique_ptr<NotesWindow> make(GLFWwindow* main);
    ~NotesWindow();
    NotesWindow(const NotesWindow&) = delete;
    NotesWindow& operator=(const NotesWindow&) = delete;

    GLFWwindow* glfw() const { return window_; }
    /// Until the person closes it.
    bool is_shown() const;

    /// What is shown from the next draw() on.
    void set(Notes notes);
    /// Draws and shows it where something has changed: the notes, the window's size, the theme, or what lay over it.
    void draw(Theme theme, double device_scale);

private:
    NotesWindow(GLFWwindow* main, GLFWwindow* window);
    void lay_out(float width) const;
    void present();

    GLFWwindow *main_, *window_;
    ImGuiContext* imgui_;
    widgets::Fonts fonts_;
    Syllables korean_;
    float scale_ = 0.0F;
    Theme theme_ = Theme::dark;
    Notes notes_;
    bool is_stale_ = true;
    gl::ColorTarget target_;
    GLuint shared_framebuffer_ = 0;  ///< of the second context: textures are shared, framebuffers are not
};

}  // namespace viewing
