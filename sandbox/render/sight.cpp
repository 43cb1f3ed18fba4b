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

/// All corners on the negative side, by more than what single precision may have rounded. The sum is linear in the
/// corner, so then all of the box is, whatever becomes of w.
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
    if (box_model.empty() || pass.forces_sign) return false;  // which turns vertices around, one by one
    const std::array<glm::dvec4, 8> corners = corners_of(box_model);
    for (const ClipPlane& plane : pass.clip_planes)
        if (are_beyond(corners, plane * world_from_model)) return true;
    const glm::dmat4 rows = glm::transpose(pass.clip_from_world * pass.world_from_scene * world_from_model);
    for (const int axis : {0, 1})
        if (are_beyond(corners, rows[3] + rows[axis]) || are_beyond(corners, rows[3] - rows[axis])) return true;
    return false;
}

}  // namespace viewing
