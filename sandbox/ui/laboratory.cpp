// What goes on in the laboratory between frames.
#include "ui/laboratory.h"

#include <algorithm>

namespace viewing {

void take_background_results(LaboratoryState& state, Session& session) {
    const std::optional<FailureView> found = state.failure_search.take();
    if (!found) return;
    session.message = {found->sentence, false};
    if (!found->found) return;
    CameraParams& camera = session.params.camera;
    camera.position = found->position_world;
    camera.yaw = found->view.yaw_deg;
    camera.pitch = found->view.pitch_deg;
    camera.roll = 0.0;
}

void keep_selection(LaboratoryState& state, const HiddenStatus& hidden) {
    const auto fragments = hidden.answer ? hidden.answer->camera->fragments : nullptr;
    if (fragments == state.linked_fragments) return;
    PolygonLink& link = state.link;
    const auto selected = static_cast<std::size_t>(link.selected_fragment);
    const bool was_selected =
        state.linked_fragments && link.selected_fragment >= 0 && selected < state.linked_fragments->size();
    const int source = was_selected ? (*state.linked_fragments)[selected].source : -1;
    link = {};
    if (fragments && was_selected) {
        const auto same = std::ranges::find(*fragments, source, &Polygon::source);
        if (same != fragments->end()) link.selected_fragment = static_cast<int>(same - fragments->begin());
    }
    state.next_link = link;
    state.linked_fragments = fragments;
}

}  // namespace viewing
