// The symbolic form of each matrix's entries, as it stands under the numbers in the window. Read matrix_text.h for the
// numbers.
#pragma once

#include <array>
#include <string>

#include "state/params.h"

namespace viewing {

/// Row by row. Products are written without a sign ("-l_x n_y", "2fn"), powers as "a^2"; right, up, back, eye and
/// aspect are words, all other letters stand by themselves.
using MatrixSymbols = std::array<const char*, 16>;

/// S of the unit plane (n, d) and the light l.
MatrixSymbols shadow_symbols();
/// R of the unit plane a, b, c, d; with the slips of the slides.
MatrixSymbols mirror_symbols(bool printed_by_rows, bool plus_2ab);
/// V and C; swapped: turned before it is moved.
MatrixSymbols view_symbols(bool swapped_order);
MatrixSymbols camera_symbols(bool swapped_order);
/// P with near n, far f, height h and c = cot(½ fovy).
MatrixSymbols projection_symbols(const Params& params, bool clip_zero_to_one);

/// One of them for LaTeX's mathematics: "\Pi \cdot L - l_x n_x".
std::string symbol_as_latex(const std::string& symbol);
/// One of them for C, GLSL, Python and MATLAB, with products written out: "plane_dot_light-l_x*n_x".
std::string symbol_as_code(const std::string& symbol);

}  // namespace viewing
