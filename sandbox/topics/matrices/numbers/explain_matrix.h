// Identifies a matrix, and finds how it differs from the state's V, C, P, S or R. Compares it with these and with their
// versions after common mistakes, then examines its own structure. Pure; cli/results/explained_text.h puts the result
// into words.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "geometry/look_at.h"
#include "state/params.h"

namespace viewing {

/// The fault of a matrix. `other_…` and `different`: correct, but for another light, plane, camera or lens.
enum class MatrixFault {
    none,
    inverse,             ///< C where V belongs, or V where C belongs
    transposed,          ///< rows and columns swapped
    translation_in_row,  ///< V, C: the translation is in the last row instead of the last column
    scaled,              ///< V, C: the axes do not have length 1
    left_handed,         ///< V, C: det −1; P: third column negated, so perspective clip w is z instead of −z
    mirrored,            ///< P: one of the first two diagonal entries is negative, or both are
    lost_sign,           ///< P: the last row is (0, 0, 1, 0), so clip w is z; S: its last row begins with +n, not −n
    depth_signs,         ///< P: one entry of the third row has the wrong sign, so near or far is negative
    negative_depth,      ///< P: near or far is negative although the signs of the third row are right
    negated,             ///< all signs are wrong: w is negative
    looks_back,          ///< V: x and z negated, as with lookAtLH
    eye_not_negated,     ///< V: translated by the eye instead of by −eye
    wrong_order,         ///< V: rotated first, so that the last column is −eye
    degrees,             ///< P: fovy in degrees instead of radians
    inverse_aspect,      ///< P: height ÷ width instead of width ÷ height
    zero_to_one,         ///< P: for a clip range 0 … 1, but not reversed
    minus_one_to_one,    ///< P: for a clip range −1 … 1, but reversed
    reversed,            ///< P: near and far swapped, unlike in the state
    other_light,         ///< S of the state's plane and another light
    other_plane,         ///< S, R of another plane
    not_unit_normal,     ///< R: filled from a normal that is not a unit vector
    lost_factor,         ///< R: I − n nᵀ without the factor 2, which projects onto the plane
    plus_2ab,            ///< R: the slide's +2ab in row 2, column 1
    different,           ///< a correct V, C or P of another camera, or S of another plane and light
    product,             ///< the state's P V, which is none of the five
    mirrored_view,       ///< the state's V R
    unknown,             ///< none of the lecture's matrices
};

/// The parameters of a projection, read from its entries; lengths in world units, angles in degrees.
struct FoundLens {
    bool orthographic = false;
    double fovy_deg = 0.0, height = 0.0;  ///< one of them: fovy if perspective, height if orthographic
    double aspect = 1.0;
    double near = 0.0, far = 0.0;                 ///< far is +∞ if infinite; near > far if reversed
    bool zero_to_one = false;                     ///< read for a clip range 0 … 1 instead of −1 … 1
    bool off_center = false;                      ///< the frustum is not symmetric
    bool mirrored_x = false, mirrored_y = false;  ///< P's first or second row was negated to read the other values
    Edges edges;                                  ///< of the picture; perspective: at the near plane
};

/// An identified matrix. Optional parts are set if the matrix, once its fault is fixed, has them.
struct ExplainedMatrix {
    char letter = 0;  ///< V, C, P, S, R; 0: unknown
    MatrixFault fault = MatrixFault::unknown;
    std::size_t plane = 0, light = 0;  ///< indices, from 0, of the state's S or R in `right`
    std::optional<glm::dmat4> right;   ///< the state's matrix of that letter, without mistakes
    double off = 0.0;                  ///< largest absolute entry of the difference from `right`; S: up to a factor
    std::optional<LookAt> camera;      ///< V, C
    Angles angles;                     ///< of `camera`
    std::optional<FoundLens> lens;     ///< P
    std::optional<glm::dvec4> found_plane, found_light;  ///< S, R: unit plane; light with w = 1 or 0
    glm::dvec3 scale{1.0};                               ///< V, C: lengths of the axes
    int negated_axis = 2;          ///< left-handed V, C: the axis to negate; 2 (back), unless the state's V tells it
    bool has_other_range = false;  ///< a reversed P is also made for another clip range than the state's
};

/// Reads a P whose clip w is −z (perspective) or 1 (orthographic); none if `m` has other entries. `zero_to_one`: P is
/// for a clip range 0 … 1, not −1 … 1; `tolerance`: rounding of each entry.
std::optional<FoundLens> read_lens(const glm::dmat4& m, bool zero_to_one, double tolerance);

/// Returns whether a P, whose clip w is −z or 1, is made for a clip range 0 … 1. If P reverses depth, returns true for
/// a perspective P whose third diagonal entry is below 1; for any other, the state's range decides. If P does not
/// reverse depth, its third row fits both ranges, each with a different near: returns true if only the near for 0 … 1
/// is plausible, which means that it is the state's own or has at most two digits.
bool is_for_zero_to_one(const glm::dmat4& p, const Params& params, double tolerance);

/// Explains `pasted`, indexed as GLM does ([column][row]). `named`: the letter of the expected matrix, 0 if any.
/// `aspect`: width ÷ height of the picture. `tolerance`: rounding of each entry; 2e-6 of the entry is added for
/// float32.
ExplainedMatrix explain_matrix(const glm::dmat4& pasted, char named, const Params& params, double aspect,
                               double tolerance = 1e-9);

}  // namespace viewing
