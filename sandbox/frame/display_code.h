// The lecture's display() with the numbers of a state, line by line, as a student would have to type it to get this
// picture: with the slips that are switched on, without those of the slide.
#pragma once

#include <string>
#include <vector>

#include "frame/derive.h"

namespace viewing {

struct DisplayLine {
    std::string code;
    bool moves_world = false;  ///< a factor of W
    std::string part = {};  ///< what it stands for: "projection", "rotate.yaw", "translate"; empty: nothing by itself
};

/// P, V and W are the matrices of GLM's functions, angles in degrees, lengths in world
/// units; P V W is clip_from_world of standard depth.
std::vector<DisplayLine> display_lines(const Params& params, const Derived& derived);

}  // namespace viewing
