#include "topics/matrices/numbers/fault_words.h"

#include <array>

#include "text/catalogue.h"

namespace viewing {

FaultWords fault_words(const ExplainedMatrix& found) {
    const bool is_camera = found.letter == 'V' || found.letter == 'C';
    switch (found.fault) {
        case MatrixFault::none:
            return {"none", "", ""};
        case MatrixFault::inverse:
            return found.letter == 'V'
                       ? FaultWords{"inverse", marked("this is C, the camera's model matrix, where V belongs"),
                                    marked("V = C⁻¹: transpose the 3×3 part, and use −Rᵀ eye as the translation")}
                       : FaultWords{"inverse", marked("this is V where C belongs"), marked("C = V⁻¹")};
        case MatrixFault::transposed:
            return {"transposed", marked("rows and columns are swapped"),
                    marked("transpose it: GLM and OpenGL read columns first, NumPy, MATLAB and the slides write rows")};
        case MatrixFault::translation_in_row:
            return {"translation_in_row",
                    marked("the translation is in the last row, which makes w depend on the point"),
                    marked("put the translation into the last column; the last row is (0, 0, 0, 1)")};
        case MatrixFault::scaled:
            return {"scaled", marked("its axes do not have length 1"),
                    marked("leave the scale out of the camera, or normalize right, up and back")};
        case MatrixFault::left_handed: {
            constexpr std::array fixes = {
                marked("negate the first row of V (the first column of C): it is the direction to the right"),
                marked("negate the second row of V (the second column of C): it is the direction up"),
                marked("negate the third row of V (the third column of C): OpenGL looks along −z")};
            if (!is_camera && found.lens && found.lens->orthographic)
                return {"left_handed", marked("it is left-handed: it shows what is behind the eye"),
                        marked("make the third diagonal entry −2/(f − n), which is negative: OpenGL looks along −z")};
            return is_camera
                       ? FaultWords{"left_handed", marked("it is left-handed: det = −1, which mirrors the picture"),
                                    fixes[static_cast<std::size_t>(found.negated_axis)]}
                       : FaultWords{"left_handed",
                                    marked("it is left-handed: w = z, so it shows what is behind the eye"),
                                    marked("negate the third column: in OpenGL, w = −z")};
        }
        case MatrixFault::mirrored:
            if (!found.lens->mirrored_y)
                return {"mirrored", marked("its first row is negated: left and right of the picture are swapped"),
                        marked("negate the first row: its diagonal entry is positive")};
            if (!found.lens->mirrored_x)
                return {"mirrored", marked("its second row is negated: the picture is upside down"),
                        marked("negate the second row: in OpenGL, y points up")};
            return {"mirrored", marked("its first two rows are negated: the picture is turned by 180°"),
                    marked("negate the first two rows: their diagonal entries are positive")};
        case MatrixFault::lost_sign:
            if (found.letter == 'S')
                return {"lost_sign",
                        marked("the first three entries of its last row lost their sign, as if the light were at −ℓ"),
                        marked("let the last row begin with −a, −b, −c (times the light's w)")};
            return {"lost_sign",
                    marked("the −1 in its last row lost its sign: w = z, so it shows what is behind the eye"),
                    marked("make the last row (0, 0, −1, 0)")};
        case MatrixFault::negated:
            return {"negated", marked("all its signs are reversed: w is negative, so GL clips everything"),
                    marked("negate the whole matrix")};
        case MatrixFault::looks_back:
            return {"looks_back",
                    marked("right and back are negated: the camera looks the opposite way, as with lookAtLH"),
                    marked("negate the first and the third row (lookAtRH)")};
        case MatrixFault::depth_signs:
            return {"depth_signs",
                    marked("the two entries of its third row have different signs, so near or far is negative"),
                    marked("make −(f + n)/(f − n) and −2fn/(f − n) negative; if depth is reversed, both are positive")};
        case MatrixFault::negative_depth:
            return {
                "negative_depth", marked("with its third row, near or far is negative, that is, behind the eye"),
                marked(
                    "the fraction (f + n)/(f − n) may be upside down; only a perspective P ends with (0, 0, −1, 0)")};
        case MatrixFault::eye_not_negated:
            return {"eye_not_negated", marked("it translates by the eye's position instead of by −eye"),
                    marked("the last column of V is −Rᵀ eye")};
        case MatrixFault::wrong_order:
            return {"wrong_order", marked("it rotates first and then translates: its last column is −eye"),
                    marked("V = R⁻¹ T(−eye): translate first, so the last column is −Rᵀ eye")};
        case MatrixFault::degrees:
            return {"degrees", marked("fovy is in degrees instead of radians"), marked("use glm::radians(fovy)")};
        case MatrixFault::inverse_aspect:
            return {"inverse_aspect", marked("the aspect ratio is height ÷ width"), marked("use width ÷ height")};
        case MatrixFault::zero_to_one:
            return {"zero_to_one",
                    marked("it maps near … far to 0 … 1, but unless depth is reversed, the clip range is −1 … 1"),
                    found.lens && found.lens->orthographic
                        ? marked("use orthoRH_NO, or do not define GLM_FORCE_DEPTH_ZERO_TO_ONE")
                        : marked("use perspectiveRH_NO, or do not define GLM_FORCE_DEPTH_ZERO_TO_ONE")};
        case MatrixFault::minus_one_to_one:
            return {"minus_one_to_one", marked("it maps near … far to −1 … 1, but the state's clip range is 0 … 1"),
                    marked("use perspectiveRH_ZO with far and near swapped")};
        case MatrixFault::reversed:
            if (!found.has_other_range)
                return {"reversed", marked("near and far are swapped, unlike in the state"),
                        marked("swap near and far")};
            return {"reversed", marked("near and far are swapped, and the clip range differs from the state's"),
                    found.lens->zero_to_one ? marked("swap near and far, and map them to −1 … 1 (…RH_NO)")
                                            : marked("swap near and far, and map them to 0 … 1 (…RH_ZO)")};
        case MatrixFault::other_light:
            return {"other_light", marked("it is the shadow of another light on the state's plane"),
                    marked("use the state's light")};
        case MatrixFault::other_plane:
            return {"other_plane", marked("it belongs to another plane"),
                    marked("use the state's plane, divided by |n|")};
        case MatrixFault::not_unit_normal:
            return {"not_unit_normal", marked("its normal is not a unit vector"),
                    marked("divide (a, b, c, d) by |n| first")};
        case MatrixFault::lost_factor:
            return {"lost_factor", marked("the factor 2 is missing, so it projects onto the plane"),
                    marked("R = I − 2 n nᵀ, and its last column is −2 d n")};
        case MatrixFault::plus_2ab:
            return {"plus_2ab", marked("row 2, column 1 is +2ab, as in one line of the slide"),
                    marked("it should be −2ab")};
        case MatrixFault::different:
            return {"different", "", ""};
        case MatrixFault::product:
            return {"product", marked("it is the product P V, clip_from_world, of the state"),
                    marked("to check P and V, give each by itself")};
        case MatrixFault::mirrored_view:
            return {"mirrored_view", marked("it is the product V R of the state, with which the mirror image is drawn"),
                    marked("to check V and R, give each by itself")};
        case MatrixFault::unknown:
            break;
    }
    return {"unknown", marked("its structure matches none of the lecture's matrices"), ""};
}

const char* matrix_title(char letter) {
    switch (letter) {
        case 'V':
            return marked("V, view_from_world");
        case 'C':
            return marked("C, world_from_view: the camera's model matrix");
        case 'P':
            return marked("P, clip_from_view");
        case 'S':
            return marked("S, shadow_from_world");
        case 'R':
            return marked("R, mirror_from_world");
        default:
            return marked("none of V, C, P, S, R");
    }
}

}  // namespace viewing
