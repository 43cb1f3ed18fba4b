// GLFW: events in, frames out, and asleep in between. All drawing goes into the studio's own framebuffer and is copied
// to the window, so the window shows what a snapshot writes.
#include "app/window.h"

#include <backends/imgui_impl_glfw.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ctime>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "app/lost_display.h"
#include "app/studio.h"
#include "image/png.h"
#include "platform/background.h"
#include "text/catalogue.h"
#include "ui/parts/input_queue.h"

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
                                 {GLFW_KEY_P, Key::p},
                                 {GLFW_KEY_EQUAL, Key::plus},
                                 {GLFW_KEY_KP_ADD, Key::plus},
                                 {GLFW_KEY_MINUS, Key::minus},
                                 {GLFW_KEY_KP_SUBTRACT, Key::minus},
                                 {GLFW_KEY_0, Key::zero},
                                 {GLFW_KEY_KP_0, Key::zero},
                                 {GLFW_KEY_PAGE_UP, Key::page_up},
                                 {GLFW_KEY_PAGE_DOWN, Key::page_down},
                                 {GLFW_KEY_F1, Key::f1},
                                 {GLFW_KEY_F2, Key::f2},
                                 {GLFW_KEY_F3, Key::f3},
                                 {GLFW_KEY_F11, Key::f11},
                                 {GLFW_KEY_F12, Key::f12},
                                 {GLFW_KEY_ESCAPE, Key::escape}};

std::optional<Key> key_of(int glfw_key) {
    for (const KeyName& name : key_names)
        if (name.glfw == glfw_key) return name.key;
    return std::nullopt;
}

KeyKind kind_of(int glfw_key) {
    if (glfw_key < GLFW_KEY_ESCAPE || (glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_ADD))
        return KeyKind::prints;
    if (glfw_key >= GLFW_KEY_LEFT_SHIFT && glfw_key <= GLFW_KEY_RIGHT_SUPER) return KeyKind::modifier;
    if (glfw_key >= GLFW_KEY_BACKSPACE && glfw_key <= GLFW_KEY_END) return KeyKind::edits;
    return KeyKind::leaves;
}

/// Set by what has ended beside the window.
std::atomic<bool> work_has_ended{false};

/// Work that ends beside the window wakes it while an object of this class lives.
struct WakeUp {
    WakeUp() {
        wake_when_work_ends([] {
            work_has_ended = true;
            glfwPostEmptyEvent();
        });
    }
    ~WakeUp() { wake_when_work_ends(nullptr); }
    WakeUp(const WakeUp&) = delete;
    WakeUp& operator=(const WakeUp&) = delete;
};

/// What the window hears, in order. Letters are taken by what the keyboard's layout prints.
class Events {
public:
    InputQueue queue;
    bool any = true;  ///< something happened since this was set back

    explicit Events(GLFWwindow* window) {
        glfwSetWindowUserPointer(window, this);
        glfwSetKeyCallback(window, on_key);
        glfwSetDropCallback(window, [](GLFWwindow* one, int count, const char** files) {
            push(one, FilesDropped{std::vector<std::filesystem::path>(files, files + count)});
        });
        glfwSetWindowFocusCallback(window,
                                   [](GLFWwindow* one, int focused) { push(one, FocusChanged{focused == GLFW_TRUE}); });
        glfwSetCursorPosCallback(window, [](GLFWwindow* one, double x, double y) {
            push(one, PointerMoved{glm::vec2(static_cast<float>(x), static_cast<float>(y))});
        });
        glfwSetCursorEnterCallback(window, on_enter);
        glfwSetMouseButtonCallback(window, [](GLFWwindow* one, int button, int action, int) {
            push(one, ButtonChanged{static_cast<std::size_t>(button), action == GLFW_PRESS});
        });
        glfwSetScrollCallback(window, [](GLFWwindow* one, double x, double y) {
            push(one, WheelTurned{{static_cast<float>(x), static_cast<float>(y)}});
        });
        glfwSetCharCallback(window,
                            [](GLFWwindow* one, unsigned code_point) { push(one, CharacterTyped{code_point}); });
        glfwSetFramebufferSizeCallback(window, [](GLFWwindow* one, int, int) { of(one).any = true; });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* one) { of(one).any = true; });
    }
    Events(const Events&) = delete;
    Events& operator=(const Events&) = delete;

    /// Takes what has come, and waits for something where nothing has: at most so long; negative: for ever.
    void take(double wait_s) {
        heard_since_s_ = polled_s_;
        glfwPollEvents();
        any |= work_has_ended.exchange(false);
        if (!any && wait_s != 0.0) {
            heard_since_s_.reset();  // from here on nothing is heard late
            if (wait_s > 0.0)
                glfwWaitEventsTimeout(wait_s);
            else
                glfwWaitEvents();
            any |= work_has_ended.exchange(false);
        }
        polled_s_ = glfwGetTime();
    }

