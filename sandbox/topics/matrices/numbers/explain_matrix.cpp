#include "topics/matrices/numbers/explain_matrix.h"

#include <algorithm>

#include "frame/matrix_facts.h"
#include "geometry/plane.h"
#include "topics/matrices/numbers/matrix_structure.h"
#include "topics/matrices/numbers/near_matrices.h"

namespace viewing {
namespace {

using glm::dmat4;

/// For a matrix recognized by comparison, fills in what follows from the right matrix.
void describe_right(ExplainedMatrix& found, const StateMatrices& state) {
    if (found.letter == 'V' || found.letter == 'C') describe_camera(found, state.first('C').right);
    if (found.letter == 'P' && !found.lens) found.lens = read_lens(*found.right, state.is_zero_to_one(), 1e-12);
    if (found.letter == 'S' || found.letter == 'R')
        found.found_plane = unit_plane(state.params().planes[found.plane].equation);
    if (found.letter == 'S') found.found_light = state.params().lights[found.light].position;
}

/// Reads a P whose near and far are swapped; its clip range may also differ from the state's.
void describe_reversed(ExplainedMatrix& found, const dmat4& pasted, const StateMatrices& state, double tolerance) {
    const bool zero_to_one = is_for_zero_to_one(pasted, state.params(), tolerance);
    found.lens = read_lens(pasted, zero_to_one, std::max(tolerance, 1e-9));
    found.has_other_range = zero_to_one != state.is_zero_to_one();
}

/// Sets the axis of a left-handed V or C that differs from the state's in its sign alone.
void find_negated_axis(ExplainedMatrix& found, const dmat4& pasted, double tolerance) {
    const dmat4 axes{glm::dmat3(pasted)}, right{glm::dmat3(*found.right)};
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec4 signs(1.0);
        signs[axis] = -1.0;
        const dmat4 fixed = found.letter == 'V' ? flipped(signs) * axes : axes * flipped(signs);
        if (is_same(fixed, right, tolerance)) found.negated_axis = axis;
    }
}

/// Recognizes products of the state's matrices.
bool is_product(ExplainedMatrix& found, const dmat4& pasted, const StateMatrices& state, double tolerance) {
    const dmat4& v = state.first('V').right;
    if (is_same(pasted, state.first('P').right * v, tolerance)) found.fault = MatrixFault::product;
    for (const Known& one : state.known())
        if (one.letter == 'R' && is_same(pasted, v * one.right, tolerance)) found.fault = MatrixFault::mirrored_view;
    return found.fault != MatrixFault::unknown;
}

}  // namespace

ExplainedMatrix explain_matrix(const dmat4& pasted, char named, const Params& params, double aspect, double tolerance) {
    const StateMatrices state(params, aspect);
    std::vector<Known> known = state.known();
    std::stable_partition(known.begin(), known.end(), [named](const Known& one) { return one.letter == named; });
    const auto equals = [&](const Known& one, const dmat4& matrix) {
        return one.letter == 'S' ? is_same_map(pasted, matrix, tolerance) : is_same(pasted, matrix, tolerance);
    };
    // The program uploads −S if S gives casters a negative w, and both are the state's S.
    const auto is_right = [&](const Known& one) {
        return equals(one, one.right) || (state.uploads_negated(one) && equals(one, -one.right));
    };
    ExplainedMatrix found;
    const auto take = [&](const Known& one, MatrixFault fault) {
        found.letter = one.letter;
        found.fault = fault;
        found.plane = one.plane;
        found.light = one.light;
    };
    for (const Known& one : known) {
        if (found.letter == 0 && is_right(one)) take(one, MatrixFault::none);
    }
    const bool swaps = (named == 'V' && found.letter == 'C') || (named == 'C' && found.letter == 'V');
    if (swaps) take(state.first(named), MatrixFault::inverse);
    for (const Known& one : known) {
        if (found.letter != 0) break;
        for (const Spoiled& wrong : spoiled(state, one)) {
            if (!equals(one, wrong.matrix)) continue;
            take(one, wrong.fault);
            break;
        }
    }
    const bool is_known = found.letter != 0;
    if (!is_known && is_product(found, pasted, state, tolerance)) return found;
    if (!is_known && !explain_structure(found, pasted, named, state, tolerance) &&
        explain_structure(found, glm::transpose(pasted), named, state, tolerance))
        found.fault = MatrixFault::transposed;
    if (found.letter == 0) return found;
    for (const Known& one : known)
        if (one.letter == found.letter && one.plane == found.plane && one.light == found.light) found.right = one.right;
    found.off = found.letter == 'S' ? largest_difference_up_to_scale(pasted, *found.right)
                                    : largest_entry(pasted - *found.right);
    if (found.fault == MatrixFault::reversed) describe_reversed(found, pasted, state, tolerance);
    if (is_known) describe_right(found, state);
    if (found.fault == MatrixFault::left_handed && found.letter != 'P')
        find_negated_axis(found, pasted, 1e-5 + 4.0 * tolerance);
    return found;
}

}  // namespace viewing
