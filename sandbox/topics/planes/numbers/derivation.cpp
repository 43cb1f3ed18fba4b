// Each formula is written as on its slide, not as the rest of the sandbox computes it, so that agreement between the
// two means something.
#include "topics/planes/numbers/derivation.h"

#include <algorithm>
#include <cmath>

#include "frame/matrix_facts.h"
#include "text/catalogue.h"
#include "text/per_enum.h"

namespace viewing {
namespace {

constexpr double tiny = 1e-9;  ///< smaller values, relative to the measured size, count as zero

/// GLM lists columns; the slides and the calls below list rows.
glm::dmat4 from_rows(const glm::dvec4& row1, const glm::dvec4& row2, const glm::dvec4& row3, const glm::dvec4& row4) {
    return glm::transpose(glm::dmat4(row1, row2, row3, row4));
}

/// Planar Shadow: the plane y = 0, a point light at l.
glm::dmat4 blinn_form(const glm::dvec3& l) {
    return from_rows({l.y, -l.x, 0.0, 0.0},  //
                     {0.0, 0.0, 0.0, 0.0},   //
                     {0.0, -l.z, l.y, 0.0},  //
                     {0.0, -1.0, 0.0, l.y});
}

/// Projection Shadow: an arbitrary plane, a point light at l.
glm::dmat4 form_with_d(const glm::dvec3& n, double d, const glm::dvec3& l) {
    const double n_dot_l = n.x * l.x + n.y * l.y + n.z * l.z;
    return from_rows({n_dot_l + d - l.x * n.x, -l.x * n.y, -l.x * n.z, -l.x * d},  //
                     {-l.y * n.x, n_dot_l + d - l.y * n.y, -l.y * n.z, -l.y * d},  //
                     {-l.z * n.x, -l.z * n.y, n_dot_l + d - l.z * n.z, -l.z * d},  //
                     {-n.x, -n.y, -n.z, n_dot_l});
}

/// Classifies a ray; the derivation's light, plane, point and point_height must be set already. `approach` is the rate
/// at which the signed distance from the plane grows along the line from p toward the light: n·(l − p), or n·l for a
/// parallel light. It is zero if the line is parallel to the plane.
ShadowRay ray_of(const ShadowDerivation& derivation, const glm::dvec3& towards_light, double plane_dot_light,
                 double approach) {
    if (lies_in_plane(derivation.unit_plane, derivation.light)) return ShadowRay::light_in_plane;
    const double length = glm::length(towards_light);
    if (length <= tiny * std::max(glm::length(derivation.light), 1e-3)) return ShadowRay::at_light;
    if (std::abs(approach) <= tiny * length) return ShadowRay::parallel;
    if (approach * plane_dot_light < 0.0) return ShadowRay::beyond_light;
    const double side = derivation.point_height * plane_dot_light;
    if (std::abs(derivation.point_height) <= tiny * std::max(1.0, glm::length(derivation.point_world)))
        return ShadowRay::point_in_plane;
    return side < 0.0 ? ShadowRay::point_behind : ShadowRay::regular;
}

MirrorPlane mirror_plane_of(const glm::dvec4& unit_plane) {
    const glm::dvec4 magnitudes = glm::abs(unit_plane);  // Π and −Π are the same mirror
    if (magnitudes == glm::dvec4(1.0, 0.0, 0.0, 0.0)) return MirrorPlane::yz;
    if (magnitudes == glm::dvec4(0.0, 1.0, 0.0, 0.0)) return MirrorPlane::xz;
    if (magnitudes == glm::dvec4(0.0, 0.0, 1.0, 0.0)) return MirrorPlane::xy;
    return MirrorPlane::general;
}

/// Returns R as on the slides: for the coordinate planes, a diagonal matrix with one negative entry; otherwise in terms
/// of a, b, c and d.
glm::dmat4 mirror_form(MirrorPlane plane, const glm::dvec4& unit_plane) {
    const double a = unit_plane.x, b = unit_plane.y, c = unit_plane.z, d = unit_plane.w;
    const auto diagonal = [](double x, double y, double z) {
        return from_rows({x, 0.0, 0.0, 0.0}, {0.0, y, 0.0, 0.0}, {0.0, 0.0, z, 0.0}, {0.0, 0.0, 0.0, 1.0});
    };
    switch (plane) {
        case MirrorPlane::yz:
            return diagonal(-1.0, 1.0, 1.0);
        case MirrorPlane::xz:
            return diagonal(1.0, -1.0, 1.0);
        case MirrorPlane::xy:
            return diagonal(1.0, 1.0, -1.0);
        case MirrorPlane::general:
            break;
    }
    return from_rows({1.0 - 2.0 * a * a, -2.0 * a * b, -2.0 * a * c, -2.0 * a * d},  //
                     {-2.0 * a * b, 1.0 - 2.0 * b * b, -2.0 * b * c, -2.0 * b * d},  //
                     {-2.0 * a * c, -2.0 * b * c, 1.0 - 2.0 * c * c, -2.0 * c * d},  //
                     {0.0, 0.0, 0.0, 1.0});
}

}  // namespace

glm::dvec3 derivation_point(const Derived& derived) {
    if (derived.followed) return derived.followed->point_world;
    const double plane_dot_light_sign = derived.chosen_shadow().plane_dot_light < 0.0 ? -1.0 : 1.0;
    const DerivedPlane& plane = derived.chosen_plane();
    return plane.patch.center + plane_dot_light_sign * glm::dvec3(plane.unit_plane);
}

const char* sentence_of(ShadowRay ray) {
    static constexpr auto sentences = per_enum<ShadowRay>(
        "", marked("p lies in the plane: it is its own shadow."),
        marked("p lies behind the plane: the ray meets the plane first, so s is a false shadow."),
        marked("p is farther from the plane than the light is: the line meets the plane behind the light, where w has "
               "the opposite sign, so s is an anti-shadow."),
        marked("The ray is parallel to the plane: w = 0, and s lies at infinity."),
        marked("The light lies in the plane: S sends every point to the light itself, or to infinity if the light is "
               "parallel. There is no shadow."),
        marked("p coincides with the light: there is no ray."));
    return sentences[ray];
}

ShadowDerivation derive_shadow(const glm::dvec4& unit_plane, const glm::dvec4& light, const glm::dvec3& point_world) {
    const glm::dvec3 n(unit_plane), p = point_world;
    const double d = unit_plane.w;
    ShadowDerivation found;
    found.unit_plane = unit_plane;
    found.light = light;
    found.parallel_light = is_parallel_light(light);
    found.point_world = p;
    const glm::dvec3 l = found.light_world = glm::dvec3(light) / (found.parallel_light ? 1.0 : light.w);

    found.n_dot_l = glm::dot(n, l);
    found.n_dot_p = glm::dot(n, p);
    found.light_height = found.parallel_light ? found.n_dot_l : found.n_dot_l + d;
    found.point_height = found.n_dot_p + d;
    found.light_foot_world = l - found.light_height * n;
    found.point_foot_world = p - found.point_height * n;

    const double plane_dot_light = glm::dot(unit_plane, light);
    found.w = plane_dot_light - found.point_height * light.w;
    const glm::dvec3 towards_light = found.parallel_light ? l : l - p;
    found.ray = ray_of(found, towards_light, plane_dot_light, glm::dot(n, towards_light));
    if (!found.parallel_light) found.light_to_point = glm::length(towards_light);
    if (found.ray == ShadowRay::parallel || found.ray == ShadowRay::light_in_plane || found.ray == ShadowRay::at_light)
        return found;

    if (found.parallel_light) {
        found.t = -found.point_height / found.n_dot_l;
        found.shadow_world = p + found.t * l;
    } else {
        found.t = found.light_height / (found.n_dot_l - found.n_dot_p);
        found.shadow_world = l + found.t * (p - l);
        found.light_to_shadow = glm::length(*found.shadow_world - l);
    }
    found.point_to_shadow = glm::length(*found.shadow_world - p);
    return found;
}

ShadowForms shadow_forms(const glm::dvec4& unit_plane, const glm::dvec4& light) {
    ShadowForms forms;
    forms.four_vectors = shadow_matrix(unit_plane, light);
    if (light.w != 1.0) return forms;
    const glm::dvec3 l(light);
    forms.with_d = form_with_d(glm::dvec3(unit_plane), unit_plane.w, l);
    forms.largest_difference = largest_entry(*forms.with_d - forms.four_vectors);
    if (unit_plane != glm::dvec4(0.0, 1.0, 0.0, 0.0)) return forms;
    forms.blinn = blinn_form(l);
    forms.largest_difference = std::max({forms.largest_difference, largest_entry(*forms.blinn - *forms.with_d),
                                         largest_entry(*forms.blinn - forms.four_vectors)});
    return forms;
}

MirrorDerivation derive_mirror(const glm::dvec4& unit_plane, const glm::dvec3& point_world) {
    const glm::dvec3 n(unit_plane), q = point_world;
    MirrorDerivation found;
    found.unit_plane = unit_plane;
    found.point_world = q;
    found.k = glm::dot(n, q) + unit_plane.w;
    found.foot_world = q - found.k * n;
    found.mirrored_world = q - 2.0 * found.k * n;
    found.plane = mirror_plane_of(unit_plane);
    found.mirrored_world_from_world = mirror_form(found.plane, unit_plane);

    const glm::dvec4 homogeneous(q, 1.0);
    for (int row = 0; row < 3; ++row) {
        double sum = 0.0;
        for (int column = 0; column < 4; ++column) {
            const double identity = row == column ? 1.0 : 0.0;
            const double factor = identity - 2.0 * unit_plane[row] * unit_plane[column];
            sum += found.terms[row][column] = factor * homogeneous[column];
        }
        found.expansion_difference = std::max(found.expansion_difference, std::abs(sum - found.mirrored_world[row]));
    }
    return found;
}

}  // namespace viewing