private:
    static Events& of(GLFWwindow* window) { return *static_cast<Events*>(glfwGetWindowUserPointer(window)); }

    static void push(GLFWwindow* window, InputEvent event) {
        Events& events = of(window);
        events.any = true;
        const double now_s = glfwGetTime();
        events.queue.push(std::move(event), {events.heard_since_s_.value_or(now_s), now_s});
    }

    static void on_key(GLFWwindow* window, int glfw_key, int scancode, int action, int modifiers) {
        if (action == GLFW_REPEAT || glfw_key < 0) return;
        int printed_key = glfw_key;
        if (const char* printed = glfwGetKeyName(glfw_key, scancode); printed && printed[0] != '\0' && !printed[1]) {
            if (printed[0] >= 'a' && printed[0] <= 'z') printed_key = GLFW_KEY_A + (printed[0] - 'a');
            if (printed[0] == '+') printed_key = GLFW_KEY_KP_ADD;
            if (printed[0] == '-') printed_key = GLFW_KEY_KP_SUBTRACT;
        }
        push(window, KeyChanged{.code = static_cast<std::size_t>(glfw_key),
                                .kind = kind_of(glfw_key),
                                .key = key_of(printed_key),
                                .down = action == GLFW_PRESS,
                                .ctrl = (modifiers & GLFW_MOD_CONTROL) != 0,
                                .shift = (modifiers & GLFW_MOD_SHIFT) != 0});
    }

    /// A drag that leads out of the window goes on there.
    static void on_enter(GLFWwindow* window, int entered) {
        for (int button = GLFW_MOUSE_BUTTON_1; button <= GLFW_MOUSE_BUTTON_LAST; ++button)
            if (glfwGetMouseButton(window, button) == GLFW_PRESS) return;
        if (!entered) push(window, PointerMoved{});
    }

    double polled_s_ = glfwGetTime();
    std::optional<double> heard_since_s_;  ///< what is heard now happened since then; nothing: now
};

/// What GLFW says about its last failure.
std::string glfw_reason(const char* otherwise) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    std::string text = reason ? reason : otherwise;
    text.erase(text.find_last_not_of(' ') + 1);  // an empty DISPLAY leaves one behind
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

