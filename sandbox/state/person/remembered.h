// Settings that the window remembers for a user between runs: the theme, the scale, the language, the window's size and
// position, the mouse habits, the progress in lessons, the recent files and the student, but never the state. Only the
// window reads and writes them; a headless command uses only the files that it is given.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "state/params.h"
#include "state/person/lesson_progress.h"
#include "state/person/mouse_habits.h"
#include "text/result.h"

namespace viewing {

/// The position and size of a window or a screen, in units of the window system, which need not be pixels; y points
/// down.
struct WindowPlace {
    glm::ivec2 position{0}, size{0};
    bool maximized = false;
    bool operator==(const WindowPlace&) const = default;
};

struct Remembered {
    std::optional<Theme> theme;
    std::optional<double> scale;
    std::optional<WindowPlace> window;
    LessonsProgress lessons = {};
    std::vector<std::string> recent = {};  ///< opened files, latest first
    std::optional<Language> language = {};
    Student student = {};
    std::string lesson = {};  ///< the id of the lesson that was open last; "" for none
    MouseHabits mouse = {};
    bool operator==(const Remembered&) const = default;
};

/// Returns $XDG_CONFIG_HOME/viewing-sandbox/window.json, or the same file below $HOME/.config; empty if neither
/// variable contains an absolute path.
std::filesystem::path remembered_file();

/// Reads the settings; returns an empty value if there is no file. The error is one sentence that names the file.
Result<Remembered> read_remembered(const std::filesystem::path& file);

/// Writes the settings, and creates the folder if it is missing. Use merge_remembered() for a file that other windows
/// write too.
Status write_remembered(const std::filesystem::path& file, const Remembered& remembered);

/// Merges the content of a file that other windows write too. `kept` is the file's content, `known` is what this window
/// last read or wrote, and `now` is what it has now. The theme, scale, language, position, mouse habits, student and a
/// lesson's step come from this window if it changed them since then, otherwise from the file. The completed steps are
/// the union of both lists; files that this window has opened since then come first. Merging again changes nothing.
Remembered merged(const Remembered& kept, const Remembered& known, const Remembered& now);

/// Merges `now` into the file under a lock, and returns the file's new content. Renames a file that cannot be read
/// (set_aside); writes nothing if `file` is empty. The error is one sentence.
Result<Remembered> merge_remembered(const std::filesystem::path& file, const Remembered& known, const Remembered& now);

/// Returns whether one of the screens shows enough of a window's upper edge to grab it.
bool is_reachable(const WindowPlace& window, std::span<const WindowPlace> screens);

}  // namespace viewing
