// The lecture's two derivations with numbers: the shadow s of a point p, and the mirror image q′ of a point q.
// Pure. Read derivation.cpp next; topics/planes/shown/derivation_views.cpp shows the derivations.
#pragma once

#include <optional>

#include "frame/derive.h"

namespace viewing {

/// Returns the point p = q of the derivations: the followed point or, without one, a point one unit from the center of
/// the chosen plane's patch, on the chosen light's side.
glm::dvec3 derivation_point(const Derived& derived);

/// The path of the ray from the light through p.
enum class ShadowRay {
    regular,         ///< it passes through p and then meets the plane
    point_in_plane,  ///< p is its own shadow
    point_behind,    ///< it meets the plane before it reaches p
    beyond_light,    ///< p is farther from the plane than the light is: the line meets the plane behind the light
    parallel,        ///< the ray is parallel to the plane and never meets it
    light_in_plane,  ///< S sends every point to the light itself
    at_light         ///< p is at the light: there is no ray
};

/// Returns "" for a regular ray, otherwise a sentence about the special case: in English; use tr() to show it.
const char* sentence_of(ShadowRay ray);

/// All values of the derivation of s. `n` and `d` belong to the unit plane; heights are signed distances from it.
/// Source: lecture, Projection Shadow; Blinn 1988.
struct ShadowDerivation {
    glm::dvec4 unit_plane{0.0, 1.0, 0.0, 0.0};
    glm::dvec4 light{0.0, 1.0, 0.0, 1.0};  ///< homogeneous, as given
    bool parallel_light = false;
    glm::dvec3 light_world{0.0};  ///< l = (x, y, z) ÷ l_w; for a parallel light, the direction (x, y, z) toward it
    glm::dvec3 point_world{0.0};  ///< p

    ShadowRay ray = ShadowRay::regular;
    double n_dot_l = 0.0, n_dot_p = 0.0;
    double light_height = 0.0;  ///< n·l + d; for a parallel light, n·l
    double point_height = 0.0;  ///< n·p + d
    double w = 0.0;             ///< w of S p = (Π·L) p − (Π·p) L

    /// Point light: s = l + t (p − l), t = (n·l + d)/(n·l − n·p).
    /// Parallel light: s = p + t l, t = −(n·p + d)/(n·l). t is 0 if there is no s.
    double t = 0.0;
    std::optional<glm::dvec3> shadow_world;  ///< s; none for ShadowRay::parallel, light_in_plane and at_light
    glm::dvec3 light_foot_world{0.0};        ///< foot of l on the plane; meaningless for a parallel light
    glm::dvec3 point_foot_world{0.0};        ///< foot of p

    double light_to_point = 0.0, light_to_shadow = 0.0;  ///< |p − l| and |s − l|; 0 for a parallel light
    double point_to_shadow = 0.0;                        ///< |s − p|
};
ShadowDerivation derive_shadow(const glm::dvec4& unit_plane, const glm::dvec4& light, const glm::dvec3& point_world);

/// S in three forms, each as written on its slide. The first two are present only if l_w = 1; the first, Blinn's, also
/// requires the plane y = 0 with its normal up.
struct ShadowForms {
    std::optional<glm::dmat4> blinn;   ///< Planar Shadow: l_y, l_x and l_z alone
    std::optional<glm::dmat4> with_d;  ///< Projection Shadow: n·l + d − …
    glm::dmat4 four_vectors{1.0};      ///< Projection Shadow Matrix: (Π·L) I − L Πᵀ
    double largest_difference = 0.0;   ///< between any two of those present, over all entries
};
ShadowForms shadow_forms(const glm::dvec4& unit_plane, const glm::dvec4& light);

/// The kinds of plane for which the lecture gives R: the coordinate planes, and any other plane.
enum class MirrorPlane { yz, xz, xy, general };

/// All values of the derivation of q′ = q − 2 k n. Source: lecture, Planar Reflection.
struct MirrorDerivation {
    glm::dvec4 unit_plane{0.0, 1.0, 0.0, 0.0};  ///< a, b, c, d
    glm::dvec3 point_world{0.0};                ///< q
    double k = 0.0;                             ///< n·q + d
    glm::dvec3 foot_world{0.0};                 ///< q − k n
    glm::dvec3 mirrored_world{0.0};             ///< q′

    /// Row by row, the four terms of the lecture's expansion: (1 − 2a²) x₀, −2ab y₀, −2ac z₀, −2ad for x₀′, …
    double terms[3][4] = {};
    double expansion_difference = 0.0;  ///< largest difference between a row's sum and q′

    MirrorPlane plane = MirrorPlane::general;
    glm::dmat4 mirrored_world_from_world{1.0};  ///< R as on the slide for that kind of plane
};
MirrorDerivation derive_mirror(const glm::dvec4& unit_plane, const glm::dvec3& point_world);

}  // namespace viewing
