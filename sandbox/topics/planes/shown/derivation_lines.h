// A derivation as a list of lines, in the order in which they are written on a blackboard. Text only:
// derivation_views.h draws the lines, all at once or step by step.
#pragma once

#include <string>
#include <vector>

#include "topics/planes/numbers/derivation.h"

namespace viewing {

struct DerivationLine {
    enum class Kind { equation, heading, note, trouble };

    Kind kind = Kind::equation;
    std::vector<std::string> parts;  ///< the parts for equation(); otherwise one text, marked() or translated
    std::string target = {};         ///< the line's name in lessons
    bool is_step = false;  ///< an intermediate step: omitted if only the results fit, unless the user goes step by step
};

/// Derives s from l, p and the plane, starting with the light's ray and ending with the rows of S and the division by
/// w. `is_blinn`: whether the plane is y = 0 with its normal up, so that the rows match the slide.
std::vector<DerivationLine> shadow_lines(const ShadowDerivation& found, bool is_blinn);

/// Derives q′ from q and the plane, then expands it row by row as the lecture does.
std::vector<DerivationLine> mirror_lines(const MirrorDerivation& found);

/// Returns the number of steps. A heading appears together with the line below it.
int step_count(const std::vector<DerivationLine>& lines);

/// Returns the lines that are written after `steps` steps; all lines if `steps` is negative or past the end.
std::vector<DerivationLine> lines_until(const std::vector<DerivationLine>& lines, int steps);

}  // namespace viewing
