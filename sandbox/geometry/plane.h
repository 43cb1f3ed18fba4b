// The plane a x + b y + c z + d = 0: its unit form, the patch drawn for it, and the lecture's two matrices, shadow
// (Blinn 1988) and reflection.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace viewing {

/// Returns the plane scaled so that (a, b, c) has length 1; keeps its sign. The normal must not be zero.
glm::dvec4 unit_plane(const glm::dvec4& plane);

/// Returns whether a light (x, y, z, w) counts as infinitely far away: farther than a million units.
bool is_parallel_light(const glm::dvec4& light);

/// Returns S = (Π·L) I − L Πᵀ. After the division by w, S maps p to the point where the line through the light L and p
/// meets the plane. Uses the plane as given: pass a unit plane to get the displayed numbers. L.w is 1 for a point light
/// and 0 for a parallel light. S² = (Π·L) S and S L = 0; the rank of S is 3, or 1 if Π·L = 0. Source: lecture,
/// Projection Shadow Matrix.
glm::dmat4 shadow_matrix(const glm::dvec4& plane, const glm::dvec4& light);

/// Returns +1 or −1, the factor that makes w positive for every caster between the light and the plane, so that
/// clipping keeps the shadow. Returns +1 if Π·L = 0.
double shadow_sign(const glm::dvec4& plane, const glm::dvec4& light);

/// Returns the plane with the sign that puts `point`, which may be an eye or a light, on the positive side. Returns the
/// plane unchanged if it contains the point.
glm::dvec4 plane_facing(const glm::dvec4& plane, const glm::dvec4& point);

/// Returns the unit direction in which an eye sees a point; an eye with w = 0 has parallel view rays.
glm::dvec3 line_of_sight(const glm::dvec4& eye, const glm::dvec3& point);

/// Returns whether a light counts as being in a unit plane: Π·L is negligible relative to the light's own size.
bool lies_in_plane(const glm::dvec4& unit_plane, const glm::dvec4& light);

/// Returns R, where R p = p − 2 (n·p + d) n for a unit plane. R² = I, det R = −1. Source: lecture, Planar Reflection
/// Matrix.
glm::dmat4 mirror_matrix(const glm::dvec4& unit_plane);

/// The clip-space z of near and far: −1 and +1, 1 and 0, or +1 and −1.
enum class ClipRange { standard, reversed_zero_to_one, reversed };

/// Replaces the near plane of a projection with a plane given in view space, so that the plane's negative side is
/// clipped. The eye must be on the negative side (w < 0). A plane beyond the whole frustum clips everything. Source:
/// Lengyel 2005, Oblique View Frustum Depth Projection and Clipping; adapted to reversed depth.
glm::dmat4 with_oblique_near_plane(glm::dmat4 clip_from_view, const glm::dvec4& plane_view,
                                   ClipRange range = ClipRange::standard);

/// The square drawn for a plane: its center is the point nearest to the world's origin, and its half-axes along u and v
/// have length `extent`. P, −P and 2P have the same square.
struct PlanePatch {
    glm::dvec3 center;
    glm::dvec3 u;       ///< unit
    glm::dvec3 v;       ///< unit; u × v = −normal
    glm::dvec3 normal;  ///< unit; its largest component is positive
    double extent;
    bool operator==(const PlanePatch&) const = default;

    std::array<glm::dvec3, 4> corners() const;  ///< counterclockwise about u × v
    double reach() const;                       ///< how far holds() reaches along u and v: slightly beyond the extent
    bool holds(const glm::dvec3& point) const;  ///< whether a point of the plane is in the patch
    glm::dmat4 world_from_patch() const;        ///< maps the quad |x|, |z| ≤ 1, y = 0 to the patch, y to its normal
};

PlanePatch plane_patch(const glm::dvec4& plane, double extent);

}  // namespace viewing
