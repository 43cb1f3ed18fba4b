// A matrix as text to paste elsewhere: what `matrices --format` prints and the panel copies. Read matrix_text.cpp next.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>

namespace viewing {

enum class MatrixFormat { text, latex, glm, glsl, numpy, matlab };

/// The matrix under a name that is an identifier ("shadow_from_world"), ending with a newline. text, latex, numpy and
/// matlab show rows as on the slides; glm and glsl list columns first, as their constructors take them, and say so in
/// a comment. Every number is the shortest decimal that reads back to the same double; −0 is written as 0; NaN and
/// infinity as the format's own language has them (nan and inf in plain text).
std::string matrix_text(std::string_view name, const glm::dmat4& matrix, MatrixFormat format);

}  // namespace viewing
