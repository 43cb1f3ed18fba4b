// The names by which a lesson covers and points out what the window shows: "matrix:V[2][3]", "control:camera.yaw",
// "view:observer". A closed list, of what the window can find. A name stands for all that it contains: "matrix:V" for
// every entry of V, "control:camera" for all of the camera's controls. widgets/targets.h covers and finds them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/result.h"

namespace viewing {

/// The name as the window knows it; for another, a sentence with the nearest known one.
Result<std::string> read_target(std::string_view name);

/// Every name, in the order of their kinds, but for components of fields ("control:light.position[3]") and entries of
/// matrices ("matrix:V[2][3]", and "matrix:S[3]" for a row), which are names too. Behind "view:camera" there may stand
/// what it shows then, "view:camera(difference)": a note for whoever reads it, which the window does not need.
std::vector<std::string> target_names();

}  // namespace viewing
