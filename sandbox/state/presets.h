// Presets: state files in assets/presets, each with a title and a description. Also loads a STATE argument.
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

/// A file with its titles; without a title, the name is its title.
struct NamedFile : Titles {
    std::string name;  ///< file name without .json, as typed on the command line
    std::filesystem::path path;
    /// Whether its state sets the theme or the text size; if so, the preset opens only from the list, and Page Down
    /// skips it.
    bool sets_looks = false;
};

/// Returns the presets of the assets directory in the order of the lecture, as listed in lecture.json next to them
/// ("opening" first); presets that are not listed follow by name.
std::vector<NamedFile> presets();
/// Returns the scenes of the assets directory, sorted by name.
std::vector<NamedFile> scenes();

/// Returns the text that follows "neither a file nor a preset": it says where the names are listed, and gives the name
/// nearest to a misspelled word.
std::string names_hint(std::string_view word, std::span<const NamedFile> files);

/// The preset that a state was opened from, with the parameters of its file.
struct OpenPreset {
    std::string name;
    Params params;
};

struct LoadedState {
    Params params;
    std::filesystem::path base;          ///< the folder that the scene's relative paths start from
    std::string scene_origin = "scene";  ///< messages about the scene begin with it: "room.json: scene", "--set scene"
    std::shared_ptr<const OpenPreset> preset = nullptr;  ///< null if the state is not from a preset
    Titles titles = {};                                  ///< the titles of its file; empty if there are none
    std::shared_ptr<const Flight> flight = nullptr;      ///< the file's flight, which starts at `params`; else null
    FileReach reach = {};  ///< the files that its scene may read: for a state file, those in its folder
};

/// Loads the STATE argument of the command line: the path of a .json file, which contains a state or a flight; the path
/// of a figure (.png, .svg, .pdf) that contains its state; a preset's name, or "" for the opening preset; or a link to
/// a state or a preset. lesson/linked_step.h handles links to a lesson.
Result<LoadedState> load_state(const std::string& argument);

/// Loads a state or a link from a string; `source` starts every message.
Result<LoadedState> state_in_text(const std::string& text, const std::string& source);

}  // namespace viewing
