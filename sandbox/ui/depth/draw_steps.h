// The draw calls of a frame, triangle by triangle, as the steps of one bar: step n has drawn the frame's first n
// triangles. Pure functions. See cell_view.cpp for usage.
#pragma once

#include <optional>
#include <vector>

#include "frame/draw_calls.h"

namespace viewing {

/// The number of triangles in all calls.
int step_count(const std::vector<DrawCall>& calls);

/// Returns the step at which `limit` stops; −1 for the whole frame. Clamps counts past the end of the call, and calls
/// past the last one.
int step_of(const DrawLimit& limit, const std::vector<DrawCall>& calls);

/// Returns the call that draws the step's last triangle, and the number of its triangles drawn so far. Step 0 stops
/// before the first triangle; a negative step draws the whole frame.
DrawLimit limit_of(int step, const std::vector<DrawCall>& calls);

/// Moves by a whole call. The call before the whole frame is the last one; before the first call, nothing is drawn.
DrawLimit next_call(const DrawLimit& limit, const std::vector<DrawCall>& calls);
DrawLimit previous_call(const DrawLimit& limit, const std::vector<DrawCall>& calls);

/// Returns the first of `limits` that draws more than `limit`, or the last one that draws less; nullopt if there is
/// none. `limits` are in drawing order.
std::optional<DrawLimit> next_of(const std::vector<DrawLimit>& limits, const DrawLimit& limit,
                                 const std::vector<DrawCall>& calls);
std::optional<DrawLimit> previous_of(const std::vector<DrawLimit>& limits, const DrawLimit& limit,
                                     const std::vector<DrawCall>& calls);

}  // namespace viewing
