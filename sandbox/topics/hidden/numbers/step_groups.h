// Groups a method's steps so that hundreds of thousands of them remain navigable: the steps of one polygon, of a row of
// rays, of building a tree, or of traversing it. Pure. Read hidden_surfaces.h first.
#pragma once

#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {

/// The position of a step. Empty groups are numbered too, but no step is ever in one.
struct StepPlace {
    int group = 0, groups = 0;  ///< the step's group, counted from 1, and the number of groups
    int within = 0, size = 0;   ///< how many of the group's steps are done, out of how many
    int first = 0;              ///< the step before the group's first one
};

/// Returns a step's position; none for a method without groups or steps. A negative `step` means the last one, as in
/// the parameters.
std::optional<StepPlace> place_of_step(const HiddenResult& result, int step);

/// Returns the last step of a group; groups are counted from 1.
int end_of_group(const HiddenResult& result, int group);
/// Return the first group end after the step, and the last group boundary before it: a group end, or 0. None if there
/// is no such step.
std::optional<int> next_group(const HiddenResult& result, int step);
std::optional<int> previous_group(const HiddenResult& result, int step);

/// Return the next or the previous step that touches the followed pixel; none if no such step exists.
std::optional<int> next_touch(const HiddenResult& result, int step);
std::optional<int> previous_touch(const HiddenResult& result, int step);

}  // namespace viewing
