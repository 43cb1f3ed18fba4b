#include "topics/hidden/shown/polygon_links.h"

#include <algorithm>

namespace viewing {

void keep_selection(PolygonLinks& links, const HiddenStatus& hidden) {
    const auto fragments = hidden.answer ? hidden.answer->camera->fragments : nullptr;
    if (fragments == links.fragments) return;
    const auto selected = static_cast<std::size_t>(links.now.selected_fragment);
    const bool was_selected = links.fragments && links.now.selected_fragment >= 0 && selected < links.fragments->size();
    const int source = was_selected ? (*links.fragments)[selected].source : -1;
    links.now = {};
    if (fragments && was_selected) {
        const auto same = std::find_if(fragments->begin(), fragments->end(),
                                       [&](const Polygon& polygon) { return polygon.source == source; });
        if (same != fragments->end()) links.now.selected_fragment = static_cast<int>(same - fragments->begin());
    }
    links.next = links.now;
    links.fragments = fragments;
}

void take_links(PolygonLinks& links) {
    links.now = links.next;
    links.next.hovered_fragment = links.next.hovered_node = -1;
}

}  // namespace viewing
