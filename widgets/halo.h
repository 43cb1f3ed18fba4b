// Where the halo of a text lies (HaloText, LabelPlacer): for the widgets that draw one, and for the recorder of
// figures, which finds it again.
#pragma once

#include <imgui.h>

namespace widgets {

/// The sides of the copies of a text that are its halo, in the order in which they are drawn; the text follows.
inline const ImVec2 halo_sides[8] = {{1, 0}, {1, -1}, {-1, 0}, {-1, -1}, {0, -1}, {0, 1}, {1, 1}, {-1, 1}};

}  // namespace widgets
