// Writes the lecture's display() with the numbers of a state, line by line, as a student would have to type it to get
// this picture: with the mistakes that are switched on, but without the errors on the slide.
#pragma once

#include <string>
#include <vector>

#include "frame/derive.h"

namespace viewing {

struct DisplayLine {
    std::string code;
    bool moves_world = false;  ///< the line is a factor of W
    std::string part = {};     ///< "projection", "rotate.yaw", "translate" …; empty if the line is not a single part
};

/// Returns the lines. P, V and W use GLM's functions, with angles in degrees and lengths in world units; P V W is the
/// clip_from_world of standard depth.
std::vector<DisplayLine> display_lines(const Params& params, const Derived& derived);

}  // namespace viewing
