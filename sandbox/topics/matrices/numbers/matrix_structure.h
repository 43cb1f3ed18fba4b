// Identifies a matrix by its own structure, independently of the state's matrices. Part of explain_matrix.h.
#pragma once

#include "topics/matrices/numbers/state_matrices.h"

namespace viewing {

/// Sets the camera and its angles.
void describe_camera(ExplainedMatrix& found, const glm::dmat4& world_from_view);

/// Gives both entries of P's third row the signs that they have in `right`.
glm::dmat4 with_depth_signs(glm::dmat4 p, const glm::dmat4& right);

/// Sets the matrix's letter and parameters as far as its structure determines them; returns whether it determines any.
/// Where the structure allows two answers, the state decides.
bool explain_structure(ExplainedMatrix& found, const glm::dmat4& m, char named, const StateMatrices& state,
                       double tolerance);

}  // namespace viewing
