// Runs each method: finds its order, if any, then the picture at the requested step. Read hidden_drawing.cpp next.
#include "frame/hidden/hidden_surfaces.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <numeric>

#include "frame/hidden/hidden_steps.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

class Stopwatch {
public:
    double ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started_).count();
    }

private:
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

/// Returns whether two requests differ only in step and followed pixel, and therefore share order, tree and counters.
bool have_one_order(HiddenRequest a, const HiddenRequest& b) {
    a.visibility.step = b.visibility.step;
    a.visibility.pixel = b.visibility.pixel;
    return a == b;
}

/// Returns the winding of front faces, which a mirrored view reverses.
FrontFace winding_for(const HiddenRequest& request) {
    const bool mirrors = glm::determinant(glm::dmat3(request.viewpoint.view_from_world)) < 0.0;
    const FrontFace turned = request.cull.front_face == FrontFace::cw ? FrontFace::ccw : FrontFace::cw;
    return mirrors ? turned : request.cull.front_face;
}

std::vector<int> counted(std::size_t count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    return order;
}

void take_counters(HiddenCounters& counters, const RasterCounters& raster) {
    counters.pixels_tested = raster.pixels_tested;
    counters.pixels_written = raster.pixels_written;
    counters.pixels_covered = raster.pixels_covered;
}

PaintRule rule_of(const VisibilityParams& visibility) {
    if (visibility.method == VisibilityMethod::software_depth_buffer) return PaintRule::depth_test;
    const bool is_masked = visibility.method == VisibilityMethod::bsp && visibility.walk == BspOrder::front_to_back;
    return is_masked ? PaintRule::keep_first : PaintRule::overwrite;
}

/// Paints the whole order and records the followed pixel.
RasterResult paint_all(const HiddenResult& result, WorkProgress* progress) {
    const HiddenRequest& request = result.request;
    return rasterize(*result.fragments, result.order, request.viewpoint.clip_from_world(),
                     {.rule = rule_of(request.visibility),
                      .width = request.size_px.x,
                      .height = request.size_px.y,
                      .count_per_pixel = true,
                      .watched = request.visibility.pixel},
                     progress);
}

void take_picture(HiddenResult& result, RasterResult raster) {
    take_counters(result.counters, raster.counters);
    if (result.request.visibility.method == VisibilityMethod::software_depth_buffer) result.compare = raster.last;
    result.image = std::move(raster.image);
    result.written_per_pixel = std::move(raster.written_per_pixel);
}

/// Paints the polygons that the step has reached, but stops after `stop_after` tested pixels; −1: no limit.
void paint(HiddenResult& result, std::int64_t stop_after, WorkProgress* progress) {
    const HiddenRequest& request = result.request;
    const std::span<const int> drawn(result.order.data(), static_cast<std::size_t>(result.drawn));
    take_picture(result, rasterize(*result.fragments, drawn, request.viewpoint.clip_from_world(),
                                   {.rule = rule_of(request.visibility),
                                    .width = request.size_px.x,
                                    .height = request.size_px.y,
                                    .stop_after = stop_after,
                                    .count_per_pixel = true},
                                   progress));
}

/// Returns the pixel whose ray is shown: the step's pixel or, without a step, the followed pixel.
std::optional<glm::ivec2> traced_pixel(const HiddenResult& result) {
    const HiddenRequest& request = result.request;
    const int columns = request.size_px.x;
    if (result.step > 0) return glm::ivec2((result.step - 1) % columns, (result.step - 1) / columns);
    const std::optional<glm::ivec2>& pixel = request.visibility.pixel;
    return pixel && glm::all(glm::lessThan(*pixel, request.size_px)) ? pixel : std::nullopt;
}

}  // namespace

Message sentence_of_canceled() {
    return message("The method was canceled: the picture is not finished.");
}

HiddenSurfaceSolver::HiddenSurfaceSolver(const Scene& scene, const WorkProgress* progress)
    : surface_(std::make_shared<const SceneSurface>(surface_of(scene, progress))) {}

Polygons HiddenSurfaceSolver::polygons_for(HiddenResult& result, const WorkProgress* progress) const {
    const HiddenRequest& request = result.request;
    if (is_canceled(progress)) return std::make_shared<const std::vector<Polygon>>();
    if (!request.cull.enabled) return {surface_, &surface_->polygons};  // no copy: there may be a million polygons
    auto kept = std::make_shared<const std::vector<Polygon>>(
        culled(surface_->polygons, request.viewpoint, request.cull.face, winding_for(request), progress));
    if (!is_canceled(progress))  // if canceled, some polygons were never tested
        result.counters.culled = static_cast<std::int64_t>(surface_->polygons.size() - kept->size());
    return kept;
}

