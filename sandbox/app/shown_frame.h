// The data for one frame: the parameters at its time, and everything computed from them before a pixel is drawn. See
// studio.cpp for how it is made, and view_pictures.h for how it is drawn.
#pragma once

#include <memory>
#include <vector>

#include "frame/pinned_pixel.h"
#include "frame/plan/plan.h"
#include "frame/problems.h"
#include "topics/hidden/numbers/hidden_views.h"

namespace viewing {

struct ShownFrame {
    Params params;                    ///< the session's, at the frame's time
    glm::ivec2 camera_px{1280, 720};  ///< size of the camera's view when it was last shown
    Derived derived, before;          ///< `before` belongs to the state before the latest edit
    FramePlan plan;                   ///< of the camera's view
    PinnedPixel pinned;               ///< in the camera's view
    FramePlan inspected;              ///< the camera's view without effects, for reading pixels back
    std::vector<Problem> problems;
    std::shared_ptr<const HiddenAnswer> hidden;  ///< the hidden-surface method's result in the camera's view
};

}  // namespace viewing
