#include "topics/depth/measured/fighting_measure.h"

#include "text/catalogue.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/numbers/hidden_budget.h"
#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {
namespace {

/// The object visible at each pixel, and rays for more detailed questions.
class ExactVisibility {
public:
    ExactVisibility(const Params& params, const Derived& derived, const Scene& scene, glm::ivec2 size_px,
                    WorkProgress* progress)
        : solver_(scene), progress_(progress) {
        HiddenRequest request = hidden_request(params, derived, size_px);
        request.visibility.method = reference_method;
        result_ = solver_.solve(request, progress);
        objects_ = with_ids(result_->image, solver_.surface()->object_of_source());
    }

    const Message& problem() const { return result_->problem; }
    const IdImage& objects() const { return objects_; }

    /// Rays cannot decide which of two coincident objects is visible, so choose the one that is meant to be on top.
    void decide_between(const FlatPair& pair) {
        const std::vector<std::uint8_t> met = where_both_are_met(pair);
        const int seen = pair.first_lies_on_top() ? pair.first : pair.second;
        for (std::size_t pixel = 0; pixel < met.size(); ++pixel)
            if (met[pixel] != 0) objects_.ids[pixel] = seen;
    }

    /// Returns 1 for each pixel that shows one of the two objects and whose ray hits both; incomplete if canceled.
    std::vector<std::uint8_t> where_both_are_met(const FlatPair& pair) const {
        std::vector<std::uint8_t> met(objects_.ids.size(), 0);
        mark_hits(met, pair.first, pair.second);
        mark_hits(met, pair.second, pair.first);
        return met;
    }

private:
    /// Marks each pixel that shows the object `seen`, which its ray therefore hits, and whose ray also hits `other`.
    void mark_hits(std::vector<std::uint8_t>& met, int seen, int other) const {
        const RayScene others(polygons_of_object(other));
        const PixelRays rays(result_->request.viewpoint.clip_from_world(), objects_.width, objects_.height);
        RayCounters counters;
        std::vector<BoundedRay> row;
        std::vector<std::size_t> pixels;
        std::vector<RayCastHit> hits;
        for (int y = 0; y < objects_.height && !is_canceled(progress_); ++y) {
            row.clear();
            pixels.clear();
            for (int x = 0; x < objects_.width; ++x) {
                if (objects_.id(x, y) != seen) continue;
                row.push_back(rays.through(x, y));
                pixels.push_back(objects_.index(x, y));
            }
            hits.resize(row.size());
            others.nearest(row, hits, counters);
            for (std::size_t i = 0; i < row.size(); ++i)
                if (hits[i].source >= 0) met[pixels[i]] = 1;
        }
    }

    std::vector<Polygon> polygons_of_object(int object) const {
        std::vector<Polygon> found;
        for (const Polygon& polygon : *result_->fragments)
            if (polygon.object == object) found.push_back(polygon);
        return found;
    }

    HiddenSurfaceSolver solver_;
    WorkProgress* progress_;
    std::shared_ptr<const HiddenResult> result_;
    IdImage objects_;
};

/// Whether this pixel and all pixels around it are marked.
bool is_inside(const std::vector<std::uint8_t>& marked, const IdImage& image, int x, int y) {
    if (x < 1 || y < 1 || x + 1 >= image.width || y + 1 >= image.height) return false;
    for (int ny = y - 1; ny <= y + 1; ++ny)
        for (int nx = x - 1; nx <= x + 1; ++nx)
            if (marked[image.index(nx, ny)] == 0) return false;
    return true;
}

}  // namespace

Params counted_params(const Params& state) {
    Params params;
    params.scene = state.scene;
    params.coplanar = state.coplanar;
    params.camera = state.camera;
    params.projection = state.projection;
    params.depth = state.depth;
    params.cull = state.cull;
    params.slips = state.slips;
    params.shadow.enabled = params.reflection.enabled = false;
    return params;
}

Result<IdImage> objects_by_gl(Renderer& renderer, const Params& state, const Scene& scene, glm::ivec2 size_px) {
    const Params params = counted_params(state);
    FramePlan frame = plan(params, derive(params, scene, renderer.viewport(size_px)));
    std::erase_if(frame.passes, [](const Pass& pass) { return pass.subject != Subject::objects; });
    View view;
    if (Status drawn = renderer.draw_identities(frame, scene, size_px, view); !drawn) return Error{drawn.error()};
    const Image bytes = renderer.read(view);
    IdImage image(bytes.width, bytes.height);
    for (std::size_t pixel = 0; pixel < image.ids.size(); ++pixel)
        image.ids[pixel] = bytes.rgba[4 * pixel] + 256 * bytes.rgba[4 * pixel + 1] - 1;
    return image;
}

