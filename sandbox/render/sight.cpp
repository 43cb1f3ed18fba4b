#include "render/sight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace viewing {
namespace {

std::array<glm::dvec4, 8> corners_of(const Bounds& box) {
    std::array<glm::dvec4, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                      (i & 4) != 0 ? box.max.z : box.min.z, 1.0};
    return corners;
}

/// Whether all corners are on the negative side of the plane, by more than rounding in single precision can explain.
/// The dot product is linear in the corner, so the whole box is then on that side, even if w changes sign in it.
bool are_beyond(const std::array<glm::dvec4, 8>& corners, const glm::dvec4& plane) {
    constexpr double rounding = 1e-5;
    return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec4& corner) {
        const glm::dvec4 terms = plane * corner;
        const double size = std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z) + std::abs(terms.w);
        return terms.x + terms.y + terms.z + terms.w < -rounding * size;
    });
}

}  // namespace

bool is_out_of_sight(const Bounds& box_model, const Pass& pass, const glm::dmat4& world_from_model) {
    if (box_model.empty() || pass.forces_sign) return false;  // a forced sign may move vertices out of the box
    const std::array<glm::dvec4, 8> corners = corners_of(box_model);
    for (const ClipPlane& plane : pass.clip_planes)
        if (are_beyond(corners, plane * world_from_model)) return true;
    const glm::dmat4 rows = glm::transpose(pass.clip_from_world * pass.world_from_scene * world_from_model);
    for (const int axis : {0, 1})
        if (are_beyond(corners, rows[3] + rows[axis]) || are_beyond(corners, rows[3] - rows[axis])) return true;
    return false;
}

bool is_kept_whole(const Bounds& box_model, std::span<const glm::vec3> positions_model, const Pass& pass,
                   const glm::dmat4& world_from_model) {
    constexpr std::size_t most_asked = 4096;
    if (box_model.empty()) return true;
    const std::array<glm::dvec4, 8> corners = corners_of(box_model);
    return std::all_of(pass.clip_planes.begin(), pass.clip_planes.end(), [&](const ClipPlane& plane) {
        const glm::dvec4 plane_model = plane * world_from_model;
        const auto is_kept = [&](const glm::dvec4& point) { return glm::dot(plane_model, point) >= 0.0; };
        if (std::all_of(corners.begin(), corners.end(), is_kept)) return true;
        return !positions_model.empty() && positions_model.size() <= most_asked &&
               std::all_of(positions_model.begin(), positions_model.end(),
                           [&](const glm::vec3& position) { return is_kept(glm::dvec4(position, 1.0)); });
    });
}

}  // namespace viewing
