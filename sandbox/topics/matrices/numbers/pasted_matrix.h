// Reads a matrix pasted from a program or a sheet. Read explain_matrix.h next, which identifies the matrix.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "text/result.h"

namespace viewing {

struct PastedMatrix {
    glm::dmat4 matrix{1.0};
    const char* syntax = "";  ///< "GLM", "NumPy", "MATLAB", "C array", "JSON", "LaTeX" or "plain text"
    bool by_columns = false;  ///< the numbers were read by columns, the order of this syntax
    char letter = 0;          ///< V, C, P, S or R if the text names the matrix; 0 if not
    double tolerance = 1e-9;  ///< half a unit in the last decimal place
    bool has_more = false;    ///< there are at least 16 numbers after these
};

/// Reads 16 numbers, nested or flat: by columns from GLM, C and a flat JSON list (as WebGL stores matrices), and by
/// rows from NumPy, MATLAB, nested JSON, LaTeX and plain text. Allows comments, and before the numbers a name and
/// MATLAB's common factor ("1.0e+03 *"). Returns an error for any other count of numbers.
Result<PastedMatrix> read_pasted_matrix(std::string_view text);

}  // namespace viewing
