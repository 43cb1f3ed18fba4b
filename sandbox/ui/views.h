// The pictures with what is drawn over them and what the mouse does in them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ui/handles.h"
#include "ui/input.h"
#include "ui/laboratory.h"
#include "ui/session.h"

namespace viewing {

/// What the lower right view shows.
enum class LowerTopic { depth, moving_world, passes, tree, order, growth };

/// Finished pictures to show, null while there is none, and what was found for them.
struct Pictures {
    ImTextureID camera = nullptr, observer = nullptr, lower_right = nullptr;
    HiddenStatus hidden;
};

/// What the mouse is doing in the views; kept between frames.
struct ViewState {
    LowerTopic topic = LowerTopic::depth;
    VisibilityMethod topic_for = VisibilityMethod::depth_buffer;  ///< the method that `topic` follows
    bool handles = true;
    Grip grip;
    bool looking = false;                     ///< dragging to turn the camera
    float dragged_px = 0.0F;                  ///< since the press: a click that did not move picks a vertex
    std::optional<glm::ivec2> hovered_pixel;  ///< of the camera's picture, top left origin
    ViewName hovered = ViewName::none;
    LaboratoryState laboratory;
};

/// The camera's picture; adds what the mouse did to the motion input.
void draw_camera_view(ViewState& state, Session& session, const Derived& derived, const Rect& rect,
                      const Pictures& pictures, const FrameInput& input, MotionInput& motion);

void draw_observer_view(ViewState& state, Session& session, const Derived& derived, const Rect& rect,
                        const Pictures& pictures);

/// The lower right view; `passes` is the frame plan for its list of GL calls.
void draw_lower_right_view(ViewState& state, Session& session, const Derived& derived, const FramePlan& plan,
                           const Rect& rect, const Pictures& pictures);

}  // namespace viewing
