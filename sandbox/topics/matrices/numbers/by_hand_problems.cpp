// Identifies an S or R entered by hand. Checks such as rank, det and S² = (Π·L) S also pass for another light's or
// plane's matrix, so the matrix is identified by explain_matrix.h.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "frame/matrix_facts.h"
#include "frame/problems.h"
#include "frame/say.h"
#include "text/numbers.h"
#include "topics/matrices/numbers/take_matrix.h"

namespace viewing {
namespace {

/// A relative tolerance, since entries may be typed with only five digits.
constexpr double by_hand_tolerance = 1e-4;

double largest_component(const glm::dvec4& v) {
    const glm::dvec4 size = glm::abs(v);
    return std::max({size.x, size.y, size.z, size.w});
}

/// Returns whether a matrix sends a point to `image`, up to the tolerance times the patch's size.
bool sends(const glm::dmat4& matrix, const glm::dvec3& point, const glm::dvec3& image, const PlanePatch& patch) {
    const glm::dvec4 found = matrix * glm::dvec4(point, 1.0);
    return glm::length(glm::dvec3(found) / found.w - image) <= by_hand_tolerance * patch.extent;
}

/// Returns whether S or R keeps three points of the plane in place, and therefore all of its points.
bool keeps_plane(const glm::dmat4& matrix, const PlanePatch& patch) {
    const glm::dvec3 points[] = {patch.center, patch.center + patch.extent * patch.u,
                                 patch.center + patch.extent * patch.v};
    return std::all_of(std::begin(points), std::end(points),
                       [&](const glm::dvec3& point) { return sends(matrix, point, point, patch); });
}

/// Returns "S" for the first plane and light, otherwise "S of plane 2, light 1".
Message shadow_name(std::size_t plane, std::size_t light) {
    return plane == 0 && light == 0
               ? Message("S")
               : message("S of plane {plane}, light {light}", "plane"_a = plane + 1, "light"_a = light + 1);
}

/// Returns "R" for the first plane, otherwise "R of plane 2".
Message mirror_name(std::size_t plane) {
    return plane == 0 ? Message("R") : message("R of plane {plane}", "plane"_a = plane + 1);
}

/// Returns a light as "(1, 4, 2)" or, if it is parallel, as "(1, 4, 2, 0)".
std::string light_text(const glm::dvec4& light) {
    return figures_of({&light.x, light.w == 0.0 ? 4U : 3U}, 3);
}

/// Returns a unit plane as "y = 0.5" or "0.6 x + 0.8 y − 2 = 0".
std::string plane_text(const glm::dvec4& plane) {
    constexpr double none = 5e-4;
    static constexpr const char* axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(plane[axis]) > 1.0 - none * none)
            return std::string(axes[axis]) + " = " + figures(0.0 - plane.w / plane[axis], 3);
    std::string text;
    for (int part = 0; part < 4; ++part) {
        if (std::abs(plane[part]) < none) continue;
        const char* const sign = plane[part] < 0.0 ? (text.empty() ? "−" : " − ") : text.empty() ? "" : " + ";
        text += sign + figures(std::abs(plane[part]), 3) + (part < 3 ? " " + std::string(axes[part]) : "");
    }
    return text + " = 0";
}

/// Explains a matrix as if its plane and light were the state's only ones.
ExplainedMatrix explained(const glm::dmat4& matrix, char letter, const Params& params, const Derived& derived,
                          std::size_t plane, std::size_t light) {
    constexpr double shown = 5.1e-4;  // entries may be typed with the digits that the window shows
    Params own;
    own.camera = params.camera;
    own.projection = params.projection;
    own.planes.front() = params.planes[plane];
    own.lights.front() = params.lights[light];
    return explain_matrix(matrix, letter, own, derived.aspect, shown);
}

/// Returns whether the matrix is the transpose of the right one; for S, up to a factor.
bool is_right_transposed(const ExplainedMatrix& found, const glm::dmat4& matrix) {
    if (found.fault != MatrixFault::transposed || !found.right) return false;
    const glm::dmat4& right = *found.right;
    const double off = found.letter == 'S' ? largest_difference_up_to_scale(glm::transpose(matrix), right)
                                           : largest_entry(glm::transpose(matrix) - right);
    return off <= 1e-3 * largest_entry(right);
}

/// Identifies a wrong S or R entered by hand; returns nothing if the matrix is right or not recognized. `matrix`: the
/// name of the entered matrix, such as "S of plane 2, light 1"; `letter`: the letter of the right matrix, S or R.
std::optional<Sentence> recognized(const ExplainedMatrix& found, const glm::dmat4& entries, char letter,
                                   const Message& matrix) {
    if (found.letter != 'S' && found.letter != 'R') return std::nullopt;
    const std::string plane = found.found_plane ? plane_text(*found.found_plane) : "";
    const std::string light = found.found_light ? light_text(*found.found_light) : "";
    const bool is_shadow = found.letter == 'S', is_transposed = found.fault == MatrixFault::transposed;
    if (found.letter != letter) {
        if (is_transposed || found.fault == MatrixFault::not_unit_normal || found.fault == MatrixFault::plus_2ab)
            return std::nullopt;
        return is_shadow
                   ? sentence("by_hand.shadow_for_mirror",
                              "{matrix} entered by hand is the shadow matrix for the light {light} and the plane "
                              "{plane}, not a reflection matrix",
                              "matrix"_a = matrix, "light"_a = light, "plane"_a = plane)
                   : sentence("by_hand.mirror_for_shadow",
                              "{matrix} entered by hand is the reflection matrix for the plane {plane}, not a shadow "
                              "matrix",
                              "matrix"_a = matrix, "plane"_a = plane);
    }
    if (is_right_transposed(found, entries))
        return is_shadow
                   ? sentence("by_hand.shadow_transposed",
                              "{matrix} entered by hand is the transpose of the correct S: OpenGL reads columns",
                              "matrix"_a = matrix)
                   : sentence("by_hand.mirror_transposed",
                              "{matrix} entered by hand is Rᵀ, the transpose of the correct R: OpenGL reads columns",
                              "matrix"_a = matrix);
    switch (found.fault) {
        case MatrixFault::transposed:
            if (is_shadow) return std::nullopt;  // Sᵀ is a shadow matrix too, of another plane and light
            return sentence("by_hand.other_mirror_transposed",
                            "{matrix} entered by hand is the transpose of the reflection matrix for the plane {plane}",
                            "matrix"_a = matrix, "plane"_a = plane);
        case MatrixFault::other_light:
            return sentence("by_hand.other_light",
                            "{matrix} entered by hand is the shadow matrix for the light {light}, not for this one",
                            "matrix"_a = matrix, "light"_a = light);
        case MatrixFault::other_plane:
            return is_shadow ? sentence("by_hand.shadow_of_other_plane",
                                        "{matrix} entered by hand is the shadow matrix for the plane {plane}, not for "
                                        "this one",
                                        "matrix"_a = matrix, "plane"_a = plane)
                             : sentence("by_hand.mirror_of_other_plane",
                                        "{matrix} entered by hand is the reflection matrix for the plane {plane}, not "
                                        "for this one",
                                        "matrix"_a = matrix, "plane"_a = plane);
        case MatrixFault::different:
            return sentence("by_hand.other_shadow",
                            "{matrix} entered by hand is the shadow matrix for the light {light} and the plane {plane}",
                            "matrix"_a = matrix, "light"_a = light, "plane"_a = plane);
        case MatrixFault::not_unit_normal:
            return sentence(
                "by_hand.normal_not_unit",
                "{matrix} entered by hand is filled from a normal that is not a unit vector: divide (a, b, c, d) "
                "by |n| first",
                "matrix"_a = matrix);
        case MatrixFault::negated:
            if (is_shadow) return std::nullopt;  // by_hand.negative_w
            return sentence("by_hand.negated_mirror",
                            "{matrix} entered by hand is −R: it sends points to the right places, but with a negative "
                            "w, so GL clips the whole mirror image",
                            "matrix"_a = matrix);
        case MatrixFault::plus_2ab:
            return sentence(
                "by_hand.plus_2ab",
                "{matrix} entered by hand has +2ab in row 2, column 1, as in one line of the slide: it should be −2ab",
                "matrix"_a = matrix);
        default:
            return std::nullopt;
    }
}

/// Reports the first property of S that a matrix lacks: S sends points to the plane, sends the light to 0, and keeps
/// the plane's points in place.
void tell_wrong_shadow(Sayer& tell, const glm::dmat4& s, const DerivedPlane& of, const CastShadow& cast,
                       const Message& matrix) {
    const double size = by_hand_tolerance * largest_entry(s);
    // Here, Πᵀ S is a row vector times a matrix; if it is 0, every image lies in the plane.
    const bool lands = largest_component(of.unit_plane * s) <= size;
    const bool loses_light = largest_component(s * cast.light_world) <= size * glm::length(cast.light_world);
    tell.broken(!lands, sentence("by_hand.not_in_plane",
                                 "{matrix} entered by hand does not send points into the plane: Π·S p ≠ 0",
                                 "matrix"_a = matrix));
    tell.broken(
        lands && !loses_light,
        sentence("by_hand.light_not_to_0",
                 "{matrix} entered by hand does not send the light to 0: S L ≠ 0, so its shadow does not lie on the "
                 "rays from the light",
                 "matrix"_a = matrix));
    tell.broken(
        lands && loses_light && !cast.light_in_plane && !keeps_plane(s, of.patch),
        sentence("by_hand.shadow_moves_plane",
                 "{matrix} entered by hand moves the points of the plane itself, so the shadow does not touch its "
                 "caster",
                 "matrix"_a = matrix));
}

/// Reports the first property of R that a matrix lacks: R keeps the plane's points in place, and sends a point off the
/// plane to its mirror image.
void tell_wrong_mirror(Sayer& tell, const DerivedPlane& of, const Message& matrix) {
    const PlanePatch& patch = of.patch;
    const glm::dvec3 normal(of.unit_plane), q = patch.center + normal;
    const bool keeps = keeps_plane(of.mirrored_world_from_world, patch);
    tell.broken(!keeps, sentence("by_hand.mirror_moves_plane",
                                 "{matrix} entered by hand moves the points of the plane itself, so the image does not "
                                 "fit its mirror",
                                 "matrix"_a = matrix));
    tell.broken(keeps && !sends(of.mirrored_world_from_world, q, patch.center - normal, patch),
                sentence("by_hand.no_mirror_image",
                         "{matrix} entered by hand leaves the plane in place, but sends no other point to its mirror "
                         "image: R q ≠ q − 2 (n·q + d) n",
                         "matrix"_a = matrix));
}

/// Reports one S entered by hand. If its shadow should be drawn, identifies the matrix or, if it is not recognized,
/// reports the property that it lacks; also reports whether clipping removes the shadow.
void tell_shadow_by_hand(Sayer& tell, const Params& params, const Derived& derived, std::size_t plane,
                         std::size_t light) {
    const DerivedPlane& of = derived.planes[plane];
    const CastShadow& cast = of.shadows[light];
    const glm::dmat4& s = cast.shadowed_world_from_world;
    const Message matrix = shadow_name(plane, light);
    tell(true, sentence("by_hand.shadow", "{matrix} is entered by hand: the plane and the light no longer change it",
                        "matrix"_a = matrix));
    if (!params.shadow.enabled || !of.receives_shadow || !cast.reaches(of.eye_side)) return;
    const std::optional<Sentence> what = recognized(explained(s, 'S', params, derived, plane, light), s, 'S', matrix);
    const bool is_first = plane == 0 && light == 0;  // others have no path
    if (what)
        tell.broken(true, *what, is_first ? "overrides.shadow_from_world" : "");
    else
        tell_wrong_shadow(tell, s, of, cast, matrix);
    const bool is_clipped = !cast.light_in_plane && w_between(of, cast) < 0.0;
    tell.broken(is_clipped && cast.sign < 0.0,
                sentence("by_hand.sign",
                         "{matrix} entered by hand gives points between the light and the plane a positive w, but "
                         "sign(n·ℓ + d) = −1 makes it negative: clipping removes the shadow",
                         "matrix"_a = matrix),
                "shadow.sign=none");
    tell.broken(is_clipped && cast.sign > 0.0,
                sentence("by_hand.negative_w",
                         "{matrix} entered by hand gives a negative w to points between the light and the "
                         "plane: clipping removes the shadow; −S is the same projection with a positive w",
                         "matrix"_a = matrix),
                is_first ? setting_of("overrides.shadow_from_world", -s) : "");
}

}  // namespace

