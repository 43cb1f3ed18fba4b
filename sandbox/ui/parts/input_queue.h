// What the window system reports, kept until a frame can show it. Dear ImGui 1.86 sees only what is down when a frame
// begins, and where the pointer is then: on a busy machine a click would be a drag from elsewhere, and a key that is up
// again already nothing at all. So a frame gets one change, in order, as Dear ImGui's own queue does from 1.87 on
// (ConfigInputTrickleEventQueue). Knows no window system. Read run_loop in app/desktop/window.cpp next.
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

/// Where the pointer is now; nothing: outside the window.
struct PointerMoved {
    std::optional<glm::vec2> place;
};
struct ButtonChanged {
    std::size_t button = 0;
    bool down = false;
};
struct WheelTurned {
    glm::vec2 lines{0.0F};  ///< right and up positive
};

enum class KeyKind {
    prints,    ///< it is seen as a character
    modifier,  ///< it changes what others mean
    edits,     ///< backspace, arrows, …
    leaves     ///< enter, tab, escape, F1, …: what comes next may be for somebody else
};
struct KeyChanged {
    std::size_t code = 0;  ///< as ImGui's io.KeysDown counts
    KeyKind kind = KeyKind::prints;
    std::optional<Key> key;  ///< where the sandbox knows it
    bool down = false;
    bool ctrl = false, shift = false;  ///< held meanwhile
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

/// All that a frame has to know of a person's hands.
struct InputFrame {
    std::optional<glm::vec2> pointer;
    std::array<bool, 5> buttons{};
    glm::vec2 wheel{0.0F};
    std::array<bool, 512> keys{};
    std::vector<unsigned> characters;
    std::optional<bool> focus;  ///< where it changed
    FrameInput input;
};

class InputQueue {
public:
    /// When something happened: a window that was busy hears of it later, and knows only between when and when.
    struct Time {
        double earliest_s = 0.0, latest_s = 0.0;
    };
    void push(InputEvent event, Time time);

    /// More frames are wanted at once.
    bool is_empty() const { return events_.empty(); }

    /// What the next frame shows: as much as fits into one. Its time is that of what it shows while more is waiting,
    /// and `now_s` else: two clicks are no further apart than they were, and a key is held as long, however slow the
    /// frames.
    const InputFrame& next_frame(double now_s);

private:
    struct Waiting {
        InputEvent event;
        double time_s = 0.0;
    };
    /// What the present frame has got already.
    struct Taken {
        bool pointer = false, wheel = false, keyboard = false, alone = false;
        bool pressed = false, acted = false;  ///< a key that is no modifier; a key that does more than print
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
    /// Time passes with what is held before the next key changes that.
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
    int keyboard_waits_ = 0;  ///< frames until what was clicked or entered has taken effect
    double clock_s_ = 0.0;
};

/// Fills ImGui's IO before its frame begins. `pixels_per_unit`: of the window system's coordinates.
void feed_imgui(const InputFrame& frame, float pixels_per_unit);

}  // namespace viewing
