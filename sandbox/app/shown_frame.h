// What is on screen in one frame: the parameters as they are at the time, and everything that is made from them before
// a pixel is drawn. Read studio.cpp for how it is made, view_pictures.h for what is made of it.
#pragma once

#include <memory>
#include <vector>

#include "frame/hidden/hidden_views.h"
#include "frame/pinned_pixel.h"
#include "frame/plan.h"
#include "frame/problems.h"

namespace viewing {

struct ShownFrame {
    Params params;                    ///< the session's, as they are at the time
    glm::ivec2 camera_px{1280, 720};  ///< of the camera's view when it was shown last
    Derived derived, before;          ///< `before`: as they were before the latest edit
    FramePlan plan;                   ///< of the camera's view
    PinnedPixel pinned;               ///< in the camera's view
    FramePlan inspected;              ///< the same with its colours, to be read
    std::vector<Problem> problems;
    std::shared_ptr<const HiddenAnswer> hidden;  ///< what the camera's view shows of the hidden-surface methods
};

}  // namespace viewing
