// Each edge of a triangle forms a smaller triangle with the pixel's center. Twice the signed areas of these three tell
// whether the triangle covers the center, and give the weights of its corners there.
#include "topics/depth/numbers/pixel_triangle.h"

#include <cmath>

namespace viewing {
namespace {

/// A tolerance relative to the terms of the sum, so that rounding never rejects a box that covers the pixel.
constexpr double rounding = 1e-9;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Returns twice the signed areas that a point beside the center forms with the edges opposite the corners. Divided by
/// their sum, they are the corners' weights at that point.
glm::dvec3 areas(const PixelTriangle& triangle, const glm::dvec2& beside_px) {
    std::array<glm::dvec2, 3> to;
    for (std::size_t i = 0; i < 3; ++i) to[i] = triangle[i].offset_px - triangle[i].w * beside_px;
    return {cross(to[1], to[2]), cross(to[2], to[0]), cross(to[0], to[1])};
}

/// Returns whether an edge through the center, with the triangle to its left, counts as inside: the area must grow to
/// the right or, if it does not change in that direction, downward.
bool owns_edge(const PixelCorner& from, const PixelCorner& to, double sign) {
    const glm::dvec2 growth = sign * (to.w * glm::dvec2(from.offset_px.y, -from.offset_px.x) -
                                      from.w * glm::dvec2(to.offset_px.y, -to.offset_px.x));
    return growth.x > 0.0 || (growth.x == 0.0 && growth.y < 0.0);
}

double weighted(const PixelTriangle& triangle, const glm::dvec3& weights, double PixelCorner::*value) {
    return weights.x * triangle[0].*value + weights.y * triangle[1].*value + weights.z * triangle[2].*value;
}

double sum_of(const glm::dvec3& weights) {
    return weights.x + weights.y + weights.z;
}

}  // namespace

std::optional<PixelHit> hit(const PixelTriangle& triangle) {
    const glm::dvec3 weights = areas(triangle, {0.0, 0.0});
    const double sum = sum_of(weights);
    if (!(sum != 0.0)) return std::nullopt;
    const double sign = sum < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double inside = sign * weights[static_cast<int>(i)];
        const bool counts =
            inside > 0.0 || (inside == 0.0 && owns_edge(triangle[(i + 1) % 3], triangle[(i + 2) % 3], sign));
        if (!counts) return std::nullopt;
    }
    return PixelHit{weighted(triangle, weights, &PixelCorner::distance) / sum, sign > 0.0, weights / sum};
}

glm::dvec3 weights_beside(const PixelTriangle& triangle, const glm::dvec2& beside_px) {
    const glm::dvec3 weights = areas(triangle, beside_px);
    return weights / sum_of(weights);
}

glm::dvec2 neighbors_px(glm::ivec2 pixel, glm::ivec2 size_px) {
    return {pixel.x % 2 == 0 ? 1.0 : -1.0, (size_px.y - 1 - pixel.y) % 2 == 0 ? 1.0 : -1.0};
}

PixelView::PixelView(const glm::dmat4& clip_from_space, const glm::dmat4& view_from_space, glm::ivec2 pixel,
                     glm::ivec2 size_px) {
    const glm::dvec2 half_size = glm::dvec2(size_px) * 0.5;
    const glm::dvec2 center = (glm::dvec2(pixel) + 0.5) / half_size - 1.0;
    const glm::dmat4 rows = glm::transpose(clip_from_space);
    across_ = (rows[0] - center.x * rows[3]) * half_size.x;
    up_ = (rows[1] + center.y * rows[3]) * half_size.y;
    w_ = rows[3];
    distance_ = -glm::transpose(view_from_space)[2];
}

PixelCorner PixelView::corner(const glm::dvec3& point) const {
    const glm::dvec4 homogeneous(point, 1.0);
    return {{glm::dot(across_, homogeneous), glm::dot(up_, homogeneous)},
            glm::dot(w_, homogeneous),
            glm::dot(distance_, homogeneous)};
}

bool PixelView::may_meet(const Bounds& bounds) const {
    if (bounds.empty()) return false;
    const glm::dvec3 center = bounds.center(), half = bounds.size() * 0.5;
    const auto can_be_zero = [&](const glm::dvec4& plane) {
        const glm::dvec3 slopes = glm::abs(glm::dvec3(plane));
        const double slack = rounding * (glm::dot(slopes, glm::abs(center) + half) + std::abs(plane.w));
        return std::abs(glm::dot(glm::dvec3(plane), center) + plane.w) <= glm::dot(slopes, half) + slack;
    };
    return can_be_zero(across_) && can_be_zero(up_);
}

}  // namespace viewing
