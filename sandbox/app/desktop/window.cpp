// The GLFW window: takes events, presents frames, and sleeps in between. All drawing goes into the studio's own
// framebuffer and is copied to the window, so the window shows what a snapshot writes.
#include "app/desktop/window.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/desktop/events.h"
#include "app/desktop/full_screen.h"
#include "app/desktop/imgui_window.h"
#include "app/desktop/lecture_notes.h"
#include "app/desktop/lost_display.h"
#include "app/pictures_to_files.h"
#include "app/studio.h"
#include "gl/debug.h"
#include "platform/file.h"
#include "text/catalogue.h"

#define GLFW_INCLUDE_NONE  // the headers above already include the GL loader
#include <GLFW/glfw3.h>

namespace viewing {
namespace {

/// Starts GLFW. GLFW 3.4 tries Wayland first, and the Wayland library complains on stderr if the session has no folder
/// for its socket.
bool start_glfw() {
#ifdef GLFW_PLATFORM
    if (!std::getenv("XDG_RUNTIME_DIR")) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    return glfwInit() == GLFW_TRUE;
}

struct Glfw {
    bool started = start_glfw();
    /// Keeps a full-screen window on screen when another window gets the keyboard focus.
    Glfw() {
        if (started) glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
    ~Glfw() {
        if (started) glfwTerminate();
    }
};

struct DestroyWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using Window = std::unique_ptr<GLFWwindow, DestroyWindow>;

/// Returns GLFW's reason for its last failure, or `otherwise`.
std::string glfw_reason(const char* otherwise) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    std::string text = reason ? reason : otherwise;
    text.erase(text.find_last_not_of(' ') + 1);  // with an empty DISPLAY, the message ends with a space
    return text;
}

std::vector<WindowPlace> screens() {
    std::vector<WindowPlace> screens;
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        WindowPlace& screen = screens.emplace_back();
        glfwGetMonitorWorkarea(monitors[i], &screen.position.x, &screen.position.y, &screen.size.x, &screen.size.y);
    }
    return screens;
}

/// Restores the window's last position if that is still on a screen.
void restore_place(GLFWwindow* window, const std::optional<WindowPlace>& place) {
    if (!place || !is_reachable(*place, screens())) return;
    glfwSetWindowSize(window, place->size.x, place->size.y);
    glfwSetWindowPos(window, place->position.x, place->position.y);
    if (place->maximized) glfwMaximizeWindow(window);
}

Result<Window> make_window(bool checks_gl) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, checks_gl ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    int width = 1600, height = 900;
    if (GLFWmonitor* monitor = glfwGetPrimaryMonitor()) {
        int x = 0, y = 0, free_width = 0, free_height = 0;
        glfwGetMonitorWorkarea(monitor, &x, &y, &free_width, &free_height);
        if (free_width > 0) width = std::min(width, free_width);
        if (free_height > 0) height = std::min(height, free_height);
    }
    Window window(glfwCreateWindow(width, height, "Viewing Sandbox", nullptr, nullptr));
    if (!window) {
        return Error{"cannot open a window with OpenGL 3.3 core: " + glfw_reason("the display refused it") +
                     "; viewing-sandbox snapshot needs no display"};
    }
    glfwSetWindowSizeLimits(window.get(), 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
    return window;
}

/// Saves text that is still being typed when the window closes, by drawing two more frames that are not shown.
void keep_what_is_typed(GLFWwindow* window, Studio& studio, WindowMemory& memory, bool keeps_answers) {
    if (!widgets::IsTyping(studio.workbench.widgets)) return;
    widgets::EndTyping(studio.workbench.widgets);
    glm::ivec2 size_px(0);
    glfwGetFramebufferSize(window, &size_px.x, &size_px.y);
    float device_scale = 1.0F;
    glfwGetWindowContentScale(window, &device_scale, nullptr);
    for (int i = 0; i < 2; ++i) {  // the first frame ends the editing, the second records the change
        const Requests requests = studio.frame({glm::max(size_px, glm::ivec2(1)), device_scale, true, {}});
        studio.session.report(memory.follow(requests, studio.workbench, keeps_answers));
    }
}

void run_loop(GLFWwindow* window, Renderer& renderer, Studio& studio, Events& events, WindowMemory& memory,
              LectureNotes& notes, bool keeps_answers) {
    ImGuiWindow imgui_window(window);
    FullScreen full_screen;
    int frames_due = 0;
    const auto report = [&](const Status& status) {  // call after drawing the frame that the status is about
        studio.session.report(status);
        events.any |= !status;
    };
    // Process events from before the window was closed, too.
    while (!glfwWindowShouldClose(window) || !events.queue.is_empty()) {
        const bool closes = glfwWindowShouldClose(window) == GLFW_TRUE;
        if (!closes) events.take(frames_due > 0 || !events.queue.is_empty() ? 0.0 : studio.redraw_in_s());

        // A click takes effect in the first frame, which also lays out anything it opened; the second adjusts sizes.
        constexpr int frames_after_an_event = 2;
        frames_due = std::exchange(events.any, false) ? frames_after_an_event : std::max(frames_due - 1, 0);

        glm::ivec2 size_px(0);
        glfwGetFramebufferSize(window, &size_px.x, &size_px.y);
        if (size_px.x == 0 || size_px.y == 0) {  // minimized
            if (closes) break;
            glfwWaitEvents();
            continue;
        }
        float device_scale = 1.0F;
        glfwGetWindowContentScale(window, &device_scale, nullptr);
        imgui_window.show_pointer();
        int window_width = 0;
        glfwGetWindowSize(window, &window_width, nullptr);
        const float pixels_per_unit =
            window_width > 0 ? static_cast<float>(size_px.x) / static_cast<float>(window_width) : 1.0F;
        const InputFrame& frame = events.queue.next_frame(glfwGetTime());
        feed_imgui(frame, pixels_per_unit);
        if (frame.focus == true) memory.read_again(studio.workbench);
        ImGui::GetIO().DisplayFramebufferScale = {1.0F, 1.0F};
        const Requests requests = studio.frame({size_px, device_scale, true, frame.input});
        if (requests.snapshot) {
            write_snapshot(renderer, studio, ".");
            events.any = true;
        }
        if (requests.view_picture) {
            write_view_picture(renderer, studio, requests.view_picture->file);
            events.any = true;
        }
        report(memory.follow(requests, studio.workbench, keeps_answers));
        if (requests.toggle_full_screen) full_screen.toggle();
        if (requests.full_screen) full_screen.set(*requests.full_screen);
        full_screen.apply(window, notes.shown_window());
        studio.present();
        glfwSwapBuffers(window);
        report(notes.follow(studio.workbench.guide, studio.session, studio.workbench.presenter.presented_s()));
        notes.draw(studio.session.params.ui.theme, device_scale);
    }
    keep_what_is_typed(window, studio, memory, keeps_answers);
    Remembered last = memory.remembered();
    last.window = full_screen.place(window, last.window);
    Status flight_is_written = std::monostate{};
    if (const std::optional<Flight> flight = studio.workbench.recorder.end())
        flight_is_written = write_file(new_flight_file(), write_flight(*flight));
    for (const Status& written :
         {memory.remember(last), memory.finish(), studio.workbench.exercises.desk.finish(), flight_is_written})
        if (!written) std::cerr << written.error() << '\n';
}

}  // namespace