void HiddenSurfaceSolver::find_bsp(HiddenResult& result, WorkProgress* progress) {
    const VisibilityParams& visibility = result.request.visibility;
    if (!trees_.tree || trees_.splitter != visibility.splitter || trees_.epsilon != visibility.epsilon) {
        const Stopwatch watch;
        const BspOptions options{.splitter = visibility.splitter,
                                 .epsilon = visibility.epsilon * surface_->diagonal,
                                 .max_fragments = 1'000'000 + 2 * static_cast<int>(surface_->polygons.size())};
        auto tree = std::make_shared<const BspTree>(build_bsp(surface_->polygons, options, progress));
        trees_ = {tree, visibility.splitter, visibility.epsilon, watch.ms()};
    }
    result.tree = trees_.tree;
    result.build_ms = trees_.build_ms;
    result.problem = result.tree->problem;
    if (is_canceled(progress)) trees_ = {};  // a canceled tree is incomplete
    result.fragments = {result.tree, &result.tree->fragments};

    const Stopwatch watch;
    auto walk =
        std::make_shared<BspWalk>(walk_bsp(*result.tree, result.request.viewpoint.eye_world(), visibility.walk));
    result.time_ms = watch.ms();
    result.order = walk->fragments;
    result.walk = std::move(walk);
    HiddenCounters& counters = result.counters;
    if (result.request.cull.enabled) {
        const std::vector<Facing> facing =
            facing_by_plane(*result.fragments, result.request.viewpoint, winding_for(result.request));
        const CullFace faces = result.request.cull.face;
        counters.culled = static_cast<std::int64_t>(std::erase_if(result.order, [&](int fragment) {
            const Facing side = facing[static_cast<std::size_t>(fragment)];
            return faces == CullFace::front_and_back ||
                   side == (faces == CullFace::front ? Facing::towards : Facing::away);
        }));
    }
    counters.polygons = static_cast<std::int64_t>(surface_->polygons.size());
    counters.comparisons = result.tree->counters.plane_tests;
    counters.splits = result.tree->counters.splits;
    counters.fragments = static_cast<std::int64_t>(result.tree->fragments.size());
    counters.tree_depth = result.tree->counters.depth;
}

void HiddenSurfaceSolver::cast(HiddenResult& result, WorkProgress* progress) {
    const HiddenRequest& request = result.request;
    const bool exact = uses_exact_curves(request);
    Polygons polygons = polygons_for(result, progress);
    if (exact) {
        auto flat = std::make_shared<std::vector<Polygon>>();
        const auto is_flat = [&](const Polygon& polygon) {
            return std::none_of(surface_->curved.begin(), surface_->curved.end(),
                                [&](const CurvedShape& shape) { return shape.object == polygon.object; });
        };
        std::copy_if(polygons->begin(), polygons->end(), std::back_inserter(*flat), is_flat);
        polygons = std::move(flat);
    }
    HiddenCounters& counters = result.counters;
    counters.polygons = static_cast<std::int64_t>(polygons->size() + (exact ? surface_->curved.size() : 0));

    // Without culling, the hierarchy does not depend on the camera and can be used again.
    const bool serves = rays_.scene && uses_exact_curves(rays_.made_for) == exact && !rays_.made_for.cull.enabled &&
                        !request.cull.enabled;
    if (!serves) {
        const Stopwatch watch;
        const std::span<const CurvedShape> curved = exact ? std::span(surface_->curved) : std::span<CurvedShape>();
        rays_ = {std::make_shared<const RayScene>(*polygons, curved, progress), request, 0.0};
        rays_.build_ms = watch.ms();
    }
    result.build_ms = rays_.build_ms;
    result.fragments = polygons;

    find_step(result);
    const Stopwatch watch;
    RayCastResult cast = cast_rays(*rays_.scene, request.viewpoint.clip_from_world(),
                                   {request.size_px.x, request.size_px.y, result.step}, progress);
    result.time_ms = watch.ms();
    if (const std::optional<glm::ivec2> pixel = traced_pixel(result)) {
        TracedRay traced;
        traced.pixel = *pixel;
        const auto [ray, max_t] = PixelRays(request.viewpoint.clip_from_world(), request.size_px.x, request.size_px.y)
                                      .through(traced.pixel.x, traced.pixel.y);
        RayCounters uncounted;
        traced.ray = ray;
        traced.hits = rays_.scene->all(ray, max_t, uncounted);
        result.traced = std::move(traced);
    }
    counters.rays = cast.counters.rays;
    counters.intersection_tests = cast.counters.box_tests + cast.counters.triangle_tests + cast.counters.curved_tests;
    counters.pixels_tested = counters.pixels_written = counters.pixels_covered =
        std::count_if(cast.image.ids.begin(), cast.image.ids.end(), [](int id) { return id != IdImage::background; });
    result.written_per_pixel.resize(cast.image.ids.size());
    std::transform(cast.image.ids.begin(), cast.image.ids.end(), result.written_per_pixel.begin(),
                   [](int id) { return id != IdImage::background ? 1U : 0U; });
    result.image = std::move(cast.image);
    if (is_canceled(progress)) {
        result.problem = message("Ray casting was canceled: the rest of the picture is empty.");
        rays_ = {};
    }
}

