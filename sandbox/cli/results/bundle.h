// A state with all the files it needs in one folder, ready to share.
#pragma once

#include <string>

#include "state/presets.h"
#include "state/scene.h"

namespace viewing {

/// Writes state.json, and in the same folder the state's scene file, the scene's meshes and the meshes' material
/// libraries. Files from each additional source folder go into a subfolder ("2", "3", …). Files that come with the
/// program are referred to by name, not copied. `scene` is the scene of `state`. The folder must be new or empty; it
/// appears only when complete (whole_folder.h). Returns the path of its state.json. Throws Failure.
std::string write_bundle(const std::string& folder, const LoadedState& state, const Scene& scene);

}  // namespace viewing
