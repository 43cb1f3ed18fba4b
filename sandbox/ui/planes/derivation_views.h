// The lecture's derivations of shadow and mirror image, live, as views: a figure, and the steps with the numbers of
// now. Read derivation_diagram.h and derivation_text.h for the two halves, frame/planes/derivation.h for the numbers.
#pragma once

#include "frame/derive.h"
#include "session/session.h"
#include "ui/parts/overlay.h"
#include "widgets/diagrams.h"

namespace viewing {

/// s = l + t (p − l) step by step for the followed point, l_w to slide from point to parallel light, and the same
/// matrix S three times. Steps are those of view.derivation_step.
void draw_shadow_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player);

/// q′ = q − 2 k n, its expansion, and R.
void draw_mirror_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player);

/// What is derived, in the world: light, point, shadow and feet with the similar triangles between them, or the mirror
/// image with k. While neither derivation is shown, the followed point alone (draw_followed).
void draw_derivation_overlay(Overlay& overlay, const Params& params, const Derived& derived);

}  // namespace viewing
