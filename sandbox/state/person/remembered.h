// What the window remembers of a person from one time to the next: theme, scale, language, size and place, how far one
// is in the lessons, files that were opened; never the state. Read and written by the window alone: a headless command
// touches no file that was not named.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "state/params.h"
#include "state/person/lesson_progress.h"
#include "text/result.h"

namespace viewing {

/// In the units of the window system, which need not be pixels; y counts downwards.
struct WindowPlace {
    glm::ivec2 position{0}, size{0};
    bool maximised = false;
    bool operator==(const WindowPlace&) const = default;
};

struct Remembered {
    std::optional<Theme> theme;
    std::optional<double> scale;
    std::optional<WindowPlace> window;
    LessonsProgress lessons = {};
    std::vector<std::string> recent = {};  ///< files that were opened, the latest first
    std::optional<Language> language = {};
    Student student = {};
    bool operator==(const Remembered&) const = default;
};

/// $XDG_CONFIG_HOME/viewing-sandbox/window.json, or below ~/.config; empty where neither variable names a folder.
std::filesystem::path remembered_file();

/// Nothing remembered where there is no such file. The error is one sentence that names it.
Result<Remembered> read_remembered(const std::filesystem::path& file);

/// Makes the folder where it is missing. For a file that other windows write as well: merge_remembered().
Status write_remembered(const std::filesystem::path& file, const Remembered& remembered);

/// What the file is to hold that other windows write as well. `kept`: what it holds; `known`: what this window had when
/// it read or wrote it last; `now`: what it has. Each of theme, scale, language, place, student and a lesson's step is
/// the window's where it has changed it since, else the file's. Steps that are done are united; files that the window
/// has opened since go before the others. Merging the same once more changes nothing.
Remembered merged(const Remembered& kept, const Remembered& known, const Remembered& now);

/// Writes that, under a lock; the result is what the file holds then. One that cannot be read gets another name
/// (set_aside); nothing is written where `file` is empty. The error is one sentence.
Result<Remembered> merge_remembered(const std::filesystem::path& file, const Remembered& known, const Remembered& now);

/// Whether enough of a window's upper edge lies on one of the screens to be taken hold of.
bool is_reachable(const WindowPlace& window, std::span<const WindowPlace> screens);

}  // namespace viewing
