// GLFW: events in, frames out, and asleep in between. All drawing goes into the studio's own framebuffer and is copied
// to the window, so the window shows what a snapshot writes.
#include "app/window.h"

#include <backends/imgui_impl_glfw.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <string>
#include <utility>

#include "app/lost_display.h"
#include "app/studio.h"
#include "image/png.h"

#define GLFW_INCLUDE_NONE  // GL comes from the loader above
#include <GLFW/glfw3.h>

namespace viewing {
namespace {

struct Glfw {
    bool started = glfwInit() == GLFW_TRUE;
    Glfw() = default;
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

struct KeyName {
    int glfw;
    Key key;
};
constexpr KeyName key_names[] = {{GLFW_KEY_W, Key::w},
                                 {GLFW_KEY_A, Key::a},
                                 {GLFW_KEY_S, Key::s},
                                 {GLFW_KEY_D, Key::d},
                                 {GLFW_KEY_Q, Key::q},
                                 {GLFW_KEY_E, Key::e},
                                 {GLFW_KEY_R, Key::r},
                                 {GLFW_KEY_F, Key::f},
                                 {GLFW_KEY_LEFT, Key::left},
                                 {GLFW_KEY_RIGHT, Key::right},
                                 {GLFW_KEY_UP, Key::up},
                                 {GLFW_KEY_DOWN, Key::down},
                                 {GLFW_KEY_LEFT_SHIFT, Key::shift},
                                 {GLFW_KEY_RIGHT_SHIFT, Key::shift},
                                 {GLFW_KEY_LEFT_CONTROL, Key::ctrl},
                                 {GLFW_KEY_RIGHT_CONTROL, Key::ctrl},
                                 {GLFW_KEY_M, Key::m},
                                 {GLFW_KEY_C, Key::c},
                                 {GLFW_KEY_V, Key::v},
                                 {GLFW_KEY_Z, Key::z},
                                 {GLFW_KEY_Y, Key::y},
                                 {GLFW_KEY_O, Key::o},
                                 {GLFW_KEY_B, Key::b},
                                 {GLFW_KEY_N, Key::n},
                                 {GLFW_KEY_F1, Key::f1},
                                 {GLFW_KEY_F2, Key::f2},
                                 {GLFW_KEY_F3, Key::f3},
                                 {GLFW_KEY_F11, Key::f11},
                                 {GLFW_KEY_F12, Key::f12},
                                 {GLFW_KEY_ESCAPE, Key::escape}};

/// Events of the window collected until the next frame. Letters are taken by what the keyboard's layout prints.
struct Events {
    FrameInput input;
    std::vector<int> pressed_keys;  ///< all that went down, as GLFW numbers them
    bool any = true;

    static Events& of(GLFWwindow* window) { return *static_cast<Events*>(glfwGetWindowUserPointer(window)); }

    static std::optional<Key> key_of(int glfw_key, int scancode) {
        if (const char* printed = glfwGetKeyName(glfw_key, scancode);
            printed && printed[0] >= 'a' && printed[0] <= 'z' && !printed[1])
            glfw_key = GLFW_KEY_A + (printed[0] - 'a');
        for (const KeyName& name : key_names)
            if (name.glfw == glfw_key) return name.key;
        return std::nullopt;
    }

    static void on_key(GLFWwindow* window, int glfw_key, int scancode, int action, int modifiers) {
        Events& events = of(window);
        events.any = true;
        if (action == GLFW_PRESS) events.pressed_keys.push_back(glfw_key);
        const std::optional<Key> key = key_of(glfw_key, scancode);
        if (!key || action == GLFW_REPEAT) return;
        events.input.down[static_cast<std::size_t>(*key)] = action == GLFW_PRESS;
        if (action == GLFW_PRESS)
            events.input.pressed.push_back(
                {*key, (modifiers & GLFW_MOD_CONTROL) != 0, (modifiers & GLFW_MOD_SHIFT) != 0});
    }

    static void on_drop(GLFWwindow* window, int count, const char** files) {
        Events& events = of(window);
        events.any = true;
        events.input.dropped_files.assign(files, files + count);
    }