Status run_window(Session session, const WindowStart& start, WindowMemory& memory, int lost_display_status,
                  std::vector<std::string>* gl_errors) {
    const Glfw glfw;
    if (!glfw.started) {
        return Error{"there is no display for a window (" + glfw_reason("GLFW did not start") +
                     "); viewing-sandbox snapshot needs none"};
    }
    end_when_display_is_lost(lost_display_status);
    Result<Window> made = make_window(gl_errors != nullptr);
    if (!made) return Error{made.error()};
    GLFWwindow* window = made->get();
    restore_place(window, memory.remembered().window);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);

    std::optional<gl::DebugLog> log;
    if (gl_errors) log.emplace();
    Result<Renderer> renderer = Renderer::make();
    if (!renderer) return Error{renderer.error()};
    Studio studio(*renderer, std::move(session));
    Workbench& workbench = studio.workbench;
    memory.restore(workbench, !start.hand_in);
    workbench.link_address = start.link_address;
    if (start.lesson) {
        workbench.guide.begin(start.lesson->lesson, start.lesson->step, studio.session);
        if (start.lesson->presents) workbench.presenter.begin();
    }
    if (start.shows_lessons) workbench.start_page.open();
    if (start.hand_in) {
        workbench.exercises.desk.take_hand_in(*start.hand_in);
        workbench.exercises.go_to(start.exercise, start.replays);
    }
    const WakeUp wake_up;
    Events events(window);
    glfwShowWindow(window);
    if (!memory.trouble().empty()) studio.session.message = {memory.trouble(), true};
    LectureNotes notes(start.notes);
    if (notes.wants_window()) {
        if (auto beside = NotesWindow::make(window)) {
            events.hear_keys_of(beside->glfw());
            notes.take(std::move(beside));
        }
        glfwFocusWindow(window);
    }
    run_loop(window, *renderer, studio, events, memory, notes, !start.hand_in);
    if (gl_errors) *gl_errors = log->errors();
    return std::monostate{};
}

}  // namespace viewing
