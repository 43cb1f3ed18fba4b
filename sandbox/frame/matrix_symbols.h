// The symbolic form of each matrix's entries, shown under the numbers in the window. See matrix_text.h for the numbers.
#pragma once

#include <array>
#include <string>

#include "state/params.h"

namespace viewing {

/// The entries row by row. Products have no operator ("-l_x n_y", "2fn"); powers are written "a^2". right, up, back,
/// eye and aspect are words; every other letter is a separate symbol.
using MatrixSymbols = std::array<const char*, 16>;

/// Returns S for the unit plane (n, d) and the light l.
MatrixSymbols shadow_symbols(bool by_rows = false);
/// Returns R for the unit plane (a, b, c, d), with the slides' mistakes that are switched on.
MatrixSymbols mirror_symbols(bool printed_by_rows, bool plus_2ab);
/// Return V and C. `swapped_order`: C = R T instead of T R.
MatrixSymbols view_symbols(bool swapped_order);
MatrixSymbols camera_symbols(bool swapped_order);
/// Returns P with near n, far f, height h and c = cot(½ fovy), or with the window's edges l, r, b and t.
MatrixSymbols projection_symbols(const Params& params, bool clip_zero_to_one);

/// Returns a symbol as LaTeX math: "\Pi \cdot L - l_x n_x".
std::string symbol_as_latex(const std::string& symbol);
/// Returns a symbol for C, GLSL, Python and MATLAB, with products written out: "plane_dot_light-l_x*n_x".
std::string symbol_as_code(const std::string& symbol);

}  // namespace viewing
