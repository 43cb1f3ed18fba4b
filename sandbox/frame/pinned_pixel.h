// Finds the pinned pixel of the camera's picture: by its coordinates (view.pixel), or by a position in the picture or
// on an object (view.pin), which stays the same at every size of the picture.
#pragma once

#include <optional>
#include <string>

#include "frame/plan/plan.h"

namespace viewing {

/// An object's bounding box in the picture: the whole picture if part of the box is behind the eye; none if the box is
/// outside the picture.
struct ScreenBox {
    glm::dvec2 min_px, max_px;  ///< not rounded; may lie outside the picture
};
std::optional<ScreenBox> projected_box(const SceneObject& object, const glm::dmat4& clip_from_world,
                                       glm::ivec2 size_px);

struct PinnedPixel {
    std::optional<glm::ivec2> pixel;  ///< inside the picture; none if nothing is pinned or if `why_none` gives a reason
    Message why_none = {};            ///< one sentence: the reason why the pinned position is not visible
};

/// Finds the pinned pixel in the camera's frame `plan`, for a picture of this size. An object that is pinned without a
/// position is pinned at its visible pixel nearest to the middle of its box. The computed fragments
/// (topics/depth/numbers/fragments.h) decide visibility, on a grid of at most 33 × 33 pixels of the box.
PinnedPixel pinned_pixel(const Params& params, const Derived& derived, const FramePlan& plan, const Scene& scene,
                         glm::ivec2 size_px);

}  // namespace viewing
