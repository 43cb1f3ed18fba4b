// Draws the depth buffer as a picture below the camera view, and a histogram of depths.
#pragma once

#include "frame/derive.h"
#include "frame/pixel_report.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Draws the depth buffer below the camera view, with a legend of its colors. Adds the choices of depth scale and depth
/// colors to the header line.
void draw_depth_picture(Session& session, const Derived& derived, const Rect& rect, ImTextureID picture);

/// Draws a histogram of the depths in the camera's picture. The histogram's two lines set the range that depth pictures
/// show.
void draw_histogram_view(Session& session, const Derived& derived, const DepthCounts& counts, const Rect& rect);

/// Draws the legend of a depth buffer's colors over its picture. If there is no depth to show, also says why.
void depth_picture_legend(const Session& session, const Derived& derived, const Rect& rect);

/// Draws the choices of depth scale and depth colors on the current line, up to `right`.
void depth_choices(Params& params, float right);

/// The title of a depth buffer: "24-bit, reversed".
std::string depth_title(DepthFormat format, DepthMapping mapping);

}  // namespace viewing
