#include "topics/matrices/numbers/state_matrices.h"

#include "geometry/camera.h"
#include "geometry/plane.h"
#include "geometry/projection.h"
#include "topics/matrices/numbers/near_matrices.h"
#include "topics/planes/numbers/lecture_code.h"

namespace viewing {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

namespace {

/// Moves the translation from the last column to the last row.
dmat4 with_translation_in_row(const dmat4& m) {
    dmat4 moved = dmat4(dmat3(m));
    for (int axis = 0; axis < 3; ++axis) moved[axis][3] = m[3][axis];
    return moved;
}

}  // namespace

dmat4 flipped(const dvec4& signs) {
    dmat4 flip(1.0);
    for (int axis = 0; axis < 4; ++axis) flip[axis][axis] = signs[axis];
    return flip;
}

StateMatrices::StateMatrices(const Params& params, double aspect) : params_(params), aspect_(aspect) {
    params_.slips = {};
    params_.camera_overrides = {};
    const CameraParams& camera = params_.camera;
    camera_ = world_from_view(camera.position, camera.angles());
    known_ = {{'V', view_from_world(camera_)}, {'C', camera_}, {'P', projection(is_zero_to_one(), is_reversed())}};
    for (std::size_t plane = 0; plane < params_.planes.size(); ++plane) {
        const dvec4 unit = unit_plane(params_.planes[plane].equation);
        for (std::size_t light = 0; light < params_.lights.size(); ++light)
            known_.push_back({'S', shadow_matrix(unit, params_.lights[light].position), plane, light});
        known_.push_back({'R', mirror_matrix(unit), plane, 0});
    }
}

bool StateMatrices::uploads_negated(const Known& one) const {
    return one.letter == 'S' &&
           shadow_sign(unit_plane(params_.planes[one.plane].equation), params_.lights[one.light].position) < 0.0;
}

dmat4 StateMatrices::projection(bool zero_to_one, bool reversed, bool degrees, bool inverse_aspect) const {
    Params other = params_;
    other.slips.degrees_as_radians = degrees;
    const Lens lens = other.lens();
    const double aspect = inverse_aspect ? 1.0 / shown_aspect() : shown_aspect();
    dmat4 p = reversed ? clip_from_view_reversed(lens, aspect) : clip_from_view(lens, aspect);
    if (reversed == zero_to_one) return p;  // a reversed P is made for 0 … 1, any other for −1 … 1
    for (int column = 0; column < 4; ++column)
        p[column][2] = zero_to_one ? 0.5 * (p[column][2] + p[column][3]) : 2.0 * p[column][2] - p[column][3];
    return p;
}

std::vector<Spoiled> spoiled(const StateMatrices& state, const Known& one) {
    using enum MatrixFault;
    const dmat4& right = one.right;
    std::vector<Spoiled> all{{transposed, glm::transpose(right)}, {negated, -right}};
    switch (one.letter) {
        case 'V':
        case 'C':
            all.push_back({translation_in_row, with_translation_in_row(right)});
            all.push_back(
                {left_handed, one.letter == 'V' ? flipped({1, 1, -1, 1}) * right : right * flipped({1, 1, -1, 1})});
            if (one.letter == 'V') {
                all.push_back({looks_back, flipped({-1, 1, -1, 1}) * right});
                dmat4 moved = right;
                moved[3] = dvec4(-dvec3(right[3]), 1.0);
                all.push_back({eye_not_negated, moved});
                moved[3] = dvec4(-state.params().camera.position, 1.0);
                all.push_back({wrong_order, moved});
            }
            break;
        case 'P': {
            const bool zero_to_one = state.is_zero_to_one(), reversed_now = state.is_reversed();
            const auto add = [&](MatrixFault fault, const dmat4& matrix) { all.push_back({fault, matrix}); };
            add(zero_to_one ? minus_one_to_one : MatrixFault::zero_to_one,
                state.projection(!zero_to_one, reversed_now));
            add(reversed, state.projection(zero_to_one, !reversed_now));
            add(reversed, state.projection(!zero_to_one, !reversed_now));
            if (state.params().projection.type == ProjectionType::perspective)
                add(degrees, state.projection(zero_to_one, reversed_now, true));
            add(inverse_aspect, state.projection(zero_to_one, reversed_now, false, true));
            add(left_handed, right * flipped({1, 1, -1, 1}));
            if (right[2][3] != 0.0) add(lost_sign, flipped({1, 1, 1, -1}) * right);
            break;
        }
        case 'S': {
            dmat4 positive = right;
            for (int column = 0; column < 3; ++column) positive[column][3] = -positive[column][3];
            all.push_back({lost_sign, positive});
            break;
        }
        case 'R': {
            const dvec4& typed = state.params().planes[one.plane].equation;
            all.push_back({plus_2ab, mirror_matrix_as_typed(unit_plane(typed), true)});
            all.push_back({not_unit_normal, mirror_matrix_as_typed(typed, false)});
            break;
        }
        default:
            break;
    }
    return all;
}

}  // namespace viewing
