// A derivation as a list of lines, in the order in which they are written on a board. Pure text: derivation_views.h
// shows them, all at once or one after the other.
#pragma once

#include <string>
#include <vector>

#include "frame/planes/derivation.h"

namespace viewing {

struct DerivationLine {
    enum class Kind { equation, heading, note };

    Kind kind = Kind::equation;
    std::vector<std::string> parts;  ///< of an equation as equation() takes them; else one text, marked or finished
    std::string target = {};         ///< its name for a lesson
    bool is_step = false;  ///< leads to a result: left out where there is room for results alone and none is stepped to
};

/// How s follows from l, p and the plane, from the line of sight of the light to the rows of S and the division by w.
/// `is_blinn`: the plane is y = 0 with its normal up, whose rows are the slide's.
std::vector<DerivationLine> shadow_lines(const ShadowDerivation& found, bool is_blinn);

/// How q′ follows from q and the plane, with the lecture's expansion row by row.
std::vector<DerivationLine> mirror_lines(const MirrorDerivation& found);

/// How many steps there are: a heading comes with the line below it.
int step_count(const std::vector<DerivationLine>& lines);

/// What is written after so many steps; all for −1 or more than there are.
std::vector<DerivationLine> lines_until(const std::vector<DerivationLine>& lines, int steps);

}  // namespace viewing
