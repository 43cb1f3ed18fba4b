// The order in which polygons are drawn as a view of its own.
#pragma once

#include "session/session.h"
#include "ui/hidden/polygon_links.h"
#include "ui/parts/layout.h"

namespace viewing {

struct OrderViewState {
    int revealed = -1;  ///< the fragment that the list was last scrolled to, as it was selected
    int current = -1;   ///< the place in the order that it was last scrolled to, as the step reached it
};

void draw_order_view(OrderViewState& state, PolygonLinks& links, Session& session, const HiddenStatus& hidden,
                     const Rect& rect);

}  // namespace viewing
