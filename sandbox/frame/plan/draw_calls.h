// The sequence of draw calls that a frame sends to GL, so that the frame can stop between two calls or within one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frame/plan/plan.h"

namespace viewing {

struct DrawCall {
    std::size_t pass = 0;  ///< index in FramePlan::passes
    int object = -1;       ///< index in Scene::objects; −1 for a square: the patch or the backdrop
    int triangles = 0;

    bool operator==(const DrawCall&) const = default;
};

/// Returns "plane", "plane 2", "plane 3", and so on: in English; object_text() translates it.
std::string plane_name(std::size_t plane);

/// Returns whether a pass with this choice draws the object.
bool is_chosen(Chosen chosen, const SceneObject& object);

/// Returns how many calls a pass makes: one for a square, one for each object that it draws, or none if it shows the
/// result of a hidden-surface method.
int call_count(const Pass& pass, const Scene& scene);

/// Returns how many of a call's triangles are drawn: all if the call comes before the limit's call, none if it comes
/// after that call, and as many as the limit allows if it is that call.
int triangles_drawn(const DrawLimit& limit, int call, int triangles);

/// Returns a frame's calls in order if its method draws the scene in scene order; otherwise, returns no calls.
std::vector<DrawCall> draw_calls(const FramePlan& plan, const Scene& scene);

/// Returns a call's name, such as "box, pass 4: Objects".
Message name_of(const DrawCall& call, const FramePlan& plan, const Scene& scene);

/// Returns the limit that is one triangle earlier, if necessary in an earlier call. Before the first triangle, it is
/// {0, 0}, which draws nothing.
DrawLimit step_before(const DrawLimit& limit, const std::vector<DrawCall>& calls);

}  // namespace viewing
