// The slides' two figures with the numbers of now: the plane seen edge-on, and what is derived on both sides of it.
// Read derivation_views.h for what stands beside them.
#pragma once

#include "frame/planes/derivation.h"
#include "ui/parts/layout.h"

namespace viewing {

/// The plane through light and point that stands upright on the plane: l, p and s, the similar triangles between them,
/// heights and lengths along the ray. The light is always above. What is shown does not depend on l_w, as long as s
/// stays near: as l_w falls the light leaves at the top, and the ray comes in from above. Nothing farther from p than
/// `farthest_world` is shown.
void draw_shadow_diagram(const Rect& rect, const ShadowDerivation& derivation, double farthest_world);

/// q, its foot and q′, with k on both sides; a wall stands upright.
void draw_mirror_diagram(const Rect& rect, const MirrorDerivation& derivation);

}  // namespace viewing
