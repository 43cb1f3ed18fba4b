// The camera that the methods in this folder use. Read painter.h next.
#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace viewing {

/// A camera. Distances from the eye are positive in front of it.
struct Viewpoint {
    glm::dmat4 view_from_world{1.0};  ///< rigid, perhaps mirrored, unless entered by hand; looks along −z
    glm::dmat4 clip_from_view{1.0};   ///< perspective or orthographic, clip range −1 … 1, invertible

    glm::dmat4 clip_from_world() const { return clip_from_view * view_from_world; }

    /// Returns the eye distance −z of a point in world space.
    double distance(const glm::dvec3& point_world) const;

    /// Returns the eye with w = 1 or, for an orthographic camera, the unit direction toward the viewer with w = 0. In
    /// both cases, its dot product with a unit plane is positive if the plane's front is visible, 0 if the plane is
    /// seen edge-on.
    glm::dvec4 eye_world() const;

    /// Returns the unit plane in world space on which clip z = −w; visible points are on its positive side.
    glm::dvec4 near_plane_world() const;

    /// Returns the unit plane just in front of a perspective eye, perpendicular to its view direction; none for an
    /// orthographic camera.
    std::optional<glm::dvec4> eye_plane_world() const;

    bool operator==(const Viewpoint&) const = default;
};

}  // namespace viewing
