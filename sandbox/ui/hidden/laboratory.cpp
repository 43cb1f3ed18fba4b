// What goes on in the laboratory between frames.
#include "ui/hidden/laboratory.h"

#include <algorithm>

namespace viewing {

namespace {

/// Nothing is moved when the person has gone on to something else, or has stopped the search.
void take_failure(LaboratoryState& state, Session& session) {
    const Params& now = session.params;
    const LaboratoryState::FailureAsked asked{session.scene_version(), now.visibility, now.camera, now.projection};
    if (!state.failure_search.is_running()) return;
    if (asked != state.failure_asked) state.failure_search.cancel();
    const std::optional<FailureView> found = state.failure_search.take();
    if (!found || found->cancelled || asked != state.failure_asked) return;
    session.message = {found->sentence, false};
    if (!found->found) return;
    CameraParams& camera = session.params.camera;
    camera.position = found->position_world;
    camera.yaw = found->view.yaw_deg;
    camera.pitch = found->view.pitch_deg;
    camera.roll = 0.0;
}

}  // namespace

void begin_laboratory_frame(LaboratoryState& state, const Session& session) {
    state.scene_version = session.scene_version();
    if (session.params.visibility.step != state.last_step) state.playing = false;
    state.last_step = session.params.visibility.step;
    state.has_step_bar = false;
}

void end_laboratory_frame(LaboratoryState& state, Session& session) {
    if (!state.has_step_bar) state.playing = false;
    take_failure(state, session);
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
        const auto same = std::find_if(fragments->begin(), fragments->end(),
                                       [&](const Polygon& fragment) { return fragment.source == source; });
        if (same != fragments->end()) link.selected_fragment = static_cast<int>(same - fragments->begin());
    }
    state.next_link = link;
    state.linked_fragments = fragments;
}

}  // namespace viewing
