// The overlays that the hidden-surface methods draw over the camera's and the observer's pictures.
#pragma once

#include "session/session.h"
#include "topics/hidden/shown/polygon_links.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Draws over the camera's picture: polygon numbers, the linked polygon, and the pair, pixel, or ray of the step.
void draw_hidden_overlay(const PolygonLink& link, const Session& session, const HiddenStatus& hidden, Overlay& overlay);

/// Converts a screen position in the camera's picture to a pixel of the method's picture. Returns nullopt if the
/// position is outside that picture or if there is no such picture.
std::optional<glm::ivec2> method_pixel_at(const HiddenStatus& hidden, const Overlay& overlay, ImVec2 place);

/// Follows this pixel from now on, or stops following it if it is followed already. While ray casting is shown step by
/// step, goes instead to the step that traces this pixel's ray.
void choose_pixel(VisibilityParams& visibility, const HiddenResult& result, glm::ivec2 pixel);

/// Returns the index in `fragments` of the polygon visible at a screen position in the camera's picture; −1 if there is
/// none or it is unknown.
int fragment_at(const HiddenStatus& hidden, const Overlay& overlay, ImVec2 pointed);

/// Draws over the observer's picture: the linked polygon, the plane of the linked node or of the step's node, the
/// polygons on either side of that plane, and the step's ray.
void draw_hidden_observer(const PolygonLink& link, const HiddenStatus& hidden, Overlay& overlay);

}  // namespace viewing
