// What a matrix is by its own structure, whatever the state's matrices are. Part of explain_matrix.h.
#pragma once

#include "frame/explain/state_matrices.h"

namespace viewing {

/// Sets the camera and its angles.
void describe_camera(ExplainedMatrix& found, const glm::dmat4& world_from_view);

/// Sets what the matrix is and holds, as far as its structure tells; returns whether it tells anything. The state
/// decides where the structure allows two answers.
bool explain_structure(ExplainedMatrix& found, const glm::dmat4& m, char named, const StateMatrices& state,
                       double tolerance);

}  // namespace viewing
