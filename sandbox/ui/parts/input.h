// The keys that the sandbox knows, and the user's input in one frame. The window or the browser's page fills in this
// input; tests do so by hand.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "text/per_enum.h"

namespace viewing {

// clang-format off
/// Applies KEY to each key and the name that the window shows.
#define VIEWING_KEYS(KEY) \
    KEY(w, "W") KEY(a, "A") KEY(s, "S") KEY(d, "D") KEY(q, "Q") KEY(e, "E") KEY(r, "R") KEY(f, "F") \
    KEY(left, "Left") KEY(right, "Right") KEY(up, "Up") KEY(down, "Down") KEY(shift, "Shift") KEY(ctrl, "Ctrl") \
    KEY(alt, "Alt") KEY(super, "Super") KEY(m, "M") KEY(c, "C") KEY(v, "V") KEY(z, "Z") KEY(y, "Y") KEY(o, "O") \
    KEY(b, "B") KEY(n, "N") KEY(p, "P") KEY(plus, "plus") KEY(minus, "minus") KEY(zero, "0") KEY(page_up, "Page up") \
    KEY(page_down, "Page down") KEY(g, "G") KEY(l, "L") KEY(x, "X") KEY(home, "Home") KEY(h, "H") KEY(i, "I") \
    KEY(t, "T") KEY(one, "1") KEY(two, "2") KEY(three, "3") KEY(four, "4") KEY(five, "5") KEY(six, "6") \
    KEY(seven, "7") KEY(eight, "8") KEY(nine, "9") KEY(space, "Space") KEY(backspace, "Backspace") \
    KEY(enter, "Enter") KEY(period, ".") KEY(comma, ",") KEY(f1, "F1") KEY(f2, "F2") KEY(f3, "F3") KEY(f5, "F5") \
    KEY(f6, "F6") KEY(f9, "F9") KEY(f11, "F11") KEY(f12, "F12") KEY(escape, "Esc")
#define VIEWING_KEY(key, text) key,
#define VIEWING_KEY_TEXT(key, text) text,
enum class Key { VIEWING_KEYS(VIEWING_KEY) count };
// clang-format on

inline constexpr PerEnum<Key, const char*, static_cast<std::size_t>(Key::count)> key_names{
    {VIEWING_KEYS(VIEWING_KEY_TEXT)}};

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
