// A state with all the files it needs in one folder, to be given to somebody.
#pragma once

#include <string>

#include "state/presets.h"
#include "state/scene.h"

namespace viewing {

/// Writes the folder: state.json, and beside it the scene's file, the meshes and the material libraries that these
/// name, from each further folder in one of its own ("2", "3", …). What comes with the program is named, not copied.
/// `scene` is the state's. The folder must not be there yet, or be empty; it appears whole (whole_folder.h).
/// Returns the path of its state.json. Throws Failure.
std::string write_bundle(const std::string& folder, const LoadedState& state, const Scene& scene);

}  // namespace viewing
