// The right column: V or C, P, S and R as on the slides, the followed point, and the slide's display() function with
// the camera's numbers.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "frame/derive.h"
#include "session/session.h"
#include "text/per_enum.h"

namespace viewing {

/// The choice of matrices in the column; kept between frames.
struct MatrixChoice {
    bool shows_camera = false;  ///< C instead of V
    char pastes = 0;            ///< the letter of the matrix to replace with one from the clipboard; 0: none
    std::string opened = "";    ///< the matrix whose folded heading was clicked last: it is shown before all others
};

/// How much of a matrix a short column shows.
enum class MatrixPart { heading, numbers, symbols };

inline constexpr std::array<const char*, 4> matrices_in_order = {"V", "P", "S", "R"};

/// Decides how much of each matrix in matrices_in_order a column shows, so that nothing is cut off. The matrices in
/// `first` get space for numbers and symbols before the others get any. `heights`: the heights of one matrix, by
/// MatrixPart.
std::array<MatrixPart, 4> fit_matrices(float room, const PerEnum<MatrixPart, float, 3>& heights,
                                       std::span<const std::string> first);

/// Draws the column; if it is short, shows the matrices in `about` first. `before` holds the numbers before the latest
/// edit; entries that differ are tinted.
void draw_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice,
                   std::span<const std::string> about);

/// Draws only these matrices, in this order; the names are those of view.layout.matrices.
void draw_listed_matrices(Session& session, const Derived& derived, const Derived& before, MatrixChoice& choice,
                          const std::vector<std::string>& listed);

}  // namespace viewing
