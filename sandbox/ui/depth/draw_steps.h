// The draw calls of a frame, triangle by triangle, as the steps of one bar: step n has drawn the first n triangles of
// the frame. Pure. Read cell_view.cpp for its use.
#pragma once

#include <optional>
#include <vector>

#include "frame/draw_calls.h"

namespace viewing {

/// The triangles of all calls.
int step_count(const std::vector<DrawCall>& calls);

/// −1 for a frame that is drawn whole. What a limit counts beyond its call, or beyond the calls, is left out.
int step_of(const DrawLimit& limit, const std::vector<DrawCall>& calls);

/// The call that draws the step's last triangle, and how many of its triangles are there; step 0 stops before the first
/// one, and a negative step stops nowhere.
DrawLimit limit_of(int step, const std::vector<DrawCall>& calls);

/// A whole call further, or back: from the frame drawn whole to its last call, and from the first call to nothing.
DrawLimit next_call(const DrawLimit& limit, const std::vector<DrawCall>& calls);
DrawLimit previous_call(const DrawLimit& limit, const std::vector<DrawCall>& calls);

/// Of limits in drawing order the first one that draws more than `limit`, and the last one that draws less; none: there
/// is none.
std::optional<DrawLimit> next_of(const std::vector<DrawLimit>& limits, const DrawLimit& limit,
                                 const std::vector<DrawCall>& calls);
std::optional<DrawLimit> previous_of(const std::vector<DrawLimit>& limits, const DrawLimit& limit,
                                     const std::vector<DrawCall>& calls);

}  // namespace viewing
