// The steps of a method in two levels: those of one polygon, of a row of rays, or of building and walking a tree belong
// together, so that hundreds of thousands of them can be gone through. Pure. Read hidden_surfaces.h first.
#pragma once

#include "frame/hidden/hidden_surfaces.h"

namespace viewing {

/// Where a step stands. Groups without a step count, and are passed over.
struct StepPlace {
    int group = 0, groups = 0;  ///< counted from 1 on
    int within = 0, size = 0;   ///< how many of the group's steps are done, of how many
    int first = 0;              ///< the step before the group's first one
};

/// None for a method without groups, or without a step. A negative `step` is the last one, as in the parameters.
std::optional<StepPlace> place_of_step(const HiddenResult& result, int step);

/// The end of a group, counted from 1 on.
int end_of_group(const HiddenResult& result, int group);
/// To the end of the step's group, or of the next one; back to its beginning, or to that of the one before. None where
/// it stands there already.
std::optional<int> next_group(const HiddenResult& result, int step);
std::optional<int> previous_group(const HiddenResult& result, int step);

/// The next step that touches the followed pixel, and the one before. None: there is none.
std::optional<int> next_touch(const HiddenResult& result, int step);
std::optional<int> previous_touch(const HiddenResult& result, int step);

/// For each place in the order the step that draws its polygon whole.
std::vector<int> steps_of_order(const HiddenResult& result);

}  // namespace viewing
