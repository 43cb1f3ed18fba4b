#include "app/picture.h"

#include "app/resting_window.h"
#include "image/image_size.h"
#include "topics/hidden/measured/camera_picture.h"

namespace viewing {
namespace {

/// Draws the user interface, or the requested part of it.
Result<Image> draw_window(Renderer& renderer, const LoadedState& state, const Scene& scene,
                          const PictureRequest& request, std::optional<Color> ground) {
    RestingWindow window(renderer, state, scene, ground);
    if (Status rests = window.rest(request); !rests) return Error{rests.error()};
    return window.read();
}

Result<Image> draw_on(Renderer& renderer, const LoadedState& state, const Scene& scene, const PictureRequest& request,
                      std::optional<Color> ground) {
    if (is_drawn_by_gl(request)) return camera_picture(renderer, state.params, scene, request.size_px, ground);
    return draw_window(renderer, state, scene, request, ground);
}

/// Sets the window's ImGui context aside while another studio draws.
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
        growth.wants_picture = frame == most_frames - 2;  // the layout has settled by then
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
    if (request.view == PictureView::depth) params.view.shows = Shows::depth;
    if (request.view == PictureView::stencil) params.view.shows = Shows::stencil;
    if (const Topic topic = topic_of(request.view, params); topic != Topic::automatic) {
        params.view.lower_left = topic;
        if (params.view.lower_right == topic) params.view.lower_right = Topic::automatic;
    }
    return params;
}

Status check_picture_size(PictureView view, glm::ivec2 size_px) {
    constexpr glm::ivec2 smallest_window_px{320, 240};
    if (!is_image_size(size_px.x, size_px.y)) return Error{image_size_rule()};
    const bool is_interface = view == PictureView::window || view > PictureView::observer;
    if (is_interface && (size_px.x < smallest_window_px.x || size_px.y < smallest_window_px.y))
        return Error{"the window and its views need at least " + std::to_string(smallest_window_px.x) + "x" +
                     std::to_string(smallest_window_px.y) + " pixels; the camera view can be smaller"};
    return std::monostate{};
}

bool is_drawn_by_gl(const PictureRequest& request) {
    const bool is_plain = request.view == PictureView::camera && !request.labels;
    return is_plain || request.view == PictureView::depth || request.view == PictureView::stencil;
}

Result<Image> draw_picture(Renderer& renderer, const LoadedState& state, const Scene& scene,
                           const PictureRequest& request) {
    return drawn_without_ground(state, request, [&](const LoadedState& wanted, std::optional<Color> ground) {
        return draw_on(renderer, wanted, scene, request, ground);
    });
}

}  // namespace viewing