void find_by_hand_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    Sayer tell_shadow(problems, "shadow"), tell_mirror(problems, "reflection");
    for (std::size_t plane = 0; plane < derived.planes.size(); ++plane)
        for (std::size_t light = 0; light < derived.planes[plane].shadows.size(); ++light)
            if (derived.planes[plane].shadows[light].by_hand)
                tell_shadow_by_hand(tell_shadow, params, derived, plane, light);
    for (std::size_t plane = 0; plane < derived.planes.size(); ++plane) {
        const DerivedPlane& of = derived.planes[plane];
        if (!of.mirror_by_hand) continue;
        const Message matrix = mirror_name(plane);
        tell_mirror(true, sentence("by_hand.mirror", "{matrix} is entered by hand: the plane no longer changes it",
                                   "matrix"_a = matrix));
        if (!params.reflection.enabled || !of.mirrors || of.eye_side == 0.0) continue;
        const glm::dmat4& r = of.mirrored_world_from_world;
        const std::optional<Sentence> what = recognized(explained(r, 'R', params, derived, plane, 0), r, 'R', matrix);
        if (what)
            tell_mirror.broken(true, *what, plane == 0 ? "overrides.mirror_from_world" : "");
        else
            tell_wrong_mirror(tell_mirror, of, matrix);
    }
}

}  // namespace viewing
