// A matrix as text to paste elsewhere: what `matrices --format` prints and the panel copies. Read matrix_text.cpp next.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "frame/matrix_symbols.h"

namespace viewing {

enum class MatrixFormat { text, latex, glm, glsl, numpy, matlab };

/// The matrix under its name, ending with a newline. The name is an identifier ("shadow_from_world"); one of the
/// lecture's letters with indices ("S[2,1]") is S_{2,1} in LaTeX and S_2_1 in code. text, latex, numpy and matlab show
/// rows as on the slides; glm and glsl list columns first, as their constructors take them, and say so in a comment.
/// LaTeX's stands between $ and $. Every number is the shortest decimal that reads back to the same double, or to the
/// double with `digits` significant digits; −0 is written as 0; NaN and infinity as the format's own language has them
/// (nan and inf in plain text).
std::string matrix_text(std::string_view name, const glm::dmat4& matrix, MatrixFormat format, int digits = 0);

/// The same with the symbolic form of the entries, in the format's own notation.
std::string matrix_text(std::string_view name, const MatrixSymbols& symbols, MatrixFormat format);

/// A number under its name, with a remark where the format has remarks.
std::string number_text(std::string_view name, double value, MatrixFormat format, std::string_view remark);

/// The nearest number that has so many significant decimal digits; 0: the number itself.
double rounded_to(double value, int digits);

}  // namespace viewing
