// Gives the state the camera, projection, S or R of a pasted matrix. Read explain_matrix.h first.
#pragma once

#include <optional>

#include "topics/matrices/numbers/explain_matrix.h"

namespace viewing {

/// Returns whether the matrix can be taken as it is: a correct V, C, P, S or R, of this state or another. A P with near
/// and far swapped is correct, too: depth is then reversed.
bool is_takeable(const ExplainedMatrix& found);

/// Returns whether the matrix could be taken, but is not the one that its name says: V, C, P, S, R; 0: it has no name.
bool is_misnamed(char named, const ExplainedMatrix& found);

/// Returns the pasted V, C or P without its fault; none for other matrices and unknown faults.
std::optional<glm::dmat4> fixed_matrix(const glm::dmat4& pasted, const ExplainedMatrix& found);

/// Gives the state the camera, projection, S or R of a matrix that can be taken, so that the state's own matrix equals
/// `matrix`, and switches off mistakes that would make the two differ. P is read for the clip range −1 … 1 or, if P is
/// reversed, as is_for_zero_to_one() decides; S and R replace those of the chosen plane and light. `letter`: V, C, P, S
/// or R. `view_aspect`: width ÷ height of the view; `tolerance`: rounding of each entry. Returns false for values that
/// no state may have.
bool take_matrix(Params& params, char letter, const glm::dmat4& matrix, double view_aspect, double tolerance = 1e-9);

/// Returns the setting that enters a matrix by hand: "overrides.shadow_from_world=[[…], …]".
std::string setting_of(const char* path, const glm::dmat4& matrix);

/// Enters a matrix by hand, right or wrong: in place of V, P, or the chosen plane's and light's S or R; for a C, its
/// inverse in place of V. Returns false for values that no state may have and for a C without an inverse.
bool enter_by_hand(Params& params, char letter, const glm::dmat4& matrix);

}  // namespace viewing
