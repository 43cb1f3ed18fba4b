// What the hidden-surface methods draw over the pictures.
#pragma once

#include "session/session.h"
#include "ui/hidden/polygon_links.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Over the camera's picture: polygon numbers, the linked polygon, the pair, pixel or ray of the step.
void draw_hidden_overlay(const PolygonLink& link, const Session& session, const HiddenStatus& hidden, Overlay& overlay);

/// The polygon of `fragments` that is seen at a pixel of the camera's picture; −1: none, or not known.
int fragment_at(const HiddenStatus& hidden, const Overlay& overlay, glm::ivec2 pixel);

/// Over the observer's picture: the linked polygon, its node's plane and half-spaces, the ray of the step.
void draw_hidden_observer(const PolygonLink& link, const HiddenStatus& hidden, Overlay& overlay);

}  // namespace viewing
