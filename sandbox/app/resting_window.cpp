#include "app/resting_window.h"

#include <algorithm>
#include <cmath>

#include "ui/parts/topics.h"

namespace viewing {
namespace {

/// The longest that the user interface may need to come to rest: ImGui lays out in two frames, sections in one more.
constexpr int most_frames = 12;
/// Below half of its size type cannot be read any more.
constexpr double least_size = 0.5;

ViewName maximised(PictureView view) {
    if (view == PictureView::window) return ViewName::none;
    if (view == PictureView::matrices) return ViewName::matrices;
    return view == PictureView::camera ? ViewName::camera : ViewName::lower_left;
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

/// The window's sentence in the place of what a view shows, or what has to be said beforehand where nobody can click.
std::string nothing_to_show(PictureView view, const Params& params, const std::string& offered) {
    const bool wants_pixel = view == PictureView::cells || view == PictureView::pixel;
    const std::string name = picture_view_names[static_cast<std::size_t>(view)];
    if (wants_pixel && !params.view.pixel && !params.view.pin)
        return "the view " + name + " is of a pixel of the camera's picture, and none is pinned: view.pixel=[X,Y]";
    return "the view " + name + " has nothing to show: " + offered;
}

std::string size_text(glm::ivec2 size_px) {
    return std::to_string(size_px.x) + "x" + std::to_string(size_px.y);
}

}  // namespace

RestingWindow::RestingWindow(Renderer& renderer, const LoadedState& state, const Scene& scene,
                             std::optional<Color> ground)
    : studio_(renderer, Session(state, scene)) {
    if (ground) studio_.set_ground(*ground);
}

Status RestingWindow::settle() {
    Image last;
    for (int frame = 0; frame < most_frames; ++frame) {
        studio_.frame(surroundings_);
        if (studio_.session.message.is_error) return Error{studio_.session.message.text};
        Image picture = studio_.read();
        if (frame > 1 && picture == last && studio_.redraw_in_s() != 0.0) break;
        last = std::move(picture);
    }
    return std::monostate{};
}

Status RestingWindow::rest(const PictureRequest& request) {
    Workbench& workbench = studio_.workbench;
    workbench.arrangement.maximised = maximised(request.view);
    workbench.arrangement.bare = workbench.arrangement.maximised != ViewName::none;
    workbench.widgets.printed = workbench.arrangement.bare;
    ImGui::GetIO().MousePos = {-1e6F, -1e6F};  // the pointer is nowhere
    if (request.lesson) lead(studio_, *request.lesson);

    const double usual_scale = request.dpi / usual_dpi;
    double shrunk = 1.0;
    while (true) {
        surroundings_ = {.size_px = request.size_px, .device_scale = usual_scale * shrunk, .input = {}};
        if (Status settled = settle(); !settled) return settled;
        if (workbench.arrangement.bare && !workbench.widgets.offered.empty())
            return Error{nothing_to_show(request.view, studio_.session.params, workbench.widgets.offered)};
        const float seen = workbench.widgets.seen_share;
        if (!workbench.arrangement.bare || seen >= 1.0F) return std::monostate{};
        if (shrunk <= least_size) return Error{too_small(request.size_px)};
        // Lines that are broken need fewer of them where they are smaller: at most a tenth at once.
        shrunk = std::max(least_size, shrunk * std::clamp(static_cast<double>(seen), 0.9, 0.98));
    }
}

std::string RestingWindow::too_small(glm::ivec2 size_px) {
    const std::string told =
        "not all of the view can be seen in " + size_text(size_px) + " pixels, however small it is drawn; ";
    while (studio_.workbench.widgets.seen_share < 1.0F && surroundings_.size_px.y < largest_image_side) {
        const float wanted = static_cast<float>(surroundings_.size_px.y) / studio_.workbench.widgets.seen_share;
        surroundings_.size_px.y = std::min(largest_image_side, static_cast<int>(std::ceil(wanted / 10.0F)) * 10);
        if (!settle()) break;
    }
    return studio_.workbench.widgets.seen_share < 1.0F ? told + "nor in any picture of that width"
                                                       : told + size_text(surroundings_.size_px) + " has room for it";
}

Drawing RestingWindow::record() {
    ImGui::GetStyle().AntiAliasedLinesUseTex = false;
    studio_.frame(surroundings_);
    return studio_.record();
}

Topic topic_of(PictureView view, const Params& params) {
    struct Shown {
        PictureView view;
        Topic topic;
    };
    static constexpr Shown all[] = {{PictureView::observer, Topic::observer},
                                    {PictureView::shadow_derivation, Topic::shadow_derivation},
                                    {PictureView::mirror_derivation, Topic::mirror_derivation},
                                    {PictureView::tree, Topic::tree},
                                    {PictureView::order, Topic::order},
                                    {PictureView::precision, Topic::precision},
                                    {PictureView::codes, Topic::codes},
                                    {PictureView::histogram, Topic::histogram},
                                    {PictureView::cells, Topic::cells},
                                    {PictureView::pixel, Topic::pixel},
                                    {PictureView::fighting, Topic::fighting},
                                    {PictureView::passes, Topic::passes},
                                    {PictureView::moving_world, Topic::moving_world},
                                    {PictureView::from_light, Topic::from_light},
                                    {PictureView::mirror_ways, Topic::mirror_ways},
                                    {PictureView::lecture_code, Topic::lecture_code},
                                    {PictureView::display_code, Topic::display_code}};
    if (view == PictureView::derivation)
        return is_shown(params, Topic::mirror_derivation) ? Topic::mirror_derivation : Topic::shadow_derivation;
    for (const Shown& shown : all)
        if (shown.view == view) return shown.topic;
    return Topic::automatic;
}

}  // namespace viewing
