// Writes the camera as a look-at call to paste into other programs, for the panel and `matrices --format text`.
#pragma once

#include <string>

#include "geometry/look_at.h"

namespace viewing {

enum class LookAtCall { glm, glu, three };

/// Returns the call: glm::lookAt as an expression, gluLookAt as a statement, or the statements of three.js, where a
/// camera also looks along −z. Every number reads back to the same double; −0 becomes 0.
std::string look_at_call(const LookAt& look_at, LookAtCall call);

}  // namespace viewing