Result<FightingCounts> count_wrong(const IdImage& drawn, const Params& state, const Scene& scene,
                                   std::span<const FlatPair> pairs, WorkProgress* progress) {
    if (const Message why = beyond_hidden_budget(scene, false); !why.empty()) return Error{say(why)};
    const Params params = counted_params(state);
    const glm::ivec2 size_px(drawn.width, drawn.height);
    ExactVisibility exact(params, derive(params, scene, {size_px}), scene, size_px, progress);
    if (!exact.problem().empty()) return Error{say(exact.problem())};

    for (const FlatPair& pair : pairs)
        if (pair.offset == 0.0) exact.decide_between(pair);
    const IdImage& seen = exact.objects();
    FightingCounts counts;
    std::vector<std::uint8_t> of_pairs(seen.ids.size(), 0);
    for (const FlatPair& pair : pairs) {
        const std::vector<std::uint8_t> met = exact.where_both_are_met(pair);
        if (is_canceled(progress)) return Error{tr("The count was canceled.")};
        CountedPair counted{.pair = pair};
        for (int y = 0; y < seen.height; ++y) {
            for (int x = 0; x < seen.width; ++x) {
                const std::size_t pixel = seen.index(x, y);
                if (met[pixel] == 0) continue;
                of_pairs[pixel] = 1;
                if (!is_inside(met, seen, x, y)) continue;
                ++counted.pixels;
                counted.wrong += drawn.ids[pixel] != seen.ids[pixel] ? 1 : 0;
                counted.vanished += drawn.ids[pixel] == IdImage::background ? 1 : 0;
            }
        }
        counts.pairs.push_back(counted);
    }
    const IdDifference elsewhere = difference(seen, drawn);
    for (std::size_t pixel = 0; pixel < of_pairs.size(); ++pixel) {
        if (of_pairs[pixel] != 0) continue;
        const bool has_seen = seen.ids[pixel] != IdImage::background,
                   has_drawn = drawn.ids[pixel] != IdImage::background;
        counts.wrong_elsewhere += elsewhere.differs[pixel];
        counts.bleeding_elsewhere += has_seen && has_drawn ? elsewhere.differs[pixel] : 0;
        counts.vanished_elsewhere += has_drawn ? 0 : elsewhere.differs[pixel];
        counts.pixels_elsewhere += has_seen || has_drawn ? 1 : 0;
    }
    return counts;
}

glm::ivec2 spread_size(glm::ivec2 size_px) {
    constexpr int widest_px = 480;
    if (size_px.x <= widest_px) return size_px;
    return {widest_px, std::max(size_px.y * widest_px / size_px.x, 1)};
}

void take_spread(FightingReport& report, const FightingCounts& counts) {
    for (std::size_t i = 0; i < report.rows.size() && i < counts.pairs.size(); ++i)
        if (counts.pairs[i].pixels > 0) report.rows[i].spread.take(counts.pairs[i].wrong_fraction());
}

Status count_cures(FightingReport& report, Renderer& renderer, const Scene& scene, WorkProgress* progress) {
    const std::vector<FlatPair> pairs = near_coplanar_pairs(scene);
    for (FightingReport::Cured& cured : report.cured) {
        Result<FightingCounts> counts =
            count_fighting(renderer, cured.cure.params, scene, pairs, report.size_px, progress);
        if (!counts) return Error{counts.error()};
        cured.counts = *std::move(counts);
    }
    return std::monostate{};
}

Status count_spread(FightingReport& report, Renderer& renderer, const Params& state, const Scene& scene,
                    WorkProgress* progress) {
    const std::vector<FlatPair> pairs = near_coplanar_pairs(scene);
    for (int camera = 0; camera < spread_cameras; ++camera) {
        const Result<FightingCounts> counts =
            count_fighting(renderer, jittered(state, camera), scene, pairs, spread_size(report.size_px), progress);
        if (!counts) return Error{counts.error()};
        take_spread(report, *counts);
    }
    return std::monostate{};
}

Result<FightingCounts> count_fighting(Renderer& renderer, const Params& state, const Scene& scene,
                                      std::span<const FlatPair> pairs, glm::ivec2 size_px, WorkProgress* progress) {
    const Result<IdImage> drawn = objects_by_gl(renderer, state, scene, size_px);
    if (!drawn) return Error{drawn.error()};
    return count_wrong(*drawn, state, scene, pairs, progress);
}

}  // namespace viewing
