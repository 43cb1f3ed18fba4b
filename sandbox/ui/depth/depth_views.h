// Depth buffers as pictures: below the camera's view, beside it and across it, and how often each depth occurs.
#pragma once

#include "frame/derive.h"
#include "frame/pixel_report.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// The depth buffer below the camera's view, with what its shades stand for. The headline's line is begun.
void draw_depth_picture(Session& session, const Derived& derived, const Rect& rect, ImTextureID picture);

/// How often each depth occurs in the camera's picture; its two lines are the range that depth pictures show.
void draw_histogram_view(Session& session, const Derived& derived, const DepthCounts& counts, const Rect& rect);

/// The second picture in a half of its own.
void draw_beside_picture(Session& session, const Rect& rect, ImTextureID picture);
void draw_beside_legend(const Session& session, const Derived& derived, const Rect& rect);

/// The second picture right of a line that can be dragged, over the first one, which is drawn already. Whether the
/// pointer is at the line.
bool draw_beside_divider(Session& session, const Derived& derived, const Rect& rect, ImTextureID picture);

/// The choices of scale and colours for a depth picture, on the current line.
void depth_choices(Params& params, float right);

/// "24-bit, reversed".
std::string depth_title(DepthFormat format, DepthMapping mapping);

}  // namespace viewing
