// The view of depth fighting: pair by pair what the formulas predict beside what was counted in the picture.
#pragma once

#include "frame/fighting_report.h"
#include "ui/layout.h"
#include "ui/session.h"

namespace viewing {

/// Null: nothing is known yet. In a scene without flat pairs it offers to open one that has some.
void draw_fighting_view(Session& session, const FightingReport* report, const Rect& rect);

}  // namespace viewing
