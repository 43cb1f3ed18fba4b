// "Why this pixel?": the lower view that explains the pinned pixel row by row, and its lines in the camera's and the
// observer's views. See topics/why/numbers/why.h for the explanation.
#pragma once

#include <memory>

#include "frame/pinned_pixel.h"
#include "session/session.h"
#include "topics/why/numbers/why.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// The explanation that the views draw; persists between frames.
struct WhyState {
    std::shared_ptr<const Why> told;                  ///< null while no view explains a pixel
    std::optional<std::size_t> hovered_row;           ///< only this row's lines are drawn
    bool hides_shadow = false, hides_mirror = false;  ///< what the view's buttons have switched off
};

/// Draws the explanation, with buttons that show the picture without its shadow or mirror image, or only up to a pass.
/// Without a pixel, says how to choose one; `pinned` may say why the pinned point is not visible.
void draw_why_view(WhyState& state, Session& session, const PinnedPixel& pinned, const Rect& rect);

/// Draws the ray, the mirrored path and the rays of the lights, unless a lesson covers the explanation.
void draw_why_overlay(const WhyState& state, Overlay& overlay);

}  // namespace viewing
