// The commands of the window, each declared once: its key, its name in menus and in the search, its line in the list of
// keys, where it exists, and what it does.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frame/problems.h"
#include "session/session.h"
#include "ui/parts/input.h"

namespace viewing {

class Workbench;
struct Requests;

/// Where the user is. Keys differ between these places.
enum class Place { window, lesson, stage, lesson_on_stage };

/// How much may be open for a command's key to work. Each value allows what the one before it allows, and more.
enum class Open {
    nothing,
    list,   ///< a drop-down list or a menu
    text,   ///< a text field: the typed text is committed first
    dialog  ///< everything
};

/// The parts of the File menu, from top to bottom.
enum class FilePart { none, files, copies, pastes, others };

/// What a command may change, beside the window.
struct CommandContext {
    Session& session;
    Requests& requests;
    const std::vector<Problem>& problems;
    double aspect;  ///< of the camera view
};

struct WindowCommand {
    const char* name;             ///< in menus and in the search; "": the search does not offer it
    std::optional<KeyPress> key;  ///< without shift: also with shift, unless another command has that
    unsigned places;              ///< a bit for each Place where it exists
    void (*run)(Workbench& window, const CommandContext& context);
    Open open = Open::nothing;
    /// Its line in the list of keys; "": its key is on the line of the command before it; null: not listed.
    const char* help = nullptr;
    FilePart file_part = FilePart::none;  ///< where the File menu has it
    const char* name_to_stop = nullptr;   ///< its name in the File menu while a flight is recorded

    bool is_in(Place place) const { return ((places >> static_cast<unsigned>(place)) & 1U) != 0; }
};

std::span<const WindowCommand> window_commands();
/// The command of a key at a place; null if there is none.
const WindowCommand* command_of(const KeyPress& press, Place place);

/// Returns a key's name as the window shows it, such as "Ctrl+Shift+Z"; "" for a command without a key.
std::string key_text(const std::optional<KeyPress>& press);

}  // namespace viewing
