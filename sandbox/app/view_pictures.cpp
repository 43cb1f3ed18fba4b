#include "app/view_pictures.h"

#include <algorithm>
#include <span>

#include "state/file/beside.h"
#include "topics/hidden/measured/hidden_answers.h"
#include "topics/planes/measured/mirror_measure.h"
#include "ui/views/lower_view.h"

namespace viewing {
namespace {

ImTextureID texture_id(const View& view) {
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(view.texture()));
}

template <std::size_t count>
std::array<ImTextureID, count> texture_ids(const std::array<View, count>& views) {
    std::array<ImTextureID, count> ids{};
    std::transform(views.begin(), views.end(), ids.begin(), texture_id);
    return ids;
}

/// Returns the step pictures if GL alone draws the current method; otherwise none.
HiddenPictures pictures_by_gl(const ShownFrame& shown) {
    const bool has_steps = shown.hidden && is_drawn_by_gl_alone(shown.params.visibility.method);
    return has_steps ? shown.hidden->pictures : HiddenPictures{};
}

}  // namespace

Status ViewPictures::render(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view) {
    if (!background_) return renderer_.draw(plan, scene, size_px, view);
    FramePlan on_background = plan;
    on_background.background = *background_;
    return renderer_.draw(on_background, scene, size_px, view);
}

Status ViewPictures::draw_camera(const ShownFrame& shown, const Scene& scene, const Layout& layout) {
    if (layout.camera.empty()) return std::monostate{};
    return render(shown.plan, scene, layout.camera.size_px(), camera_);
}

Status ViewPictures::draw_unseen_camera(const ShownFrame& shown, const Scene& scene) {
    return render(shown.plan, scene, shown.camera_px, camera_);
}

Status ViewPictures::draw_beside(const ShownFrame& shown, const Scene& scene, const Layout& layout) {
    const BesideParams& beside = shown.params.view.beside;
    const glm::ivec2 size = layout.camera.size_px();
    if (beside.shows == Beside::nothing || layout.camera.empty()) return std::monostate{};
    if (beside.shows == Beside::depth) return draw_depth(shown, scene, size, beside_);
    const Params other = beside_params(shown.params);
    const Derived derived = derive(other, scene, renderer_.viewport(size));
    if (beside.shows == Beside::other_depth)
        return render(plan(other, derived, pictures_by_gl(shown)), scene, size, beside_);
    Result<FramePlan> frame = plan_at_once(renderer_, other, derived, scene, size);
    return frame ? render(*frame, scene, size, beside_) : Status(Error{frame.error()});
}

Status ViewPictures::draw_depth(const ShownFrame& shown, const Scene& scene, glm::ivec2 size_px, View& view) {
    Params params = shown.params;
    params.view.shows = Shows::depth;
    const Derived derived = derive(params, scene, renderer_.viewport(size_px));
    FramePlan frame = plan(params, derived, pictures_by_gl(shown));
    frame.shown_range = contrast_range(params, derived, scene);
    return render(frame, scene, size_px, view);
}

Status ViewPictures::draw_after_pass(const ShownFrame& shown, const Scene& scene, glm::ivec2 size_px) {
    static constexpr Shows buffers[] = {Shows::color, Shows::depth, Shows::stencil};
    FramePlan frame = shown.inspected;
    frame.shown_range = contrast_range(shown.params, shown.derived, scene);
    frame.samples = 0;
    for (std::size_t buffer = 0; buffer < after_pass_.size(); ++buffer) {
        frame.shows = buffers[buffer];
        if (Status done = render(frame, scene, size_px, after_pass_[buffer]); !done) return done;
    }
    return std::monostate{};
}

Status ViewPictures::draw_mirror_ways(const ShownFrame& shown, const Scene& scene) {
    // Small enough to keep up while a light or a plane is dragged.
    constexpr int most_px = 480;
    const double shrunk = std::min(1.0, static_cast<double>(most_px) / std::max(shown.camera_px.x, shown.camera_px.y));
    const glm::ivec2 size_px = glm::max(glm::ivec2(glm::dvec2(shown.camera_px) * shrunk), 1);
    Result<MirrorWays> ways = compare_mirror_ways(renderer_, shown.params, scene, size_px, &mirror_way_views_);
    if (!ways) return Error{ways.error()};
    mirror_ways_ = std::make_shared<const MirrorWays>(*ways);
    return std::monostate{};
}

Status ViewPictures::draw_lower(Slot slot, const ShownFrame& shown, const Scene& scene, const Layout& layout) {
    const Rect& rect = slot == Slot::left ? layout.lower_left : layout.lower_right;
    if (rect.empty()) return std::monostate{};
    const LowerView& lower = lower_view(shown.params, slot);
    View& view = lower_[slot];
    if (lower.camera) {
        const ObserverView camera = lower.camera(shown.params, shown.derived, scene, rect);
        return render(plan_observer(shown.params, shown.derived, camera), scene, rect.size_px(), view);
    }
    switch (lower.picture) {
        case LowerPicture::depth_buffer:
            return draw_depth(shown, scene, rect.size_px(), view);
        case LowerPicture::after_pass:
            return draw_after_pass(shown, scene, pass_picture_size(rect, shown.derived.aspect));
        case LowerPicture::mirror_ways:
            return draw_mirror_ways(shown, scene);
        case LowerPicture::none:
            break;  // the user interface draws the whole view
    }
    return std::monostate{};
}

Status ViewPictures::draw(const ShownFrame& shown, const Scene& scene, const Layout& layout) {
    if (Status done = draw_camera(shown, scene, layout); !done) return done;
    if (Status done = draw_beside(shown, scene, layout); !done) return done;
    if (Status done = draw_lower(Slot::left, shown, scene, layout); !done) return done;
    return draw_lower(Slot::right, shown, scene, layout);
}

const View* ViewPictures::view_of(ImTextureID texture) const {
    const auto among = [texture](std::span<const View> views) -> const View* {
        for (const View& view : views)
            if (texture_id(view) == texture) return &view;
        return nullptr;
    };
    for (const std::span<const View> views :
         {std::span(&camera_, 1), std::span(&beside_, 1), std::span<const View>(lower_),
          std::span<const View>(mirror_way_views_), std::span<const View>(after_pass_)})
        if (const View* const view = among(views)) return view;
    return nullptr;
}

Pictures ViewPictures::textures() const {
    Pictures pictures;
    pictures.camera = texture_id(camera_);
    pictures.beside = texture_id(beside_);
    pictures.lower = texture_ids(lower_);
    pictures.passes = texture_ids(after_pass_);
    pictures.mirror_ways = {texture_ids(mirror_way_views_), mirror_ways_};
    return pictures;
}

}  // namespace viewing
