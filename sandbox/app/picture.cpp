#include "app/picture.h"

#include "app/studio.h"
#include "measure/hidden_answers.h"

namespace viewing {
namespace {

/// The longest that the user interface may need to come to rest: ImGui lays out in two frames, sections in one more.
constexpr int most_frames = 12;

Result<Image> draw_window(Renderer& renderer, const LoadedState& state, const Scene& scene,
                          const PictureRequest& request, ViewName maximised) {
    Studio studio(renderer, Session(state, scene));
    studio.workbench.arrangement.maximised = maximised;
    studio.workbench.arrangement.bare = maximised != ViewName::none;
    ImGui::GetIO().MousePos = {-1e6F, -1e6F};
    const Studio::Surroundings surroundings{.size_px = request.size_px, .input = {}};
    Image last, picture;
    for (int frame = 0; frame < most_frames; ++frame) {
        studio.frame(surroundings);
        if (studio.session.message.is_error) return Error{studio.session.message.text};
        picture = studio.read();
        if (frame > 1 && picture == last && studio.redraw_in_s() != 0.0) break;
        last = std::move(picture);
        picture = last;
    }
    return picture;
}

}  // namespace

Result<Image> draw_picture(Renderer& renderer, const LoadedState& state, const Scene& scene,
                           const PictureRequest& request) {
    LoadedState wanted = state;
    if (request.samples) wanted.params.view.samples = *request.samples;
    if (request.view == PictureView::window) return draw_window(renderer, wanted, scene, request, ViewName::none);
    if (request.view == PictureView::observer) {
        wanted.params.view.lower_left = Topic::observer;
        return draw_window(renderer, wanted, scene, request, ViewName::lower_left);
    }
    if (request.view == PictureView::depth) wanted.params.view.shows = Shows::depth;
    if (request.view == PictureView::stencil) wanted.params.view.shows = Shows::stencil;

    const Viewport viewport{request.size_px, renderer.capabilities().clip_control};
    const Result<FramePlan> frame =
        plan_at_once(renderer, wanted.params, derive(wanted.params, scene, viewport), scene, request.size_px);
    if (!frame) return Error{frame.error()};
    View view;
    if (Status drawn = renderer.draw(*frame, scene, request.size_px, view); !drawn) return Error{drawn.error()};
    return renderer.read(view);
}

}  // namespace viewing
