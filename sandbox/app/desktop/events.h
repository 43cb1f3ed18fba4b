// What GLFW tells of a window, in order; and what ends beside it wakes it. Read ui/parts/input_queue.h for what becomes
// of it.
#pragma once

#include <optional>

#include "ui/parts/input_queue.h"

struct GLFWwindow;

namespace viewing {

/// Work that ends beside the window wakes it while an object of this class lives.
struct WakeUp {
    WakeUp();
    ~WakeUp();
    WakeUp(const WakeUp&) = delete;
    WakeUp& operator=(const WakeUp&) = delete;
};

/// What the window hears. Letters are taken by what the keyboard's layout prints.
class Events {
public:
    InputQueue queue;
    bool any = true;  ///< something happened since this was set back

    explicit Events(GLFWwindow* window);
    Events(const Events&) = delete;
    Events& operator=(const Events&) = delete;

    /// Keys that are pressed in this window count as well, and what befalls it wakes the first one.
    void hear_keys_of(GLFWwindow* window);

    /// Takes what has come, and waits for something where nothing has: at most so long; negative: for ever.
    void take(double wait_s);

private:
    static Events& of(GLFWwindow* window);
    static void push(GLFWwindow* window, InputEvent event);
    static void on_key(GLFWwindow* window, int glfw_key, int scancode, int action, int modifiers);
    static void on_enter(GLFWwindow* window, int entered);

    double polled_s_ = 0.0;
    std::optional<double> heard_since_s_;  ///< what is heard now happened since then; nothing: now
};

}  // namespace viewing