/// Where it was the last time, if that is still on a screen.
void restore_place(GLFWwindow* window, const std::optional<WindowPlace>& place) {
    if (!place || !is_reachable(*place, screens())) return;
    glfwSetWindowSize(window, place->size.x, place->size.y);
    glfwSetWindowPos(window, place->position.x, place->position.y);
    if (place->maximised) glfwMaximizeWindow(window);
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

    /// The window's place without it. `before`: of a window that is maximised now.
    WindowPlace place(GLFWwindow* window, const std::optional<WindowPlace>& before) const {
        WindowPlace place{{x_, y_}, {width_, height_}, false};
        if (glfwGetWindowMonitor(window)) return place;
        glfwGetWindowPos(window, &place.position.x, &place.position.y);
        glfwGetWindowSize(window, &place.size.x, &place.size.y);
        if (glfwGetWindowAttrib(window, GLFW_MAXIMIZED) != GLFW_TRUE) return place;
        place = before.value_or(place);
        place.maximised = true;
        return place;
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
    std::error_code ignored;
    const std::filesystem::path file = std::filesystem::absolute(snapshot_name(), ignored);
    const Status written = write_png(file, renderer.read(studio.camera_view()));
    studio.session.message =
        written ? Message{say("snapshot of the camera view written to {file}", "file"_a = file.string()), false}
                : Message{written.error(), true};
}

/// A part of the window as it was just drawn.
void write_view_picture(Studio& studio, const ViewPicture& wanted) {
    const Rect& rect = wanted.rect;
    const Image part = cropped(studio.read(), static_cast<int>(rect.min.x), static_cast<int>(rect.min.y),
                               static_cast<int>(rect.max.x), static_cast<int>(rect.max.y));
    const Status written = write_png(wanted.file, part);
    studio.session.message = written ? Message{say("picture written to {file}", "file"_a = wanted.file.string()), false}
                                     : Message{written.error(), true};
}

void present(GLFWwindow* window, const Studio& studio, glm::ivec2 size_px) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, studio.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, size_px.x, size_px.y, 0, 0, size_px.x, size_px.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(window);
}

void run_loop(GLFWwindow* window, Renderer& renderer, Studio& studio, Events& events, WindowMemory& memory) {
    FullScreen full_screen;
    int frames_due = 0;
    while (!glfwWindowShouldClose(window)) {
        events.take(frames_due > 0 || !events.queue.is_empty() ? 0.0 : studio.redraw_in_s());

        // A click shows after a frame that lays out what it opened, and one more that fits it.
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
        ImGui_ImplGlfw_NewFrame();  // the pointer's shape
        int window_width = 0;
        glfwGetWindowSize(window, &window_width, nullptr);
        const float pixels_per_unit =
            window_width > 0 ? static_cast<float>(size_px.x) / static_cast<float>(window_width) : 1.0F;
        const InputFrame& frame = events.queue.next_frame(glfwGetTime());
        feed_imgui(frame, pixels_per_unit);
        ImGui::GetIO().DisplayFramebufferScale = {1.0F, 1.0F};
        const Requests requests = studio.frame({size_px, device_scale, true, frame.input});
        if (requests.snapshot) {
            write_snapshot(renderer, studio);
            events.any = true;
        }
        if (requests.view_picture) {
            write_view_picture(studio, *requests.view_picture);
            events.any = true;
        }
        Remembered looks = memory.remembered();
        if (requests.chosen_theme) looks.theme = requests.chosen_theme;
        if (requests.chosen_scale) looks.scale = requests.chosen_scale;
        studio.session.report(memory.remember(looks));
        if (requests.toggle_full_screen) full_screen.toggle(window);
        present(window, studio, size_px);
    }
    Remembered last = memory.remembered();
    last.window = full_screen.place(window, last.window);
    if (const Status written = memory.remember(last); !written) std::cerr << written.error() << '\n';
}

}  // namespace

Status run_window(Session session, WindowMemory& memory, int lost_display_status) {
    const Glfw glfw;
    if (!glfw.started) {
        return Error{"there is no display for a window (" + glfw_reason("GLFW does not start") +
                     "); viewing-sandbox snapshot needs none"};
    }
    end_when_display_is_lost(lost_display_status);
    Result<Window> made = make_window();
    if (!made) return Error{made.error()};
    GLFWwindow* window = made->get();
    restore_place(window, memory.remembered().window);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);

    Result<Renderer> renderer = Renderer::make();
    if (!renderer) return Error{renderer.error()};
    Studio studio(*renderer, std::move(session));
    const WakeUp wake_up;
    Events events(window);
    ImGui_ImplGlfw_InitForOpenGL(window, false);  // its callbacks know no order
    glfwShowWindow(window);
    if (!memory.trouble().empty()) studio.session.message = {memory.trouble(), true};
    run_loop(window, *renderer, studio, events, memory);
    ImGui_ImplGlfw_Shutdown();
    return std::monostate{};
}

}  // namespace viewing
