#include "app/picture.h"

#include "app/studio.h"
#include "measure/camera_picture.h"

namespace viewing {
namespace {

/// The longest that the user interface may need to come to rest: ImGui lays out in two frames, sections in one more.
constexpr int most_frames = 12;

/// One view alone, or the whole window; the pointer is nowhere.
void show(Studio& studio, ViewName maximised) {
    studio.workbench.arrangement.maximised = maximised;
    studio.workbench.arrangement.bare = maximised != ViewName::none;
    ImGui::GetIO().MousePos = {-1e6F, -1e6F};
}

void lead(Studio& studio, const LessonPicture& wanted) {
    Guide& guide = studio.workbench.guide;
    guide.begin(wanted.lesson, wanted.step, studio.session);
    if (wanted.revealed) {
        guide.reveal(studio.session);
        guide.next(studio.session);  // at once
    }
    if (wanted.presents) studio.workbench.presenter.begin();
    studio.workbench.arrangement.has_strip = wanted.has_strip;
    studio.session.finish_loading();
}

Result<Image> draw_window(Renderer& renderer, const LoadedState& state, const Scene& scene,
                          const PictureRequest& request, ViewName maximised) {
    Studio studio(renderer, Session(state, scene));
    show(studio, maximised);
    if (request.lesson) lead(studio, *request.lesson);
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

/// ImGui's context of the window, out of the way of another studio's.
class OtherContext {
public:
    OtherContext() { ImGui::SetCurrentContext(nullptr); }
    ~OtherContext() { ImGui::SetCurrentContext(of_window_); }
    OtherContext(const OtherContext&) = delete;
    OtherContext& operator=(const OtherContext&) = delete;

private:
    ImGuiContext* of_window_ = ImGui::GetCurrentContext();
};

}  // namespace

Result<Image> draw_growth_chart(Renderer& renderer, const Session& session, const GrowthViewState& shown) {
    constexpr glm::ivec2 size_px(1920, 1200);
    LoadedState state;
    state.params.scene = session.params.scene;
    state.params.coplanar = session.params.coplanar;
    state.params.ui = session.params.ui;
    state.params.ui.scale = 2.0;
    state.params.view.lower_left = Topic::growth;
    const OtherContext apart;
    Studio studio(renderer, Session(state, session.scene()));
    show(studio, ViewName::lower_left);
    GrowthViewState& growth = studio.workbench.views.hidden.growth;
    growth.rows = shown.rows;
    growth.scene = shown.scene;
    growth.of_version = studio.session.scene_version();
    growth.shows_operations = shown.shows_operations;
    const Studio::Surroundings surroundings{.size_px = size_px, .input = {}};
    for (int frame = 0; frame < most_frames; ++frame) {
        growth.wants_picture = frame == most_frames - 2;  // everything has its place by then
        const Requests requests = studio.frame(surroundings);
        if (!requests.view_picture) continue;
        const Rect& rect = requests.view_picture->rect;
        return cropped(studio.read(), static_cast<int>(rect.min.x), static_cast<int>(rect.min.y),
                       static_cast<int>(rect.max.x), static_cast<int>(rect.max.y));
    }
    return Error{studio.session.message.text};
}

LoadedState show_step(LessonPicture step, PictureRequest& request) {
    const LessonStep& shown = step.lesson.steps[step.step];
    LoadedState state = shown.start;
    if (request.view == PictureView::window)
        request.lesson = std::make_shared<const LessonPicture>(std::move(step));
    else if (step.revealed)
        state.params = shown.revealed;
    return state;
}

Params drawn_params(Params params, const PictureRequest& request) {
    if (request.samples) params.view.samples = *request.samples;
    if (request.view == PictureView::observer) params.view.lower_left = Topic::observer;
    if (request.view == PictureView::depth) params.view.shows = Shows::depth;
    if (request.view == PictureView::stencil) params.view.shows = Shows::stencil;
    return params;
}

Result<Image> draw_picture(Renderer& renderer, const LoadedState& state, const Scene& scene,
                           const PictureRequest& request) {
    LoadedState wanted = state;
    wanted.params = drawn_params(state.params, request);
    if (request.view == PictureView::window) return draw_window(renderer, wanted, scene, request, ViewName::none);
    if (request.view == PictureView::observer)
        return draw_window(renderer, wanted, scene, request, ViewName::lower_left);

    return camera_picture(renderer, wanted.params, scene, request.size_px);
}

}  // namespace viewing