    static void on_focus(GLFWwindow* window, int focused) {
        Events& events = of(window);
        events.any = true;
        if (!focused) events.input.down.fill(false);  // releases are not reported to a window without focus
    }
};

void listen(GLFWwindow* window, Events& events) {
    glfwSetWindowUserPointer(window, &events);
    glfwSetKeyCallback(window, Events::on_key);
    glfwSetDropCallback(window, Events::on_drop);
    glfwSetWindowFocusCallback(window, Events::on_focus);
    glfwSetCursorPosCallback(window, [](GLFWwindow* one, double, double) { Events::of(one).any = true; });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* one, int, int, int) { Events::of(one).any = true; });
    glfwSetScrollCallback(window, [](GLFWwindow* one, double, double) { Events::of(one).any = true; });
    glfwSetCharCallback(window, [](GLFWwindow* one, unsigned) { Events::of(one).any = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* one, int, int) { Events::of(one).any = true; });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* one) { Events::of(one).any = true; });
}

/// What GLFW says about its last failure.
std::string glfw_reason(const char* otherwise) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    std::string text = reason ? reason : otherwise;
    text.erase(text.find_last_not_of(' ') + 1);  // an empty DISPLAY leaves one behind
    return text;
}

Result<Window> make_window() {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
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
        return Error{"no window with OpenGL 3.3 core: " + glfw_reason("the display refuses it") +
                     "; viewing-sandbox snapshot needs no display"};
    }
    glfwSetWindowSizeLimits(window.get(), 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
    return window;
}

/// Between full screen and the place it had.
class FullScreen {
public:
    void toggle(GLFWwindow* window) {
        if (glfwGetWindowMonitor(window)) {
            glfwSetWindowMonitor(window, nullptr, x_, y_, width_, height_, GLFW_DONT_CARE);
            return;
        }
        GLFWmonitor* monitor = glfwGetPrimaryMonitor();
        if (!monitor) return;
        glfwGetWindowPos(window, &x_, &y_);
        glfwGetWindowSize(window, &width_, &height_);
        const GLFWvidmode& mode = *glfwGetVideoMode(monitor);
        glfwSetWindowMonitor(window, monitor, 0, 0, mode.width, mode.height, mode.refreshRate);
    }

private:
    int x_ = 0, y_ = 0, width_ = 1280, height_ = 720;
};

std::string snapshot_name() {
    const std::time_t now = std::time(nullptr);
    char name[64];
    std::strftime(name, sizeof name, "viewing-%Y-%m-%d-%H%M%S.png", std::localtime(&now));
    return name;
}

void write_snapshot(const Renderer& renderer, Studio& studio) {
    const std::string name = snapshot_name();
    const Status written = write_png(name, renderer.read(studio.camera_view()));
    studio.session.message =
        written ? Message{"snapshot of the camera view written to " + name, false} : Message{written.error(), true};
}

/// A part of the window as it was just drawn.
void write_view_picture(Studio& studio, const ViewPicture& wanted) {
    const Rect& rect = wanted.rect;
    const Image part = cropped(studio.read(), static_cast<int>(rect.min.x), static_cast<int>(rect.min.y),
                               static_cast<int>(rect.max.x), static_cast<int>(rect.max.y));
    const Status written = write_png(wanted.file, part);
    studio.session.message =
        written ? Message{"picture written to " + wanted.file.string(), false} : Message{written.error(), true};
}

void present(GLFWwindow* window, const Studio& studio, glm::ivec2 size_px) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, studio.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size_px.x, size_px.y, 0, 0, size_px.x, size_px.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(window);
}

