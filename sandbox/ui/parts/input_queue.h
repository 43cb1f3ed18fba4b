// A queue of window-system events, held until a frame can process them. Dear ImGui 1.86 sees only the keys, buttons,
// and pointer position at the start of a frame: on a busy machine, a click would become a drag from elsewhere, and a
// key press that has already ended would be lost. Therefore, each frame gets only events that do not hide one another,
// in order, as with Dear ImGui's own queue since 1.87 (ConfigInputTrickleEventQueue). The queue does not depend on the
// window system. Read run_loop in app/desktop/window.cpp next.
#pragma once

#include <array>
#include <deque>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

#include "ui/parts/input.h"

namespace viewing {

/// The pointer's new position; nullopt if the pointer is outside the window.
struct PointerMoved {
    std::optional<glm::vec2> place;
};
struct ButtonChanged {
    std::size_t button = 0;
    bool down = false;
};
struct WheelTurned {
    glm::vec2 lines{0.0F};  ///< positive: left and up
};

enum class KeyKind {
    prints,    ///< produces a character
    modifier,  ///< changes the meaning of other keys
    edits,     ///< backspace, arrows, …
    leaves     ///< enter, tab, escape, F1, …: the next input may go to another item
};
struct KeyChanged {
    std::size_t code = 0;  ///< index into ImGui's io.KeysDown
    KeyKind kind = KeyKind::prints;
    std::optional<Key> key;  ///< if the sandbox knows it
    bool down = false;
    bool ctrl = false, shift = false;  ///< held at that time
};
struct CharacterTyped {
    unsigned code_point = 0;
};
struct FocusChanged {
    bool focused = false;
};
struct FilesDropped {
    std::vector<std::filesystem::path> files;
};
using InputEvent =
    std::variant<PointerMoved, ButtonChanged, WheelTurned, KeyChanged, CharacterTyped, FocusChanged, FilesDropped>;

/// All user input of a frame.
struct InputFrame {
    std::optional<glm::vec2> pointer;
    std::array<bool, 5> buttons{};
    glm::vec2 wheel{0.0F};
    std::array<bool, 512> keys{};
    std::vector<unsigned> characters;
    std::optional<bool> focus;  ///< set if it changed
    FrameInput input;
};

class InputQueue {
public:
    /// The time of an event. A busy window learns of an event only later, so it knows only two bounds on the time.
    struct Time {
        double earliest_s = 0.0, latest_s = 0.0;
    };
    void push(InputEvent event, Time time);

    /// If this returns false, draw the next frame immediately.
    bool is_empty() const { return events_.empty(); }

    /// Returns the input of the next frame: as many events as one frame can take. While more are queued, the frame's
    /// time is that of its events; otherwise, it is `now_s`. The time between two clicks, and the time for which a key
    /// is held, therefore stay the same however slow the frames are.
    const InputFrame& next_frame(double now_s);

private:
    struct Waiting {
        InputEvent event;
        double time_s = 0.0;
    };
    /// The kinds of events that the current frame already contains.
    struct Taken {
        bool pointer = false, wheel = false, keyboard = false, alone = false;
        bool pressed = false, acted = false;  ///< pressed: a key, not a modifier; acted: a key that does more than type
        std::vector<std::size_t> codes;
    };

    bool fits(const PointerMoved& event) const;
    bool fits(const ButtonChanged& event) const;
    bool fits(const WheelTurned& event) const;
    bool fits(const KeyChanged& event) const;
    bool fits(const CharacterTyped& event) const;
    bool fits(const FocusChanged& event) const;
    bool fits(const FilesDropped& event) const;
    bool is_nothing_taken() const;
    /// Whether held keys must act for a while before the next key event changes them.
    bool lets_held_keys_act() const;

    void apply(const PointerMoved& event);
    void apply(const ButtonChanged& event);
    void apply(const WheelTurned& event);
    void apply(const KeyChanged& event);
    void apply(const CharacterTyped& event);
    void apply(const FocusChanged& event);
    void apply(const FilesDropped& event);

    std::deque<Waiting> events_;
    InputFrame frame_;
    Taken taken_;
    int keyboard_waits_ = 0;  ///< frames until a click or a key has taken effect
    double clock_s_ = 0.0;
};

/// Fills ImGui's IO before its frame begins. `pixels_per_unit` scales the coordinates of the window system.
void feed_imgui(const InputFrame& frame, float pixels_per_unit);

}  // namespace viewing
