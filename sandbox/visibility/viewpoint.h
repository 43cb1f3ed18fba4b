// Where a method looks from: the camera as every method of this room takes it. Read painter.h next.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace viewing {

/// A camera. Distances from the eye are positive in front of it.
struct Viewpoint {
    glm::dmat4 view_from_world{1.0};  ///< rigid, or rigid and mirrored; looks along −z
    glm::dmat4 clip_from_view{1.0};   ///< perspective or orthographic, clip range −1 … 1, invertible

    glm::dmat4 clip_from_world() const { return clip_from_view * view_from_world; }

    /// Eye distance −z of a point in world space.
    double distance(const glm::dvec3& point_world) const;

    /// The eye with w = 1, or for an orthographic camera the unit direction towards the viewer with w = 0: its dot
    /// product with a unit plane is positive when the plane's front is seen, 0 when the plane is seen edge-on.
    glm::dvec4 eye_world() const;

    /// The plane on which clip z = −w, unit, in world space; what is seen lies on its positive side.
    glm::dvec4 near_plane_world() const;

    /// The plane just before a perspective eye, across its line of sight, unit; none for an orthographic camera.
    std::optional<glm::dvec4> eye_plane_world() const;

    bool operator==(const Viewpoint&) const = default;
};

}  // namespace viewing
