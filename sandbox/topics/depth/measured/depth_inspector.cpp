#include "topics/depth/measured/depth_inspector.h"

#include <algorithm>
#include <utility>

#include "topics/depth/numbers/reconcile.h"

namespace viewing {
namespace {

/// Returns the top left pixel of a block that is centered on the pixel, unless the picture's edges force the block to
/// shift.
glm::ivec2 first_pixel_of(glm::ivec2 pixel, glm::ivec2 cells, glm::ivec2 size_px) {
    return glm::clamp(pixel - cells / 2, glm::ivec2(0), glm::max(size_px - cells, glm::ivec2(0)));
}

/// Returns the fragment that the last triangle of a limited frame produces at the pixel.
std::optional<Fragment> latest_of(const std::vector<Fragment>& fragments, const DrawCall& call, int triangle) {
    const auto found = std::find_if(fragments.begin(), fragments.end(), [&](const Fragment& fragment) {
        return fragment.pass == call.pass && std::max(fragment.object_index, -1) == call.object &&
               fragment.triangle == triangle;
    });
    return found == fragments.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

Status DepthInspector::prepare(Renderer& renderer, const FramePlan& frame, const Scene& scene, const Derived& derived,
                               glm::ivec2 size_px, const DepthWishes& wishes) {
    if (!fresh_.now) {
        if (Status done = now_.prepare(renderer, frame, scene, derived, size_px); !done) return done;
        fresh_.now = true;
    }
    const bool has_step = frame.limit.call >= 0 && wishes.cells.x > 0;
    if (has_step && !fresh_.before) {
        FramePlan earlier = frame;
        earlier.limit = step_before(frame.limit, draw_calls(frame, scene));
        if (Status done = before_.prepare(renderer, earlier, scene, derived, size_px); !done) return done;
        fresh_.before = true;
    }
    return std::monostate{};
}

void DepthInspector::find_touches(FramePlan frame, const Scene& scene, glm::ivec2 pixel, glm::ivec2 size_px) {
    frame.limit = {};
    const std::vector<DrawCall> calls = draw_calls(frame, scene);
    for (const Fragment& fragment : finder_->at(frame, pixel, size_px))
        if (const std::optional<DrawLimit> limit = limit_after(fragment, calls)) data_.touches.push_back(*limit);
}

void DepthInspector::read_cells(const FramePlan& frame, glm::ivec2 size_px, const DepthWishes& wishes) {
    const glm::ivec2 cells = glm::min(wishes.cells, size_px);
    const glm::ivec2 first = first_pixel_of(*wishes.pixel, cells, size_px);
    data_.now = now_.block(first, cells);
    const auto call = static_cast<std::size_t>(std::max(frame.limit.call, 0));
    const bool has_step = frame.limit.call >= 0 && call < data_.calls.size();
    data_.before = has_step ? before_.block(first, cells) : data_.now;
    data_.incoming.assign(data_.now.cells.size(), std::nullopt);
    if (!has_step) return;
    const DrawCall& drawn = data_.calls[call];
    const int triangles = triangles_drawn(frame.limit, frame.limit.call, drawn.triangles);
    for (std::size_t cell = 0; cell < data_.incoming.size() && triangles > 0; ++cell) {
        const auto index = static_cast<int>(cell);
        const glm::ivec2 pixel = data_.now.first_pixel + glm::ivec2(index % data_.now.size.x, index / data_.now.size.x);
        data_.incoming[cell] = latest_of(finder_->at(frame, pixel, size_px), drawn, triangles - 1);
    }
}

const FragmentFinder& DepthInspector::finder(const Scene& scene, int scene_version) {
    if (!finder_ || finder_version_ != scene_version) finder_ = std::make_unique<FragmentFinder>(scene);
    finder_version_ = scene_version;
    return *finder_;
}

Result<PixelReport> DepthInspector::at(Renderer& renderer, const FramePlan& frame, const Scene& scene,
                                       const Derived& derived, glm::ivec2 size_px, glm::ivec2 pixel) {
    if (Status done = prepare(renderer, frame, scene, derived, size_px, {}); !done) return Error{done.error()};
    return now_.at(pixel, scene);
}

Result<std::optional<PixelReport>> DepthInspector::follow(Renderer& renderer, const FramePlan& frame,
                                                          const Scene& scene, const Derived& derived,
                                                          glm::ivec2 size_px, glm::ivec2 pixel) {
    is_following_ = true;
    if (!std::exchange(rests_, true)) return std::optional<PixelReport>{};
    if (Status done = prepare(renderer, frame, scene, derived, size_px, {}); !done) {
        is_following_ = false;
        return Error{done.error()};
    }
    is_told(scene, pixel);
    return told_;
}

bool DepthInspector::is_told(const Scene& scene, glm::ivec2 pixel) {
    // Request one pixel at a time: while the pointer keeps moving, request its latest pixel when the previous one has
    // arrived.
    if (std::optional<PixelReport> come = now_.take(scene)) told_ = std::move(come);
    is_following_ = !told_ || told_->pixel != pixel;
    if (is_following_ && !now_.is_asked()) now_.ask(pixel);
    return !is_following_;
}

Status DepthInspector::update(Renderer& renderer, const FramePlan& frame, const Scene& scene, int scene_version,
                              const Derived& derived, glm::ivec2 size_px, const DepthWishes& wishes, bool at_once) {
    is_following_ = false;
    if (fresh_.told == wishes) return std::monostate{};
    const bool may_come_later = !at_once && fresh_.now && fresh_.told && wishes.pixel && wishes.cells.x == 0;
    if (may_come_later && !is_told(scene, *wishes.pixel)) return std::monostate{};
    data_ = {};
    if (wishes.calls) data_.calls = draw_calls(frame, scene);
    if (wishes.pixel || wishes.counts)
        if (Status done = prepare(renderer, frame, scene, derived, size_px, wishes); !done) return done;
    if (wishes.pixel) {
        finder(scene, scene_version);
        data_.pixel = may_come_later ? *told_ : now_.at(*wishes.pixel, scene);
        if (wishes.fragments) {
            data_.fragments = finder_->at(frame, *wishes.pixel, size_px);
            reconcile(data_.fragments, *data_.pixel, frame.clears_depth());
        }
        if (wishes.calls) find_touches(frame, scene, *wishes.pixel, size_px);
        if (wishes.cells.x > 0) read_cells(frame, size_px, wishes);
    }
    if (wishes.counts) {
        if (!fresh_.counts) fresh_.counts = now_.count_depths();
        data_.depth_counts = *fresh_.counts;
    }
    fresh_.told = wishes;
    return std::monostate{};
}

}  // namespace viewing
