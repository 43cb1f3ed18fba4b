// The view of depth fighting: pair by pair what the formulas predict beside what was counted in the picture.
#pragma once

#include "frame/depth/fighting_report.h"
#include "session/session.h"
#include "ui/parts/layout.h"

namespace viewing {

/// Null: nothing is known yet. In a scene without flat pairs it offers to open one that has some.
void draw_fighting_view(Session& session, const FightingReport* report, const Rect& rect);

}  // namespace viewing
