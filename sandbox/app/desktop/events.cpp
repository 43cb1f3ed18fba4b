#include "app/desktop/events.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "platform/background.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace viewing {
namespace {

struct GlfwKey {
    int glfw;
    Key key;
};
constexpr GlfwKey glfw_keys[] = {{GLFW_KEY_W, Key::w},
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
                                 {GLFW_KEY_G, Key::g},
                                 {GLFW_KEY_L, Key::l},
                                 {GLFW_KEY_X, Key::x},
                                 {GLFW_KEY_HOME, Key::home},
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
                                 {GLFW_KEY_H, Key::h},
                                 {GLFW_KEY_I, Key::i},
                                 {GLFW_KEY_T, Key::t},
                                 {GLFW_KEY_1, Key::one},
                                 {GLFW_KEY_2, Key::two},
                                 {GLFW_KEY_3, Key::three},
                                 {GLFW_KEY_4, Key::four},
                                 {GLFW_KEY_5, Key::five},
                                 {GLFW_KEY_6, Key::six},
                                 {GLFW_KEY_7, Key::seven},
                                 {GLFW_KEY_8, Key::eight},
                                 {GLFW_KEY_9, Key::nine},
                                 {GLFW_KEY_KP_1, Key::one},
                                 {GLFW_KEY_KP_2, Key::two},
                                 {GLFW_KEY_KP_3, Key::three},
                                 {GLFW_KEY_KP_4, Key::four},
                                 {GLFW_KEY_KP_5, Key::five},
                                 {GLFW_KEY_KP_6, Key::six},
                                 {GLFW_KEY_KP_7, Key::seven},
                                 {GLFW_KEY_KP_8, Key::eight},
                                 {GLFW_KEY_KP_9, Key::nine},
                                 {GLFW_KEY_SPACE, Key::space},
                                 {GLFW_KEY_BACKSPACE, Key::backspace},
                                 {GLFW_KEY_ENTER, Key::enter},
                                 {GLFW_KEY_KP_ENTER, Key::enter},
                                 {GLFW_KEY_PERIOD, Key::period},
                                 {GLFW_KEY_COMMA, Key::comma},
                                 {GLFW_KEY_F1, Key::f1},
                                 {GLFW_KEY_F2, Key::f2},
                                 {GLFW_KEY_F3, Key::f3},
                                 {GLFW_KEY_F5, Key::f5},
                                 {GLFW_KEY_F6, Key::f6},
                                 {GLFW_KEY_F9, Key::f9},
                                 {GLFW_KEY_F11, Key::f11},
                                 {GLFW_KEY_F12, Key::f12},
                                 {GLFW_KEY_ESCAPE, Key::escape}};

std::optional<Key> key_of(int glfw_key) {
    for (const GlfwKey& name : glfw_keys)
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

/// Whether an input method composes characters from several keystrokes, as for Korean. Every session with an input
/// method sets XMODIFIERS.
bool has_input_method() {
    static const bool has_one = [] {
        const char* const modifiers = std::getenv("XMODIFIERS");
        return modifiers && std::string_view(modifiers).starts_with("@im=") &&
               std::string_view(modifiers) != "@im=none";
    }();
    return has_one;
}

bool ends_entry(int glfw_key) {
    return glfw_key == GLFW_KEY_ENTER || glfw_key == GLFW_KEY_KP_ENTER || glfw_key == GLFW_KEY_TAB;
}

/// Set when background work ends.
std::atomic<bool> work_has_ended{false};

}  // namespace

WakeUp::WakeUp() {
    wake_when_work_ends([] {
        work_has_ended = true;
        glfwPostEmptyEvent();
    });
}

WakeUp::~WakeUp() {
    wake_when_work_ends(nullptr);
}

Events::Events(GLFWwindow* window) : polled_s_(glfwGetTime()) {
    hear_keys_of(window);
    glfwSetDropCallback(window, [](GLFWwindow* one, int count, const char** files) {
        push(one, FilesDropped{std::vector<std::filesystem::path>(files, files + count)});
    });
    glfwSetWindowFocusCallback(window,
                               [](GLFWwindow* one, int focused) { push(one, FocusChanged{focused == GLFW_TRUE}); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* one, double x, double y) {
        of(one).queue_now(PointerMoved{glm::vec2(static_cast<float>(x), static_cast<float>(y))});
    });
    glfwSetCursorEnterCallback(window, on_enter);
    glfwSetMouseButtonCallback(window, [](GLFWwindow* one, int button, int action, int) {
        push(one, ButtonChanged{static_cast<std::size_t>(button), action == GLFW_PRESS});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* one, double x, double y) {
        push(one, WheelTurned{{static_cast<float>(x), static_cast<float>(y)}});
    });
    glfwSetCharCallback(window, [](GLFWwindow* one, unsigned code_point) {
        Events& events = of(one);
        events.queue_now(CharacterTyped{code_point});
        // The key that commits a syllable also begins the next syllable.
        events.composes_ = code_point > 0x7F && events.held_.empty();
        if (events.held_.empty()) return;
        constexpr double more_s = 0.25;  // more of the word may arrive
        events.held_until_s_ = glfwGetTime() + more_s;
        events.has_committed_ = true;
    });
}

void Events::hear_keys_of(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, on_key);
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* one, int, int) { of(one).any = true; });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* one) { of(one).any = true; });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* one) { of(one).any = true; });
}

