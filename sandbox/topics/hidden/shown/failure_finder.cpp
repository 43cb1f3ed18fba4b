#include "topics/hidden/shown/failure_finder.h"

#include <algorithm>

#include "text/catalogue.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

FailureFinder::Asked asked_now(const Session& session) {
    const Params& params = session.params;
    return {session.scene_version(), params.visibility, params.camera, params.projection};
}

void start(FailureFinder& finder, const Session& session, const HiddenResult& result) {
    const CameraParams& camera = session.params.camera;
    const Orbit orbit{camera.target, std::max(1e-3, glm::distance(camera.position, camera.target)),
                      result.request.viewpoint.clip_from_view};
    finder.asked = asked_now(session);
    const FailureSearchOptions options{.key = session.params.visibility.sort_key, .start = {camera.yaw, camera.pitch}};
    finder.search.start([surface = result.surface, orbit, options](WorkProgress& progress) {
        return find_failure(surface->polygons, orbit, options, &progress);
    });
}

}  // namespace

void draw_failure_finder(FailureFinder& finder, const Session& session, const HiddenResult& result) {
    if (finder.search.is_running()) {
        ImGui::ProgressBar(finder.search.fraction(), {px(150.0F), 0.0F}, tr("searching"));
        ImGui::SameLine();
        if (widgets::SmallButton("Stop")) finder.search.cancel();
        return;
    }
    ImGui::BeginDisabled(session.params.cull.enabled);
    if (widgets::SmallButton("Find a view where this key fails")) start(finder, session, result);
    widgets::Tooltip("Find a view where this key fails",
                     "Orbits the camera about its target to the view where the painter's picture differs from that of "
                     "ray casting in the most pixels. All faces count, so culling must be off.");
    ImGui::EndDisabled();
}

void take_failure(FailureFinder& finder, Session& session) {
    if (!finder.search.is_running()) return;
    const bool is_still_asked = asked_now(session) == finder.asked;
    if (!is_still_asked) finder.search.cancel();
    const std::optional<Result<FailureView>> taken = finder.search.take();
    if (!taken || !is_still_asked) return;
    if (!*taken) return session.report(Error{taken->error()});
    const FailureView* const found = &**taken;
    if (found->canceled) return;
    session.message = {say(found->sentence), false};
    if (!found->found) return;
    CameraParams& camera = session.params.camera;
    camera.position = found->position_world;
    camera.yaw = found->view.yaw_deg;
    camera.pitch = found->view.pitch_deg;
    camera.roll = 0.0;
}

}  // namespace viewing
