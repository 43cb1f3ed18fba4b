// Puts an explained matrix into words, for `matrices --explain`.
#pragma once

#include <string>

#include "state/file/document.h"
#include "topics/matrices/numbers/explain_matrix.h"
#include "topics/matrices/numbers/pasted_matrix.h"

namespace viewing {

/// Returns the explanation as lines: how the text was read, what the matrix is, what is wrong, by how much, and the
/// fix. `own` explains found.right, the state's matrix with the letter found.letter.
std::string explained_text(const PastedMatrix& pasted, const ExplainedMatrix& found, const ExplainedMatrix& own);

/// Returns the explanation as JSON: "matrix", "fault", "read_as", "say" (sentences), "off", "right" (rows), and the
/// camera, projection, plane or light found in the matrix.
Json explained_json(const PastedMatrix& pasted, const ExplainedMatrix& found);

}  // namespace viewing
