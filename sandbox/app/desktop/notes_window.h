// The lecturer's notes in their own window, on another screen if there is one. It has large text and nothing to click.
// Closing the window only hides it; keys pressed in it control the lesson.
//
// The first window's GL context draws the notes into a texture, using a second ImGui context that gets no input. The
// notes window's GL context shares this texture and copies it to the screen. ImGui's backends therefore use only one GL
// context, and a slow or missing notes window does not disturb the lecture.
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
    /// `main` is the window whose context is current now and after every call. Returns null, with a sentence on stderr,
    /// if the display allows no second window.
    static std::unique_ptr<NotesWindow> make(GLFWwindow* main);
    ~NotesWindow();
    NotesWindow(const NotesWindow&) = delete;
    NotesWindow& operator=(const NotesWindow&) = delete;

    GLFWwindow* glfw() const { return window_; }
    /// True until the user closes the window.
    bool is_shown() const;

    /// Sets the notes to show from the next draw() on.
    void set(Notes notes);
    /// Redraws the notes if they, the window's size or the theme have changed, and copies them to the screen. Call once
    /// a frame.
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
    GLuint shared_framebuffer_ = 0;  ///< belongs to the second context: contexts share textures, not framebuffers
};

}  // namespace viewing
