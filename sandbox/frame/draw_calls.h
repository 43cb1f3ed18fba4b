// A frame as the draw calls that GL gets, one after another, to stop between them and within them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frame/plan.h"

namespace viewing {

struct DrawCall {
    std::size_t pass = 0;  ///< index in FramePlan::passes
    int object = -1;       ///< index in Scene::objects; −1: a square, the pass's patch or a fresh picture
    int triangles = 0;

    bool operator==(const DrawCall&) const = default;
};

/// "plane", "plane 2", "plane 3" …
std::string plane_name(std::size_t plane);

/// Whether a pass over the objects draws this one.
bool is_chosen(Chosen chosen, const SceneObject& object);

/// How many calls a pass makes: one for a square, one for each object; none for what a method found.
int call_count(const Pass& pass, const Scene& scene);

/// How many of a call's triangles are drawn: all before the limit's call, and none after it.
int triangles_drawn(const DrawLimit& limit, int call, int triangles);

/// The calls of a frame whose method draws the scene as it comes, in order; of other methods none.
std::vector<DrawCall> draw_calls(const FramePlan& plan, const Scene& scene);

/// "box, pass 4: Objects".
std::string name_of(const DrawCall& call, const FramePlan& plan, const Scene& scene);

/// The step before: the triangle before, or the last one of the call before; from the first one on {0, 0}, nothing.
DrawLimit step_before(const DrawLimit& limit, const std::vector<DrawCall>& calls);

}  // namespace viewing
