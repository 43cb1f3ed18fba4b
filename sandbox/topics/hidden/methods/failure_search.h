// "Find me a view where this key fails": orbits a camera about a target and searches for the view in which the
// painter's picture, sorted by one key, differs most from ray casting. See painter.h for the keys and ray_cast.h for
// the reference.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>

#include "platform/progress.h"
#include "text/message.h"
#include "topics/hidden/methods/painter.h"
#include "topics/hidden/methods/polygons.h"
#include "topics/hidden/methods/viewpoint.h"

namespace viewing {

/// A camera that orbits a target, looks at it, and does not roll. Its angles are as in geometry/camera.h: with yaw and
/// pitch 0, it looks along −z; with a negative pitch, it looks down, so the eye is above the target.
struct Orbit {
    glm::dvec3 target_world{0.0};
    double distance = 8.0;  ///< from the eye to the target, world units; also for an orthographic camera
    glm::dmat4 clip_from_view{1.0};
};

struct OrbitView {
    double yaw_deg = 0.0, pitch_deg = 0.0;
};

glm::dvec3 eye_on_orbit(const Orbit& orbit, const OrbitView& view);
Viewpoint viewpoint_on_orbit(const Orbit& orbit, const OrbitView& view);

struct FailureSearchOptions {
    PainterKey key = PainterKey::farthest;
    OrbitView start{};            ///< the current camera; among equally wrong views, the first one tried is kept
    int width = 96, height = 54;  ///< size of the compared pictures, in pixels
};

struct FailureView {
    bool found = false;
    bool canceled = false;
    OrbitView view;  ///< the view with the most wrong pixels, or the start if there are none; yaw in (−180, 180]
    glm::dvec3 position_world{0.0};
    std::int64_t wrong_pixels = 0;  ///< in that view, as difference() counts them
    std::int64_t compared = 0;      ///< number of pixels in one picture
    int views_tried = 0;
    Message sentence;  ///< the result, for the screen
};

/// Searches the full circle in 15-degree steps of yaw, at the start's pitch and at three others, beginning at the
/// start. If nothing fails, searches once more at yaws and pitches in between. Then searches near the worst view in
/// ever smaller steps. The eye never goes below the target or, if it starts there, below its start. The search is
/// deterministic. Tries no view if there are no polygons or no pixels, or if the orbit is not finite. If canceled,
/// returns the worst view so far.
FailureView find_failure(std::span<const Polygon> polygons, const Orbit& orbit, const FailureSearchOptions& options,
                         WorkProgress* progress = nullptr);

}  // namespace viewing
