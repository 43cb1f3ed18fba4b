// The tree of a BSP build and the order in which polygons are drawn, linked with the pictures.
#include "ui/laboratory.h"

namespace viewing {

void draw_tree_view(LaboratoryState&, const HiddenStatus&, const Rect&) {}
void draw_order_view(LaboratoryState&, const HiddenStatus&, const Rect&) {}

}  // namespace viewing
