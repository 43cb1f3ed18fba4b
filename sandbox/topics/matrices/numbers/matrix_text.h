// Writes a matrix as text to paste elsewhere: for `matrices --format` and the panel. Read matrix_text.cpp next.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "frame/matrix_symbols.h"

namespace viewing {

enum class MatrixFormat { text, latex, glm, glsl, numpy, matlab };

/// Returns the matrix with its name, as text that ends with a newline. The name is an identifier ("shadow_from_world")
/// or one of the lecture's letters with indices: "S[2,1]" becomes S_{2,1} in LaTeX and S_2_1 in code. text, latex,
/// numpy and matlab list rows as on the slides; glm and glsl list columns first, in the order of their constructors'
/// arguments, and say so in a comment. Put the LaTeX between $ and $. Every number is the shortest decimal that reads
/// back to the same double or, if `digits` is not 0, to the double rounded to that many significant digits. −0 becomes
/// 0; NaN and infinity are written in the format's own notation (nan and inf in plain text).
std::string matrix_text(std::string_view name, const glm::dmat4& matrix, MatrixFormat format, int digits = 0);

/// Returns the text of a matrix with symbolic entries, in the format's own notation.
std::string matrix_text(std::string_view name, const MatrixSymbols& symbols, MatrixFormat format);

/// Returns a number with its name as text, followed by the remark in every format except LaTeX.
std::string number_text(std::string_view name, double value, MatrixFormat format, std::string_view remark);

/// Returns the nearest number with `digits` significant decimal digits, or the number itself if `digits` is 0.
double rounded_to(double value, int digits);

}  // namespace viewing
