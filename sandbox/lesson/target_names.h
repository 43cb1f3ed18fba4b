// Names of the window's parts, which lessons cover and highlight: "matrix:V[2][3]", "control:camera.yaw",
// "view:observer". The list is closed: it contains only parts that the window can find. A name includes everything
// inside that part: "matrix:V" includes every entry of V, and "control:camera" all of the camera's controls.
// widgets/targets.h covers and finds them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/result.h"

namespace viewing {

/// The beginnings of the calls that can be named in the list of passes: "call:glClear" is the first line of the list
/// that begins that way.
inline constexpr const char* named_calls[] = {"glClear(", "glDepthMask(GL_FALSE)", "glEnable(GL_CULL_FACE)"};

/// Returns the name in the form that the window uses. For an unknown name, the error is a sentence that suggests the
/// nearest one.
Result<std::string> read_target(std::string_view name);

/// Returns every name, ordered by kind, except components of fields ("control:light.position[3]") and entries of
/// matrices ("matrix:V[2][3]", and "matrix:S[3]" for a row), which are valid too. "view:camera" may be followed by a
/// note on the content of the view, "view:camera(difference)", which the window ignores.
std::vector<std::string> target_names();

}  // namespace viewing
