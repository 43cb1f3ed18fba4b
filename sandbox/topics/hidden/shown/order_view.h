// The view of the order in which polygons are drawn.
#pragma once

#include "session/session.h"
#include "topics/hidden/shown/polygon_links.h"
#include "ui/parts/layout.h"

namespace viewing {

struct OrderViewState {
    int revealed = -1;  ///< the selected fragment to which the list last scrolled
    int current = -1;   ///< the step's place to which the list last scrolled
};

void draw_order_view(OrderViewState& state, PolygonLinks& links, Session& session, const HiddenStatus& hidden,
                     const Rect& rect);

}  // namespace viewing
