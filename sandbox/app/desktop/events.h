// Queues a window's GLFW events in order; the end of background work wakes the window. See ui/parts/input_queue.h for
// how events are processed.
#pragma once

#include <optional>
#include <vector>

#include "ui/parts/input_queue.h"

struct GLFWwindow;

namespace viewing {

/// While an object of this class lives, the end of background work wakes the window.
struct WakeUp {
    WakeUp();
    ~WakeUp();
    WakeUp(const WakeUp&) = delete;
    WakeUp& operator=(const WakeUp&) = delete;
};

/// Collects the window's events. Letter keys are matched by the character that the keyboard layout produces.
class Events {
public:
    InputQueue queue;
    bool any = true;  ///< something has happened since this was last reset

    explicit Events(GLFWwindow* window);
    Events(const Events&) = delete;
    Events& operator=(const Events&) = delete;

    /// Also collects the keys pressed in this window. Resizing, uncovering or closing it wakes the first window.
    void hear_keys_of(GLFWwindow* window);

    /// Takes pending events. If there are none, waits up to `wait_s` for one, or forever if `wait_s` is negative.
    void take(double wait_s);

private:
    static Events& of(GLFWwindow* window);
    static void push(GLFWwindow* window, InputEvent event);
    static void on_key(GLFWwindow* window, int glfw_key, int scancode, int action, int modifiers);
    static void on_enter(GLFWwindow* window, int entered);

    void queue_now(InputEvent event);
    void hold(InputEvent event);
    void release_held();

    bool composes_ = false;         ///< the input method holds keys that it has not yet turned into a character
    std::vector<InputEvent> held_;  ///< the key that ends the text, and later events, until the last character arrives
    bool has_committed_ = false;    ///< a character has arrived since the first held event
    double held_until_s_ = 0.0;
    double polled_s_ = 0.0;
    std::optional<double> heard_since_s_;  ///< earliest possible time of the events being delivered; empty: now
};

}  // namespace viewing
