// The lecture's derivations of shadow and mirror image as live views: a figure, and the steps with the current numbers.
// See derivation_diagram.h and derivation_text.h for the two halves, and topics/planes/numbers/derivation.h for the
// numbers.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/overlay.h"
#include "widgets/diagrams.h"

namespace viewing {

/// Derives s = l + t (p − l) step by step for the followed point, up to the step in view.derivation_step. Also draws a
/// slider for l_w, which turns a parallel light into a point light, and the three forms of S.
void draw_shadow_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player);

/// Derives q′ = q − 2 k n, expands it, and draws R.
void draw_mirror_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player);

/// Draws the current derivation's figure into the world. For the shadow, draws the light's ray, the point, its shadow,
/// the feet of the perpendiculars to the plane, and the similar triangles. For the mirror image, draws the point, its
/// image, and their distance k from the plane. If neither derivation is shown, draws only the followed point
/// (draw_followed).
void draw_derivation_overlay(Overlay& overlay, const Params& params, const Derived& derived);

}  // namespace viewing
