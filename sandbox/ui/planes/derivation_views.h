// The lecture's derivations of shadow and mirror image as live views: a figure, and the steps with the current numbers.
// Read derivation_diagram.h and derivation_text.h for the two halves, and frame/planes/derivation.h for the numbers.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/overlay.h"
#include "widgets/diagrams.h"

namespace viewing {

/// Draws s = l + t (p − l) step by step for the followed point, a slider for l_w from parallel to point light, and the
/// three forms of S. Stops at the step in view.derivation_step.
void draw_shadow_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player);

/// Draws q′ = q − 2 k n, its expansion, and R.
void draw_mirror_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player);

/// Draws the current derivation's figure into the world: the ray, the point, its shadow and the feet, with the similar
/// triangles between them, or the mirror image with k. If neither derivation is shown, draws only the followed point
/// (draw_followed).
void draw_derivation_overlay(Overlay& overlay, const Params& params, const Derived& derived);

}  // namespace viewing
