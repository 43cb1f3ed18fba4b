// Decals by equal depth, or by a mark in the stencil buffer: a part of plan().
#include "frame/plan.h"

namespace viewing {

void draw_decals_apart(std::vector<Pass>& passes, const Params& params) {
    const DecalMethod method = params.depth.decals;
    if (method == DecalMethod::offset || params.visibility.method != VisibilityMethod::depth_buffer) return;
    Pass& objects = passes.back();
    objects.chosen = Chosen::bases;
    Pass decals = objects;
    decals.name = "Decals";
    decals.reason = "draws decals where the depth is that of what they lie on";
    decals.chosen = Chosen::decals;
    decals.depth.write = false;
    decals.offset = DepthOffset{};
    if (method == DecalMethod::equal) {
        decals.depth.func = CompareFunc::equal;
    } else {
        objects.marks_objects = decals.marks_objects = true;
        objects.stencil = {true, CompareFunc::always, 0, StencilOp::replace};
        decals.reason = "draws decals where the stencil says that what they lie on is seen: no depth decides";
        decals.depth.test = false;
        decals.stencil = {true, CompareFunc::equal, 0, StencilOp::keep};
    }
    passes.push_back(decals);
}

}  // namespace viewing
