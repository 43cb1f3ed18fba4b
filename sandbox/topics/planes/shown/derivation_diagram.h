// The slides' two figures with the current numbers, as cross-sections that show the plane edge-on. See
// derivation_views.h for the text beside them.
#pragma once

#include "topics/planes/numbers/derivation.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Draws the cross-section through the light and the point, perpendicular to the plane. It shows l, p and s, the
/// similar triangles between them, the heights, and the lengths along the ray. The figure always shows the light above
/// the plane. While s is near, the visible region does not depend on l_w: as l_w falls, the light leaves the figure at
/// the top, and the ray enters from above. The figure follows the ray no farther than `farthest_world` from p.
void draw_shadow_diagram(const Rect& rect, const ShadowDerivation& derivation, double farthest_world);

/// Draws q, its foot and q′, with k on both sides. A vertical plane is drawn upright.
void draw_mirror_diagram(const Rect& rect, const MirrorDerivation& derivation);

}  // namespace viewing
