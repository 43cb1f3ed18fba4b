#include "topics/matrices/numbers/fault_words.h"

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
        case MatrixFault::left_handed:
            return is_camera
                       ? FaultWords{"left_handed", marked("it is left-handed: det = −1, which mirrors the picture"),
                                    marked("negate the third row of V (the third column of C): OpenGL looks along −z")}
                       : FaultWords{"left_handed",
                                    marked("it is left-handed: w = z, so it shows what is behind the eye"),
                                    marked("negate the third column: in OpenGL, w = −z")};
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
                    marked("use perspectiveRH_NO, or do not define GLM_FORCE_DEPTH_ZERO_TO_ONE")};
        case MatrixFault::minus_one_to_one:
            return {"minus_one_to_one", marked("it maps near … far to −1 … 1, but the state's clip range is 0 … 1"),
                    marked("use perspectiveRH_ZO with far and near swapped")};
        case MatrixFault::reversed:
            return {"reversed", marked("near and far are swapped, unlike in the state"), marked("swap near and far")};
        case MatrixFault::other_light:
            return {"other_light", marked("it is the shadow of another light on the state's plane"),
                    marked("use the state's light")};
        case MatrixFault::other_plane:
            return {"other_plane", marked("it belongs to another plane"),
                    marked("use the state's plane, divided by |n|")};
        case MatrixFault::not_unit_normal:
            return {"not_unit_normal", marked("its normal is not a unit vector"),
                    marked("divide (a, b, c, d) by |n| first")};
        case MatrixFault::plus_2ab:
            return {"plus_2ab", marked("row 2, column 1 is +2ab, as in one line of the slide"),
                    marked("it should be −2ab")};
        case MatrixFault::different:
            return {"different", "", ""};
        case MatrixFault::product:
            return {"product", marked("it is the product P V, clip_from_world, of the state"),
                    marked("to check P and V, give each by itself")};
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
