// Computes, from a camera, the quantities that the methods need. Read painter.cpp next.
#include "topics/hidden/methods/viewpoint.h"

#include "geometry/camera.h"
#include "geometry/plane.h"
#include "geometry/projection.h"

namespace viewing {

double Viewpoint::distance(const glm::dvec3& point_world) const {
    const glm::dmat4& m = view_from_world;
    return -(m[0][2] * point_world.x + m[1][2] * point_world.y + m[2][2] * point_world.z + m[3][2]);
}

glm::dvec4 Viewpoint::eye_world() const {
    if (!is_rigid(view_from_world))
        if (const std::optional<glm::dvec4> eye = eye_of(clip_from_world(), false)) return *eye;
    const bool is_perspective = clip_from_view[2][3] != 0.0;
    const glm::dmat3 world_from_view_rotation = glm::transpose(glm::dmat3(view_from_world));
    if (is_perspective) return {-(world_from_view_rotation * glm::dvec3(view_from_world[3])), 1.0};
    return {world_from_view_rotation[2], 0.0};
}

std::optional<glm::dvec4> Viewpoint::eye_plane_world() const {
    const glm::dvec4 w_of_world = glm::transpose(clip_from_world())[3];
    const double length = glm::length(glm::dvec3(w_of_world));
    if (!(length > 0.0)) return std::nullopt;
    constexpr double before_eye = 1e-7;  // world units
    return w_of_world / length - glm::dvec4(0.0, 0.0, 0.0, before_eye);
}

glm::dvec4 Viewpoint::near_plane_world() const {
    const glm::dmat4 rows = glm::transpose(clip_from_world());
    return unit_plane(rows[3] + rows[2]);
}

}  // namespace viewing
