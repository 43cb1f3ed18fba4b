// The frame as passes: the GL calls in order, and the color, depth and stencil buffers after each pass.
#pragma once

#include <array>

#include "frame/plan/plan.h"
#include "session/session.h"
#include "ui/parts/layout.h"
#include "widgets/diagrams.h"

namespace viewing {

/// Color, depth and stencil after the pass where the frame stops.
using PassPictures = std::array<ImTextureID, 3>;

/// Returns the size of each of the three pictures in a view of this size. `aspect`: width / height of the camera's
/// picture.
glm::ivec2 pass_picture_size(const Rect& rect, double aspect);

/// Draws the list with its step bar, which edits view.pass, and the three pictures beside or below it.
void draw_passes_view(Session& session, const FramePlan& plan, const Rect& rect, const PassPictures& pictures,
                      double aspect, widgets::StepPlayer& player);

}  // namespace viewing
