// "Find me a view where this key fails": turns a camera about a target and looks for the view in which the painter's
// picture, sorted by one key, differs most from ray casting. Read painter.h for the keys, ray_cast.h for the reference.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>

#include "platform/progress.h"
#include "visibility/painter.h"
#include "visibility/polygons.h"
#include "visibility/viewpoint.h"

namespace viewing {

/// A camera that turns about a target, looks at it, and does not roll. Angles as in geometry/camera.h: at 0 and 0 it
/// looks along −z; a negative pitch looks down, so the eye stands higher than the target.
struct Orbit {
    glm::dvec3 target_world{0.0};
    double distance = 8.0;  ///< of the eye from the target, world units; also for an orthographic camera
    glm::dmat4 clip_from_view{1.0};
};

struct OrbitView {
    double yaw_deg = 0.0, pitch_deg = 0.0;
};

glm::dvec3 eye_on_orbit(const Orbit& orbit, const OrbitView& view);
Viewpoint viewpoint_on_orbit(const Orbit& orbit, const OrbitView& view);

struct FailureSearchOptions {
    PainterKey key = PainterKey::farthest;
    OrbitView start{};            ///< where the camera is now; of equally wrong views the first tried is kept
    int width = 96, height = 54;  ///< of the pictures that are compared
};

struct FailureView {
    bool found = false;
    bool cancelled = false;
    OrbitView view;  ///< where most pixels are wrong; the start when there is none; yaw in (−180, 180]
    glm::dvec3 position_world{0.0};
    std::int64_t wrong_pixels = 0;  ///< there, as difference() counts them
    std::int64_t compared = 0;      ///< pixels of a picture
    int views_tried = 0;
    std::string sentence;  ///< what came out, for the screen
};

/// Looks all round at the start's pitch and at three more, from the start on, every 15 degrees; if nothing fails, once
/// more in between; then near the worst view with ever smaller steps. The eye stays above the target, or above where it
/// is. Deterministic. Without polygons, pixels or a finite orbit nothing is tried. Cancelled: the worst view so far.
FailureView find_failure(std::span<const Polygon> polygons, const Orbit& orbit, const FailureSearchOptions& options,
                         WorkProgress* progress = nullptr);

}  // namespace viewing