void Events::take(double wait_s) {
    heard_since_s_ = polled_s_;
    glfwPollEvents();
    if (!held_.empty()) {
        const double left_s = held_until_s_ - glfwGetTime();
        if (left_s <= 0.0)
            release_held();
        else
            wait_s = wait_s < 0.0 ? left_s : std::min(wait_s, left_s);
    }
    any |= work_has_ended.exchange(false);
    if (!any && wait_s != 0.0) {
        heard_since_s_.reset();  // events from here on are delivered immediately
        if (wait_s > 0.0)
            glfwWaitEventsTimeout(wait_s);
        else
            glfwWaitEvents();
        any |= work_has_ended.exchange(false);
    }
    polled_s_ = glfwGetTime();
}

Events& Events::of(GLFWwindow* window) {
    return *static_cast<Events*>(glfwGetWindowUserPointer(window));
}

void Events::push(GLFWwindow* window, InputEvent event) {
    of(window).release_held();
    of(window).queue_now(std::move(event));
}

void Events::queue_now(InputEvent event) {
    any = true;
    const double now_s = glfwGetTime();
    queue.push(std::move(event), {heard_since_s_.value_or(now_s), now_s});
}

/// Holds an event back. GLFW reports Enter before the input method commits the syllable that Enter ends; without the
/// delay, that syllable would be lost.
void Events::hold(InputEvent event) {
    constexpr double patience_s = 2.0;
    if (held_.empty()) {
        held_until_s_ = glfwGetTime() + patience_s;
        has_committed_ = false;
    }
    held_.push_back(std::move(event));
}

void Events::release_held() {
    if (!held_.empty()) composes_ = false;
    for (InputEvent& event : std::exchange(held_, {})) queue_now(std::move(event));
}

void Events::on_key(GLFWwindow* window, int glfw_key, int scancode, int action, int modifiers) {
    if (action == GLFW_REPEAT || glfw_key < 0) return;
    int printed_key = glfw_key;
    if (const char* printed = glfwGetKeyName(glfw_key, scancode); printed && printed[0] != '\0' && !printed[1]) {
        if (printed[0] >= 'a' && printed[0] <= 'z') printed_key = GLFW_KEY_A + (printed[0] - 'a');
        if (printed[0] == '+') printed_key = GLFW_KEY_KP_ADD;
        if (printed[0] == '-') printed_key = GLFW_KEY_KP_SUBTRACT;
    }
    KeyChanged changed{.code = static_cast<std::size_t>(glfw_key),
                       .kind = kind_of(glfw_key),
                       .key = key_of(printed_key),
                       .down = action == GLFW_PRESS,
                       .ctrl = (modifiers & GLFW_MOD_CONTROL) != 0,
                       .shift = (modifiers & GLFW_MOD_SHIFT) != 0};
    Events& events = of(window);
    const bool is_entry = ImGui::GetIO().WantTextInput && has_input_method();
    if (changed.down && changed.kind == KeyKind::prints) events.composes_ = is_entry && !changed.ctrl;
    const bool waits = !events.held_.empty() && !events.has_committed_;
    if (waits || (changed.down && is_entry && events.composes_ && ends_entry(glfw_key)))
        events.hold(changed);
    else
        push(window, changed);
}

/// Ignores the pointer leaving the window during a drag, since the drag continues outside.
void Events::on_enter(GLFWwindow* window, int entered) {
    for (int button = GLFW_MOUSE_BUTTON_1; button <= GLFW_MOUSE_BUTTON_LAST; ++button)
        if (glfwGetMouseButton(window, button) == GLFW_PRESS) return;
    if (!entered) push(window, PointerMoved{});
}

}  // namespace viewing
