// Configures a frame's depth buffer, and draws decals by equal depth or by a mark in the stencil buffer: parts of
// plan().
#include <algorithm>

#include "frame/depth_switches.h"
#include "frame/plan/plan_parts.h"

namespace viewing {

double offset_sign(const DepthParams& depth) {
    return depth.mapping == DepthMapping::reversed && depth.reversed_offset ? -1.0 : 1.0;
}

void set_depth(FramePlan& frame, const Params& params, const Derived& derived) {
    const DepthParams& depth = params.depth;
    frame.clear_depth = depth.clear;
    frame.mask_on_while_clearing = depth.write_while_clearing;
    frame.clear_depth_value = cleared_depth(depth);
    frame.depth_format = depth.format;
    frame.stored_depth = derived.stored_depth;
    frame.depth_mapping = depth.mapping;
    frame.logarithm_per_vertex = depth.logarithm_per_vertex;
    frame.lens = params.lens();
    frame.has_distances = derived.has_distances;
    frame.clip_zero_to_one = derived.clip_zero_to_one;
    frame.has_decals = derived.has_decals;
    frame.decal_offset = {offset_sign(depth) * depth.offset.factor, offset_sign(depth) * depth.offset.units};
    frame.object_marks = derived.object_marks;
    frame.depth_scale = params.view.depth_scale;
    frame.depth_colors = params.view.depth_colors;
    frame.shown_range = params.view.depth_range.value_or(glm::dvec2(frame.lens.near, frame.lens.shown_far()));
}

namespace {

/// Returns a pass that clears the marks of patches, so that objects can set new ones.
Pass without_marks(const Pass& objects) {
    Pass pass = objects;
    fill_picture(pass, 0.0, 1.0);
    pass.name = message("Clear marks");
    pass.reason = message("clears the planes' marks from the stencil, so that they are not mistaken for object marks");
    pass.color_write = false;
    pass.depth = without_depth;
    pass.stencil = stencil_of_wiping();
    return pass;
}

}  // namespace

void draw_decals_apart(std::vector<Pass>& passes, const Params& params) {
    const DecalMethod method = params.depth.decals;
    if (method == DecalMethod::offset || !uses_gl_depth_test(params.visibility.method)) return;
    const auto found = std::find_if(passes.begin(), passes.end(), [](const Pass& pass) {
        return pass.subject == Subject::objects && pass.shading == Shading::lit && !pass.is_mirror_image;
    });
    if (found == passes.end()) return;
    Pass& objects = *found;
    objects.chosen = Chosen::bases;
    Pass decals = objects;
    decals.name = message("Decals");
    decals.reason = message("draws decals where their depth equals that of the surface below");
    decals.chosen = Chosen::decals;
    decals.depth.write = false;
    decals.offset = DepthOffset{};
    if (method == DecalMethod::equal) {
        decals.depth.func = CompareFunc::equal;
    } else {
        objects.marks_objects = decals.marks_objects = true;
        objects.stencil = stencil_of_decal_bases();
        decals.reason =
            message("draws decals where the stencil shows that the surface below is visible: depth plays no part");
        decals.depth.test = false;
        decals.stencil = stencil_of_decals();
    }
    const bool has_marks = std::any_of(passes.begin(), found, [](const Pass& pass) {
        return pass.stencil.test && pass.stencil.on_pass != StencilOp::keep;
    });
    const auto at = passes.insert(found + 1, decals) - 1;
    if (method == DecalMethod::stencil && has_marks) passes.insert(at, without_marks(*at));
}

}  // namespace viewing
