// The camera as gluLookAt takes it: eye, center and up. The angles define the camera; look_at_of converts them to eye,
// center and up, and camera_looking_at converts these back. Read camera.h first.
#pragma once

#include <glm/glm.hpp>

#include "geometry/camera.h"

namespace viewing {

/// The arguments of glm::lookAt, in world coordinates and world units. The camera looks from `eye` toward `center`;
/// `up` is a direction of any length, which appears vertical in the picture.
struct LookAt {
    glm::dvec3 eye{0.0, 0.0, 5.0};
    glm::dvec3 center{0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    bool operator==(const LookAt&) const = default;
};

/// The reasons why a LookAt may not define a camera; glm::lookAt then returns NaN.
enum class LookAtFault { none, center_is_eye, up_along_view };

/// The camera of a LookAt: its position is the eye.
struct Looking {
    Angles angles;
    LookAtFault fault = LookAtFault::none;
};

/// Returns the angles of V = lookAt(eye, center, up): yaw and roll in (−180, 180]°, pitch in [−90, 90]°. If center =
/// eye (within 1e-12 times the largest coordinate), the camera looks along −z. If up is zero or parallel to the view
/// (within 1e-9 rad), the roll is 0.
Looking camera_looking_at(const LookAt& look_at);

/// Returns eye, center and up of a camera, with the center `distance` > 0 world units in front of the eye. `up` is
/// (0, 1, 0), as in books, if the roll is 0 and the pitch is below 89°; else the camera's own up axis, of length 1.
LookAt look_at_of(const glm::dvec3& position, const Angles& angles, double distance);

}  // namespace viewing
