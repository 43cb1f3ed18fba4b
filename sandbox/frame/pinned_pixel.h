// Which pixel of the camera's picture is pinned: by its numbers (view.pixel), or by what lies there (view.pin), so that
// it is the same place at every size of the picture.
#pragma once

#include <optional>
#include <string>

#include "frame/plan.h"

namespace viewing {

/// Where an object's bounding box is in the picture; the whole picture where a part of the box lies behind the eye.
/// None where it is not in the picture.
struct ScreenBox {
    glm::dvec2 min_px, max_px;  ///< not rounded, may lie outside of the picture
};
std::optional<ScreenBox> projected_box(const SceneObject& object, const glm::dmat4& clip_from_world,
                                       glm::ivec2 size_px);

struct PinnedPixel {
    std::optional<glm::ivec2> pixel;  ///< inside the picture; none: nothing is pinned, or `why_none`
    std::string why_none = "";        ///< where something is pinned that is not to be seen: one sentence, looked up
};

/// Of the camera's frame `plan` in a picture of this size. An object without a place of its own is pinned at that of
/// its visible pixels which is nearest to the middle of its box: visible is what the computed fragments say
/// (frame/depth/fragments.h), on a grid of some hundred pixels of the box.
PinnedPixel pinned_pixel(const Params& params, const Derived& derived, const FramePlan& plan, const Scene& scene,
                         glm::ivec2 size_px);

}  // namespace viewing
