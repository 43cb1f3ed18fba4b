// The keys that the sandbox knows, and the user's input in one frame. The window or the browser's page fills in this
// input; tests do so by hand.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "text/per_enum.h"

namespace viewing {

enum class Key {
    w,
    a,
    s,
    d,
    q,
    e,
    r,
    f,  // motion
    left,
    right,
    up,
    down,  // rotation
    shift,
    ctrl,
    alt,
    super,
    m,
    c,
    v,
    z,
    y,
    o,
    b,
    n,
    p,
    plus,
    minus,
    zero,
    page_up,
    page_down,
    g,
    l,
    x,
    home,
    h,
    i,
    t,
    one,
    two,
    three,
    four,
    five,
    six,
    seven,
    eight,
    nine,
    space,
    backspace,
    enter,
    period,
    comma,
    f1,
    f2,
    f3,
    f5,
    f6,
    f9,
    f11,
    f12,
    escape,
    count
};

/// A key press with the modifiers held at that time; by the next frame, they may have been released.
struct KeyPress {
    Key key;
    bool ctrl = false, shift = false;
    bool operator==(const KeyPress&) const = default;
};

/// The user's input since the last frame. `pressed` holds each key press in order.
struct FrameInput {
    PerEnum<Key, bool, static_cast<std::size_t>(Key::count)> down{};
    std::vector<KeyPress> pressed;
    std::vector<std::filesystem::path> dropped_files;
    bool loses_focus = false;  ///< the window has just lost focus
    double dt_s = 1.0 / 60.0;  ///< time since the last frame, even if the window was idle

    bool is_down(Key key) const { return down[key]; }
};

}  // namespace viewing