/// ImGui 1.86 sees only keys that are down when a frame begins. Those that are up again already are down for this one
/// frame while an object of this class lives.
class ShortTaps {
public:
    explicit ShortTaps(const std::vector<int>& pressed_keys) {
        for (const int key : pressed_keys)
            if (key >= 0 && key < IM_ARRAYSIZE(io_.KeysDown) && !io_.KeysDown[key]) taps_.push_back(key);
        set(true);
    }
    ~ShortTaps() { set(false); }
    ShortTaps(const ShortTaps&) = delete;
    ShortTaps& operator=(const ShortTaps&) = delete;

private:
    void set(bool down) {
        for (const int key : taps_) io_.KeysDown[key] = down;
        io_.KeyCtrl = io_.KeysDown[GLFW_KEY_LEFT_CONTROL] || io_.KeysDown[GLFW_KEY_RIGHT_CONTROL];
        io_.KeyShift = io_.KeysDown[GLFW_KEY_LEFT_SHIFT] || io_.KeysDown[GLFW_KEY_RIGHT_SHIFT];
    }

    ImGuiIO& io_ = ImGui::GetIO();
    std::vector<int> taps_;
};

void run_loop(GLFWwindow* window, Renderer& renderer, Studio& studio, Events& events) {
    FullScreen full_screen;
    double last_frame_s = glfwGetTime();
    int frames_due = 0;
    while (!glfwWindowShouldClose(window)) {
        const double wait_s = frames_due > 0 ? 0.0 : studio.redraw_in_s();
        if (wait_s == 0.0)
            glfwPollEvents();
        else if (wait_s > 0.0)
            glfwWaitEventsTimeout(wait_s);
        else
            glfwWaitEvents();

        // ImGui has no queue of input: a press and its release take a frame each, and a click one more to act.
        constexpr int frames_after_an_event = 3;
        frames_due = std::exchange(events.any, false) ? frames_after_an_event : std::max(frames_due - 1, 0);

        glm::ivec2 size_px(0);
        glfwGetFramebufferSize(window, &size_px.x, &size_px.y);
        if (size_px.x == 0 || size_px.y == 0) {  // minimised
            glfwWaitEvents();
            continue;
        }
        float device_scale = 1.0F;
        glfwGetWindowContentScale(window, &device_scale, nullptr);
        ImGui_ImplGlfw_NewFrame();
        int window_width = 0;
        glfwGetWindowSize(window, &window_width, nullptr);
        const float pixels_per_unit =
            window_width > 0 ? static_cast<float>(size_px.x) / static_cast<float>(window_width) : 1.0F;
        ImGuiIO& io = ImGui::GetIO();
        if (pixels_per_unit != 1.0F && io.MousePos.x > -1e5F)
            io.MousePos = {io.MousePos.x * pixels_per_unit, io.MousePos.y * pixels_per_unit};
        io.DisplayFramebufferScale = {1.0F, 1.0F};

        const double now_s = glfwGetTime();
        events.input.dt_s = std::max(now_s - last_frame_s, 1e-4);
        last_frame_s = now_s;
        const ShortTaps taps(events.pressed_keys);
        const Requests requests = studio.frame({size_px, device_scale, true, events.input});
        events.pressed_keys.clear();
        events.input.pressed.clear();
        events.input.dropped_files.clear();
        if (requests.snapshot) {
            write_snapshot(renderer, studio);
            events.any = true;
        }
        if (requests.view_picture) {
            write_view_picture(studio, *requests.view_picture);
            events.any = true;
        }
        if (requests.toggle_full_screen) full_screen.toggle(window);
        present(window, studio, size_px);
    }
}

}  // namespace

Status run_window(const LoadedState& state, int lost_display_status) {
    const Glfw glfw;
    if (!glfw.started) {
        return Error{"there is no display for a window (" + glfw_reason("GLFW does not start") +
                     "); viewing-sandbox snapshot needs none"};
    }
    end_when_display_is_lost(lost_display_status);
    Result<Session> session = Session::make(state);
    if (!session) return Error{session.error()};
    Result<Window> made = make_window();
    if (!made) return Error{made.error()};
    GLFWwindow* window = made->get();
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);

    Result<Renderer> renderer = Renderer::make();
    if (!renderer) return Error{renderer.error()};
    Studio studio(*renderer, std::move(*session));
    Events events;
    listen(window, events);
    ImGui_ImplGlfw_InitForOpenGL(window, true);  // chains to the callbacks above
    glfwShowWindow(window);
    run_loop(window, *renderer, studio, events);
    ImGui_ImplGlfw_Shutdown();
    return std::monostate{};
}

}  // namespace viewing
