// What the hidden-surface methods draw over the pictures.
#pragma once

#include "session/session.h"
#include "ui/hidden/polygon_links.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Over the camera's picture: polygon numbers, the linked polygon, the pair, pixel or ray of the step.
void draw_hidden_overlay(const PolygonLink& link, const Session& session, const HiddenStatus& hidden, Overlay& overlay);

/// The pixel of the method's picture at a place of the camera's; none beside it, or without a picture.
std::optional<glm::ivec2> method_pixel_at(const HiddenStatus& hidden, const Overlay& overlay, ImVec2 place);

/// That pixel is followed from now on, or let go when it was already. While rays are gone through one by one, its ray
/// becomes the step.
void choose_pixel(VisibilityParams& visibility, const HiddenResult& result, glm::ivec2 pixel);

/// The polygon of `fragments` that is seen at a place of the camera's picture; −1: none, or not known.
int fragment_at(const HiddenStatus& hidden, const Overlay& overlay, ImVec2 pointed);

/// Over the observer's picture: the linked polygon, its node's plane and half-spaces, the ray of the step.
void draw_hidden_observer(const PolygonLink& link, const HiddenStatus& hidden, Overlay& overlay);

}  // namespace viewing
