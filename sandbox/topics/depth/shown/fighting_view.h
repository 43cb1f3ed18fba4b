// The view of depth fighting: for each pair of surfaces, the predicted fraction of wrong pixels beside the counted one.
#pragma once

#include "session/session.h"
#include "topics/depth/numbers/fighting_report.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Draws the view. `report` is null until there are results. If no two flat surfaces of the scene are nearly coplanar,
/// offers to open a scene where some are.
void draw_fighting_view(Session& session, const FightingReport* report, const Rect& rect);

}  // namespace viewing
