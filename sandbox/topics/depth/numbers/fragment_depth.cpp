#include "topics/depth/numbers/fragment_depth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "topics/depth/numbers/fighting.h"

namespace viewing {
namespace {

double distance_of(const PixelTriangle& triangle, const glm::dvec3& weights) {
    return weights.x * triangle[0].distance + weights.y * triangle[1].distance + weights.z * triangle[2].distance;
}

/// Returns clip z and w. The vertex shader computes z with a logarithm, and GL interpolates both.
glm::dvec2 logarithmic_zw(const FramePlan& plan, const PixelTriangle& triangle, const glm::dvec3& weights) {
    constexpr double nearest = 1e-30;  // there is no logarithm behind the eye
    glm::dvec2 zw(0.0);
    for (std::size_t i = 0; i < triangle.size(); ++i) {
        const double distance = std::max(triangle[i].distance, nearest);
        const double z = 2.0 * window_depth(plan.lens, DepthMapping::logarithmic, distance) - 1.0;
        zw += weights[static_cast<int>(i)] * triangle[i].w * glm::dvec2(z, 1.0);
    }
    return zw;
}

double depth_at(const FramePlan& plan, const PixelTriangle& triangle, const glm::dvec3& weights) {
    if (!plan.has_logarithm_per_vertex())
        return window_depth(plan.lens, plan.depth_mapping, distance_of(triangle, weights));
    const glm::dvec2 zw = logarithmic_zw(plan, triangle, weights);
    return 0.5 * zw.x / zw.y + 0.5;
}

/// Returns the width of one code in window depth. For a float, GL uses the code at the triangle's greatest depth; a
/// shader that writes depth uses the format's own codes, but at most 24 bits.
double code_of_unit(const FramePlan& plan, const PixelTriangle& triangle) {
    const bool by_shader = writes_depth_by_shader(plan.depth_format, plan.depth_mapping, plan.logarithm_per_vertex);
    const DepthPrecision precision = by_shader ? precision_of(plan.depth_format) : plan.stored_depth.precision;
    if (!precision.is_float || by_shader) return 1.0 / (std::exp2(std::min(precision.bits, 24)) - 1.0);
    double greatest = std::numeric_limits<float>::min();
    for (const PixelCorner& corner : triangle)
        greatest = std::max(greatest, window_depth(plan.lens, plan.depth_mapping, corner.distance));
    return std::exp2(std::ilogb(std::min(greatest, 1.0)) - 23);
}

/// Returns how much window depth one unit of an offset spans.
double unit_of(const FramePlan& plan, const PixelTriangle& triangle) {
    return plan.stored_depth.unit_codes.value_or(1.0) * code_of_unit(plan, triangle);
}

/// Returns the error of one unit: 0 if the unit was measured; otherwise one code, since GL does not define its size.
double unit_error(const FramePlan& plan, const PixelTriangle& triangle) {
    return plan.stored_depth.unit_codes ? 0.0 : code_of_unit(plan, triangle);
}

/// Returns the largest change in depth from the pixel to a neighboring pixel in x or y. `depth_there` and
/// `distance_there` take weights.
template <typename Depth, typename Distance>
double steepest(const PixelTriangle& triangle, const PixelHit& hit, const glm::dvec2& neighbors_px, Depth depth_there,
                Distance distance_there) {
    const double here = depth_there(hit.weights);
    double most = 0.0;
    for (const glm::dvec2 beside_px : {glm::dvec2(neighbors_px.x, 0.0), glm::dvec2(0.0, neighbors_px.y)}) {
        glm::dvec3 there = weights_beside(triangle, beside_px);
        const bool beyond_horizon = !(distance_there(there) > 0.0);
        if (beyond_horizon) there = weights_beside(triangle, -beside_px);
        most = std::max(most, std::abs(depth_there(there) - here));
    }
    return most;
}

double slope_of(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit,
                const glm::dvec2& neighbors_px) {
    return steepest(
        triangle, hit, neighbors_px, [&](const glm::dvec3& weights) { return depth_at(plan, triangle, weights); },
        [&](const glm::dvec3& weights) { return distance_of(triangle, weights); });
}

/// Returns a depth after it has passed through the clip range. When reversed depth is in −1 … 1, GL halves the value
/// and adds 0.5 in float32, which rounds away the finest steps.
double as_clip_range_keeps(const FramePlan& plan, double depth) {
    if (plan.clip_zero_to_one || plan.depth_mapping != DepthMapping::reversed) return depth;
    const auto z_ndc = static_cast<float>(2.0 * depth - 1.0);
    return static_cast<double>(0.5F * z_ndc + 0.5F);
}

/// Moves a depth by an offset, and clamps it. `slope` returns the triangle's slope.
template <typename Slope>
double with_offset(const FramePlan& plan, const PixelTriangle& triangle, double depth, const DepthOffset& offset,
                   Slope slope) {
    if (offset.factor != 0.0) depth += offset.factor * slope();
    if (offset.units != 0.0) depth += offset.units * unit_of(plan, triangle);
    return std::clamp(depth, 0.0, 1.0) + 0.0;  // + 0: no negative zero, whose bits would be a large code
}

/// Returns the weighted sums of two of the corners' members.
glm::dvec2 weighted_pair(const ProjectedTriangle& triangle, const glm::dvec3& weights, double ProjectedCorner::*first,
                         double ProjectedCorner::*second) {
    glm::dvec2 sum(0.0);
    for (std::size_t i = 0; i < triangle.size(); ++i)
        sum += weights[static_cast<int>(i)] * glm::dvec2(triangle[i].*first, triangle[i].*second);
    return sum;
}

glm::dvec2 clip_zw(const ProjectedTriangle& triangle, const glm::dvec3& weights) {
    return weighted_pair(triangle, weights, &ProjectedCorner::z, &ProjectedCorner::w);
}

/// Returns the depth that GL interpolates at the point with these weights, before an offset and without clamping.
double projected_depth(const FramePlan& plan, const ProjectedTriangle& triangle, const glm::dvec3& weights) {
    if (plan.depth_mapping == DepthMapping::logarithmic && !plan.logarithm_per_vertex)
        return window_depth(plan.lens, plan.depth_mapping, std::max(projected_distance(triangle, weights), 1e-30));
    const glm::dvec2 zw = clip_zw(triangle, weights);
    return plan.clip_zero_to_one ? zw.x / zw.y : 0.5 * zw.x / zw.y + 0.5;
}

}  // namespace

double projected_distance(const ProjectedTriangle& triangle, const glm::dvec3& weights) {
    const glm::dvec2 zw = weighted_pair(triangle, weights, &ProjectedCorner::view_z, &ProjectedCorner::view_w);
    return -zw.x / zw.y;
}

bool is_in_clip_range(const FramePlan& plan, const ProjectedTriangle& triangle, const glm::dvec3& weights) {
    const glm::dvec2 zw = clip_zw(triangle, weights);
    return zw.y > 0.0 && zw.x <= zw.y && zw.x >= (plan.clip_zero_to_one ? 0.0 : -zw.y);
}

double projected_depth_of(const FramePlan& plan, const PixelTriangle& seen, const ProjectedTriangle& triangle,
                          const PixelHit& hit, const DepthOffset& offset, const glm::dvec2& neighbors_px) {
    const auto depth_there = [&](const glm::dvec3& weights) { return projected_depth(plan, triangle, weights); };
    const auto distance_there = [&](const glm::dvec3& weights) { return projected_distance(triangle, weights); };
    return with_offset(plan, seen, as_clip_range_keeps(plan, depth_there(hit.weights)), offset,
                       [&] { return steepest(seen, hit, neighbors_px, depth_there, distance_there); });
}

bool is_in_depth_range(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit) {
    if (!plan.has_logarithm_per_vertex()) return hit.distance >= plan.lens.near && hit.distance <= plan.lens.far;
    const glm::dvec2 zw = logarithmic_zw(plan, triangle, hit.weights);
    return zw.y > 0.0 && std::abs(zw.x) <= zw.y;
}

double depth_of(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit, const DepthOffset& offset,
                const glm::dvec2& neighbors_px) {
    return with_offset(plan, triangle, as_clip_range_keeps(plan, depth_at(plan, triangle, hit.weights)), offset,
                       [&] { return slope_of(plan, triangle, hit, neighbors_px); });
}

double depth_error(const FramePlan& plan, const PixelTriangle& triangle, const PixelHit& hit, const DepthOffset& offset,
                   const glm::dvec2& neighbors_px, glm::ivec2 size_px) {
    constexpr double coarser_than_ieee = 3.0, corner_px = 1.0 / 256.0;
    const double nearest = std::min({triangle[0].distance, triangle[1].distance, triangle[2].distance});
    const DepthCoding coding{plan.lens, plan.depth_mapping, plan.stored_depth.precision, plan.clip_zero_to_one};
    const double arithmetic = depth_rounding(coding, hit.distance, hit.distance - nearest);
    const double place_px = std::exp2(-24) * (size_px.x + size_px.y);
    return coarser_than_ieee * arithmetic +
           slope_of(plan, triangle, hit, neighbors_px) * (corner_px + coarser_than_ieee * place_px) +
           std::abs(offset.units) * unit_error(plan, triangle);
}

double stored_within(double depth, double error, const DepthPrecision& precision) {
    // Floats at the start of the range are closest together.
    const double width = code_width(precision, precision.is_float ? std::max(depth - error, 0.0) : depth);
    return std::floor(error / width) + 1.0;
}

std::uint32_t code_of(double depth, const DepthPrecision& precision) {
    if (precision.is_float) return std::bit_cast<std::uint32_t>(static_cast<float>(depth));
    return static_cast<std::uint32_t>(std::llround(depth * precision.greatest_code()));
}

}  // namespace viewing