void HiddenSurfaceSolver::find_order(HiddenResult& result, WorkProgress* progress) {
    const HiddenRequest& request = result.request;
    const VisibilityParams& visibility = request.visibility;
    if (visibility.method == VisibilityMethod::bsp) return find_bsp(result, progress);

    const Polygons polygons = polygons_for(result, progress);
    HiddenCounters& counters = result.counters;
    counters.polygons = static_cast<std::int64_t>(polygons->size());
    result.fragments = polygons;
    const Stopwatch watch;
    if (visibility.method == VisibilityMethod::painter) {
        auto painter = std::make_shared<const PainterOrder>(
            painter_order(*polygons, request.viewpoint, visibility.sort_key, progress));
        result.order = painter->order;
        counters.comparisons = painter->comparisons;
        counters.swaps = painter->swaps;
        result.painter = std::move(painter);
    } else if (visibility.method == VisibilityMethod::newell) {
        auto newell = std::make_shared<const NewellOrder>(
            newell_order(*polygons, request.viewpoint, {.epsilon = visibility.epsilon * surface_->diagonal}, progress));
        result.order = newell->order;
        result.fragments = {newell, &newell->fragments};
        result.problem = newell->problem;
        counters.fragments = static_cast<std::int64_t>(newell->order.size());
        result.newell = std::move(newell);
    } else {
        result.order = counted(polygons->size());
    }
    result.time_ms = watch.ms();
}

std::shared_ptr<const HiddenResult> HiddenSurfaceSolver::solve(const HiddenRequest& request, WorkProgress* progress) {
    for (const auto& kept : latest_)
        if (kept->request == request) return kept;

    auto result = std::make_shared<HiddenResult>();
    const bool is_pixel_method = request.visibility.method == VisibilityMethod::software_depth_buffer ||
                                 request.visibility.method == VisibilityMethod::ray_cast;
    const auto same_order = std::find_if(latest_.begin(), latest_.end(), [&](const auto& kept) {
        return have_one_order(kept->request, request) && !is_pixel_method;
    });
    if (same_order != latest_.end()) *result = **same_order;
    result->request = request;
    result->surface = surface_;
    result->compare.reset();
    result->traced.reset();
    result->touches.clear();

    if (same_order == latest_.end())
        result->facing = count_facing(surface_->polygons, request.viewpoint, winding_for(request), progress);
    const Stopwatch watch;
    if (request.visibility.method == VisibilityMethod::ray_cast) {
        cast(*result, progress);
    } else {
        if (same_order == latest_.end()) find_order(*result, progress);
        if (request.visibility.method == VisibilityMethod::software_depth_buffer) {
            result->drawn = static_cast<int>(result->order.size());
            RasterResult raster = paint_all(*result, progress);
            result->time_ms = watch.ms();
            find_fragment_steps(*result, raster);
            take_picture(*result, std::move(raster));
            find_step(*result);
            if (result->step >= 0) paint(*result, result->step, progress);
        } else {
            find_step(*result);
            count_to_step(*result);
            if (!is_drawn_by_gl_alone(request.visibility.method)) {
                const Stopwatch painting;
                paint(*result, -1, progress);
                result->painting_ms = painting.ms();
                if (request.visibility.pixel) find_polygon_steps(*result, paint_all(*result, progress));
            }
        }
    }
    result->is_canceled = is_canceled(progress);
    if (result->is_canceled) {
        if (result->problem.empty()) result->problem = sentence_of_canceled();
        return result;
    }
    constexpr std::size_t kept_count = 4;  // camera and mirrored eye, for the two methods of a comparison
    if (latest_.size() == kept_count) latest_.erase(latest_.begin());
    latest_.push_back(result);
    return result;
}

}  // namespace viewing
