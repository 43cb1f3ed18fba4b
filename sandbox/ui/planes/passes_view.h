// The frame as passes: what GL is told, in order, and what each pass leaves in colour, depth and stencil.
#pragma once

#include <array>

#include "frame/plan.h"
#include "session/session.h"
#include "ui/parts/layout.h"
#include "widgets/diagrams.h"

namespace viewing {

/// Colour, depth and stencil after the pass that the frame stops at.
using PassPictures = std::array<ImTextureID, 3>;

/// The size of each of the three pictures in a view of this place: `aspect` is the camera's, width by height.
glm::ivec2 pass_picture_size(const Rect& rect, double aspect);

/// The list with its steps, which edit view.pass, and the three pictures beside it.
void draw_passes_view(Session& session, const FramePlan& plan, const Rect& rect, const PassPictures& pictures,
                      double aspect, widgets::StepPlayer& player);

}  // namespace viewing
