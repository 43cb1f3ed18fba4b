// The matrices that a state should have, and their versions after common mistakes. Part of explain_matrix.h.
#pragma once

#include <algorithm>
#include <vector>

#include "topics/matrices/numbers/explain_matrix.h"

namespace viewing {

/// A matrix of the state.
struct Known {
    char letter;
    glm::dmat4 right;
    std::size_t plane = 0, light = 0;
};

/// The matrices of a state without its mistakes and without a V or P entered by hand: V, C, P, then each plane's S and
/// R.
class StateMatrices {
public:
    StateMatrices(const Params& params, double aspect);

    const std::vector<Known>& known() const { return known_; }
    const Known& first(char letter) const {
        return *std::find_if(known_.begin(), known_.end(), [&](const Known& one) { return one.letter == letter; });
    }
    const Params& params() const { return params_; }
    bool is_reversed() const { return params_.depth.mapping == DepthMapping::reversed; }
    /// Whether `one` is an S that gives casters a negative w, so that the program uploads −S.
    bool uploads_negated(const Known& one) const;
    bool is_zero_to_one() const { return is_reversed() && params_.depth.reversed_zero_to_one; }

    /// Returns P for a clip range and a direction of depth; `degrees`, `inverse_aspect`: with that mistake.
    glm::dmat4 projection(bool zero_to_one, bool reversed, bool degrees = false, bool inverse_aspect = false) const;

private:
    double shown_aspect() const { return params_.projection.aspect > 0.0 ? params_.projection.aspect : aspect_; }

    Params params_;
    double aspect_;
    glm::dmat4 camera_;
    std::vector<Known> known_;
};

struct Spoiled {
    MatrixFault fault;
    glm::dmat4 matrix;
};

/// Returns the versions of a matrix that common mistakes produce.
std::vector<Spoiled> spoiled(const StateMatrices& state, const Known& one);

/// Returns the matrix that scales the axes; −1 flips an axis.
glm::dmat4 flipped(const glm::dvec4& signs);

}  // namespace viewing
