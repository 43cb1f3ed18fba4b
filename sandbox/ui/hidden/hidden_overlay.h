// The overlays of the hidden-surface methods over the camera's and the observer's picture.
#pragma once

#include "session/session.h"
#include "ui/hidden/polygon_links.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Draws over the camera's picture: polygon numbers, the linked polygon, and the pair, pixel, or ray of the step.
void draw_hidden_overlay(const PolygonLink& link, const Session& session, const HiddenStatus& hidden, Overlay& overlay);

/// Converts a screen position in the camera's picture to a pixel of the method's; nullopt outside it, or if there is
/// none.
std::optional<glm::ivec2> method_pixel_at(const HiddenStatus& hidden, const Overlay& overlay, ImVec2 place);

/// Follows this pixel from now on, or stops following it if it is the followed one. If each step traces a single ray,
/// goes to the step of the pixel's ray instead.
void choose_pixel(VisibilityParams& visibility, const HiddenResult& result, glm::ivec2 pixel);

/// Returns the index in `fragments` of the polygon visible at a screen position in the camera's picture; −1: none, or
/// unknown.
int fragment_at(const HiddenStatus& hidden, const Overlay& overlay, ImVec2 pointed);

/// Draws over the observer's picture: the linked polygon, its node's plane and half-spaces, and the ray of the step.
void draw_hidden_observer(const PolygonLink& link, const HiddenStatus& hidden, Overlay& overlay);

}  // namespace viewing
