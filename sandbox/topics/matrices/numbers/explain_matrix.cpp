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
    if (found.letter == 'P') found.lens = read_lens(*found.right, state.is_zero_to_one(), 1e-12);
    if (found.letter == 'S' || found.letter == 'R')
        found.found_plane = unit_plane(state.params().planes[found.plane].equation);
    if (found.letter == 'S') found.found_light = state.params().lights[found.light].position;
}

}  // namespace

ExplainedMatrix explain_matrix(const dmat4& pasted, char named, const Params& params, double aspect, double tolerance) {
    const StateMatrices state(params, aspect);
    std::vector<Known> known = state.known();
    std::stable_partition(known.begin(), known.end(), [named](const Known& one) { return one.letter == named; });
    const auto equals = [&](const Known& one, const dmat4& matrix) {
        return one.letter == 'S' ? is_same_map(pasted, matrix, tolerance) : is_same(pasted, matrix, tolerance);
    };
    ExplainedMatrix found;
    const auto take = [&](const Known& one, MatrixFault fault) {
        found.letter = one.letter;
        found.fault = fault;
        found.plane = one.plane;
        found.light = one.light;
    };
    for (const Known& one : known) {
        if (found.letter == 0 && equals(one, one.right)) take(one, MatrixFault::none);
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
    if (!is_known && !explain_structure(found, pasted, named, state, tolerance) &&
        explain_structure(found, glm::transpose(pasted), named, state, tolerance))
        found.fault = MatrixFault::transposed;
    if (found.letter == 0 && is_same(pasted, state.first('P').right * state.first('V').right, tolerance))
        found.fault = MatrixFault::product;
    if (found.letter == 0) return found;
    for (const Known& one : known)
        if (one.letter == found.letter && one.plane == found.plane && one.light == found.light) found.right = one.right;
    found.off = found.letter == 'S' ? largest_difference_up_to_scale(pasted, *found.right)
                                    : largest_entry(pasted - *found.right);
    if (is_known) describe_right(found, state);
    return found;
}

}  // namespace viewing
