// Placement of a text's halo (HaloText, LabelPlacer): for the widgets that draw one, and for the recorder of figures,
// which recognizes it.
#pragma once

#include <imgui.h>

namespace widgets {

/// Offsets of the text copies that form its halo, in drawing order. The text follows.
inline const ImVec2 halo_sides[8] = {{1, 0}, {1, -1}, {-1, 0}, {-1, -1}, {0, -1}, {0, 1}, {1, 1}, {-1, 1}};

}  // namespace widgets
