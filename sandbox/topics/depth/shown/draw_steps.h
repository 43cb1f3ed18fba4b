// The steps of a single bar that goes through a frame's draw calls triangle by triangle. At step n, the frame's first n
// triangles are drawn. Pure functions. See cell_view.cpp for usage.
#pragma once

#include <optional>
#include <vector>

#include "frame/plan/draw_calls.h"

namespace viewing {

/// Returns the number of triangles in all calls together.
int step_count(const std::vector<DrawCall>& calls);

/// Returns the step at which `limit` stops; −1 for the whole frame. Clamps a triangle count past the end of its call,
/// and a call past the last one.
int step_of(const DrawLimit& limit, const std::vector<DrawCall>& calls);

/// Returns the call that draws the step's last triangle, and how many of that call's triangles are drawn. Step 0 stops
/// before the first triangle; a negative step draws the whole frame.
DrawLimit limit_of(int step, const std::vector<DrawCall>& calls);

/// Returns the limit moved forward or back by a whole call. Going back from the whole frame leads to the last call;
/// going back from the first call leaves nothing drawn.
DrawLimit next_call(const DrawLimit& limit, const std::vector<DrawCall>& calls);
DrawLimit previous_call(const DrawLimit& limit, const std::vector<DrawCall>& calls);

/// next_of() returns the first of `limits` that draws more than `limit`, previous_of() the last one that draws less;
/// nullopt if there is none. `limits` must be in drawing order.
std::optional<DrawLimit> next_of(const std::vector<DrawLimit>& limits, const DrawLimit& limit,
                                 const std::vector<DrawCall>& calls);
std::optional<DrawLimit> previous_of(const std::vector<DrawLimit>& limits, const DrawLimit& limit,
                                     const std::vector<DrawCall>& calls);

}  // namespace viewing
