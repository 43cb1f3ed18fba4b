// Presets: state files in assets/presets, each with a title and a sentence, and how a STATE argument is found.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "state/file/flight.h"
#include "state/file/titles.h"
#include "state/file_reach.h"
#include "state/params.h"
#include "text/result.h"

namespace viewing {

struct NamedFile {
    std::string name;   ///< file name without .json: what a person types
    std::string title;  ///< its "title" field, else the name
    std::string about;  ///< its "about" field, one sentence
    std::string group;  ///< its "group" field: the headline that it stands below in a list; "" for none
    /// Its "mended_by" field, of a preset that breaks the picture: the setting that puts it right, as on the command
    /// line.
    std::string mended_by;
    std::filesystem::path path;
    /// Its state sets theme or size of type: chosen from the list only, never on the way that Page Down takes.
    bool sets_looks = false;
};

/// The presets of the assets directory in the order of the lecture, as lecture.json beside them lists it ("opening"
/// first); what it does not list follows by name.
std::vector<NamedFile> presets();
/// Its scenes, sorted by name.
std::vector<NamedFile> scenes();

/// What follows "neither a file nor a preset": where the names are listed, and the nearest one to a misspelt word.
std::string names_hint(std::string_view word, std::span<const NamedFile> files);

/// The preset that a state was opened from, and its parameters as its file has them.
struct OpenPreset {
    std::string name;
    Params params;
};

struct LoadedState {
    Params params;
    std::filesystem::path base;          ///< what the scene's relative paths are relative to
    std::string scene_origin = "scene";  ///< how messages about the scene open: "room.json: scene", "--set scene"
    std::shared_ptr<const OpenPreset> preset = nullptr;  ///< none for a file of one's own
    Titles titles = {};                              ///< what its file says about itself; none for the opening state
    std::shared_ptr<const Flight> flight = nullptr;  ///< where it is one: `params` are its start
    FileReach reach = {};  ///< what its scene may be read from; of one that was loaded, its own folder
};

/// STATE of the command line: a path to a .json file, a preset's name, "" for the opening preset; a figure (.png, .svg,
/// .pdf) that carries its state; a flight; a link to a state or a preset (of a lesson's: lesson/linked_step.h).
Result<LoadedState> load_state(const std::string& argument);

/// The same from a text, a state or a link; `source` opens every message.
Result<LoadedState> state_in_text(const std::string& text, const std::string& source);

}  // namespace viewing
