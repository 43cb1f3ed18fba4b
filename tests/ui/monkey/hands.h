// The monkey's hands. From a seed, they choose actions that a user could perform, mostly on an item. They use the
// mouse, the wheel, keys and the clipboard, type text, resize the window, and drop files. monkey.cpp performs the
// actions without a window and observes their effect in the same program; monkey_window performs them on a real window.
// Read monkey.cpp next.
#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "ui/parts/input_queue.h"
#include "widgets/widgets.h"

namespace viewing::test {

struct Typed {
    std::string text;  ///< ASCII
};
struct WindowResized {
    glm::ivec2 size_px{0};
};
struct ClipboardFilled {
    std::filesystem::path file;  ///< its content goes to the clipboard
};
struct Paused {
    double seconds = 0.0;
};
using Touch = std::variant<InputEvent, Typed, WindowResized, ClipboardFilled, Paused>;

/// One action, such as a double-click.
struct Deed {
    std::string what;
    std::vector<Touch> touches;
};

/// A key as the window system reports it. `name` is the name that xdotool takes.
struct KeyOnBoard {
    const char* name;
    std::size_t code;  ///< GLFW's code
    KeyKind kind;
    std::optional<Key> key;
};
/// Finds a key by name; throws if there is none.
const KeyOnBoard& key_named(std::string_view name);
KeyChanged changed(const KeyOnBoard& key, bool down, bool ctrl = false, bool shift = false);

class Hands {
public:
    /// `things` is the folder with the files of make_things().
    Hands(std::uint32_t seed, std::filesystem::path things);

    /// Returns the next action in a window of this size with these items.
    Deed next(const std::vector<widgets::RecordedItem>& items, glm::ivec2 size_px);
    std::size_t pick(std::size_t count) { return random_() % count; }

private:
    using Items = std::vector<widgets::RecordedItem>;
    bool chance(std::size_t one_in) { return pick(one_in) == 0; }
    glm::vec2 place_in(const widgets::RecordedItem& item);
    glm::vec2 somewhere(const Items& items, glm::ivec2 size_px, std::string& what);
    void tap(Deed& deed, const char* key, bool ctrl = false, bool shift = false);
    void click(Deed& deed, std::size_t button = 0, int times = 1);
    void drag(Deed& deed, glm::vec2 from, glm::ivec2 size_px);
    void type_number(Deed& deed);
    void press_a_key(Deed& deed);
    void take_from_presets(Deed& deed);
    void use_files(Deed& deed);
    void use_clipboard(Deed& deed);
    std::filesystem::path thing();

    std::mt19937 random_;
    std::vector<std::filesystem::path> things_;
};

/// Creates the files that the hands drop and paste: intact and broken states, scenes, meshes and figures, and files of
/// no known kind.
void make_things(const std::filesystem::path& folder);

/// Returns the lines that monkey_window reads: xdotool commands for the window `id`, or "resize W H", "clipboard FILE",
/// "drop FILE…".
std::string as_script(const Deed& deed, const std::string& id);

}  // namespace viewing::test
