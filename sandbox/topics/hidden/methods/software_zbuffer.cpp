// Scan-converts convex polygons by their edges: in every row that it crosses, an edge gives one end of a span. Two
// polygons that share an edge compute the same ends, so no pixel is drawn twice or left out. Read bvh.cpp next.
#include "topics/hidden/methods/software_zbuffer.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <numeric>
#include <utility>

namespace viewing {
namespace {

/// Depths closer together than this count as one surface. This is far below a step of any stored format, but above
/// rounding errors.
constexpr double same_depth = 1e-12;

/// Returns the first pixel whose center is at or beyond `position`, within 0 … limit.
int first_pixel(double position, int limit) {
    const double inside = std::clamp(position - 0.5, 0.0, static_cast<double>(limit));
    const int floor = static_cast<int>(inside);
    return floor + (static_cast<double>(floor) < inside ? 1 : 0);
}

struct Span {
    double left, right;
};

struct ScreenPoint {
    double x, y, depth;  ///< pixels from the top left; window depth
};

class Rasterizer {
public:
    Rasterizer(const glm::dmat4& clip_from_world, const RasterOptions& options, RasterResult& result)
        : clip_from_world_(clip_from_world),
          clip_plane_from_world_(glm::inverseTranspose(clip_from_world)),
          options_(options),
          result_(result),
          least_w_(1e-7 * glm::length(glm::transpose(clip_from_world)[3])),
          spans_(static_cast<std::size_t>(options.height), empty_span),
          left_to_test_(options.stop_after) {}

    bool stopped() const { return left_to_test_ == 0; }

    void draw(const Polygon& polygon, int index, int place) {
        place_ = place;
        clip_.clear();
        for (const glm::dvec3& vertex : polygon.vertices) clip_.push_back(clip_from_world_ * glm::dvec4(vertex, 1.0));
        keep_where([](const glm::dvec4& p) { return p.w + p.z; });
        keep_where([](const glm::dvec4& p) { return p.w - p.z; });
        // Points beyond an oblique near plane may still be behind the eye.
        keep_where([this](const glm::dvec4& p) { return p.w - least_w_; });
        if (clip_.size() < 3) return;
        ++result_.counters.polygons;
        project();
        add_edges();
        polygon_ = &polygon;
        polygon_index_ = index;
        set_depth_plane();
        switch (options_.rule) {
            case PaintRule::overwrite:
                fill<PaintRule::overwrite>();
                break;
            case PaintRule::keep_first:
                fill<PaintRule::keep_first>();
                break;
            case PaintRule::depth_test:
                fill<PaintRule::depth_test>();
                break;
        }
    }

private:
    static constexpr Span empty_span{1e300, -1e300};

    /// Clips the polygon to the part where `distance` is not negative. Computes cuts from inside to outside, so that
    /// neighbors get the same corners.
    template <typename Distance>
    void keep_where(Distance distance) {
        if (std::all_of(clip_.begin(), clip_.end(), [&](const glm::dvec4& p) { return distance(p) >= 0.0; })) return;
        clipped_.clear();
        for (std::size_t i = 0; i < clip_.size(); ++i) {
            const glm::dvec4 &here = clip_[i], &next = clip_[(i + 1) % clip_.size()];
            const double here_distance = distance(here), next_distance = distance(next);
            if (here_distance >= 0.0) clipped_.push_back(here);
            if ((here_distance >= 0.0) == (next_distance >= 0.0)) continue;
            const bool leaves = here_distance >= 0.0;
            const glm::dvec4 &inside = leaves ? here : next, &outside = leaves ? next : here;
            const double inside_distance = leaves ? here_distance : next_distance;
            const double outside_distance = leaves ? next_distance : here_distance;
            clipped_.push_back(inside + inside_distance / (inside_distance - outside_distance) * (outside - inside));
        }
        std::swap(clip_, clipped_);
    }

    void project() {
        screen_.clear();
        const double grid = options_.subpixel_bits >= 0 ? static_cast<double>(1 << options_.subpixel_bits) : 0.0;
        for (const glm::dvec4& p : clip_) {
            const double inverse_w = 1.0 / p.w;
            ScreenPoint point{(p.x * inverse_w + 1.0) * 0.5 * options_.width,
                              (1.0 - p.y * inverse_w) * 0.5 * options_.height, (p.z * inverse_w + 1.0) * 0.5};
            if (grid > 0.0) {
                point.x = std::floor(point.x * grid + 0.5) / grid;
                point.y = std::floor(point.y * grid + 0.5) / grid;
            }
            screen_.push_back(point);
        }
    }

    void add_edges() {
        row_begin_ = options_.height;
        row_end_ = 0;
        nearest_ = farthest_ = screen_.front().depth;
        for (std::size_t i = 0, last = screen_.size() - 1; i < screen_.size(); last = i++) {
            nearest_ = std::min(nearest_, screen_[i].depth);
            farthest_ = std::max(farthest_, screen_[i].depth);
            const bool goes_down = screen_[last].y < screen_[i].y;
            add_edge(goes_down ? screen_[last] : screen_[i], goes_down ? screen_[i] : screen_[last]);
        }
    }

    void add_edge(const ScreenPoint& top, const ScreenPoint& bottom) {
        const int begin = first_pixel(top.y, options_.height), end = first_pixel(bottom.y, options_.height);
        if (begin >= end) return;
        row_begin_ = std::min(row_begin_, begin);
        row_end_ = std::max(row_end_, end);
        const double slope = (bottom.x - top.x) / (bottom.y - top.y);
        for (int y = begin; y < end; ++y) {
            const double x = top.x + (y + 0.5 - top.y) * slope;
            Span& span = spans_[y];
            span.left = std::min(span.left, x);
            span.right = std::max(span.right, x);
        }
    }

    /// Computes the coefficients of depth = at_origin + per_x · x + per_y · y from the polygon's plane, so that they
    /// are the same for all pieces of a polygon.
    void set_depth_plane() {
        const glm::dvec4 p = clip_plane_from_world_ * polygon_->plane;
        const bool is_edge_on = std::abs(p.z) <= 1e-14 * (std::abs(p.x) + std::abs(p.y) + std::abs(p.w));
        depth_per_x_ = is_edge_on ? 0.0 : -p.x / (p.z * options_.width);
        depth_per_y_ = is_edge_on ? 0.0 : p.y / (p.z * options_.height);
        depth_at_origin_ = is_edge_on ? nearest_ : 0.5 + 0.5 * (p.x - p.y - p.w) / p.z;
    }

    template <PaintRule rule>
    void fill() {
        for (int y = row_begin_; y < row_end_; ++y) {
            const Span span = std::exchange(spans_[y], empty_span);
            const int begin = first_pixel(span.left, options_.width);
            int end = first_pixel(span.right, options_.width);
            if (begin >= end) continue;
            if (left_to_test_ >= 0) {
                end = static_cast<int>(std::min<std::int64_t>(end, begin + left_to_test_));
                left_to_test_ -= end - begin;
            }
            fill_row<rule>(begin, end, y);
        }
    }

    double depth_at(int x, double depth_of_row) const {
        return std::min(std::max(depth_of_row + depth_per_x_ * (x + 0.5), nearest_), farthest_);
    }
    double depth_of_row(int y) const { return depth_at_origin_ + depth_per_y_ * (y + 0.5); }

    template <PaintRule rule>
    static bool lets_through(int id, double stored, double depth) {
        if constexpr (rule == PaintRule::keep_first) return id == IdImage::background;
        if constexpr (rule == PaintRule::depth_test) return depth < stored - same_depth;
        return true;
    }

    /// Records a fragment of the watched pixel, before its row is written.
    template <PaintRule rule>
    void touch(int x, int y, std::int64_t number) {
        const std::size_t at = result_.image.index(x, y);
        const double depth = depth_at(x, depth_of_row(y)), stored = result_.image.depths[at];
        const bool passes = lets_through<rule>(result_.image.ids[at], stored, depth);
        result_.touches.push_back({number, place_, {x, y, polygon_index_, depth, stored, passes}});
    }

    template <PaintRule rule>
    void fill_row(int begin, int end, int y) {
        if (begin >= end) return;
        IdImage& image = result_.image;
        int* const ids = image.ids.data() + image.index(0, y);
        double* const depths = image.depths.data() + image.index(0, y);
        const double row_depth = depth_of_row(y);
        const int id = polygon_->source;
        std::uint32_t* const counts =
            result_.written_per_pixel.empty() ? nullptr : result_.written_per_pixel.data() + image.index(0, y);
        std::int64_t written = 0;
        if (options_.watched && options_.watched->y == y && options_.watched->x >= begin && options_.watched->x < end)
            touch<rule>(options_.watched->x, y, result_.counters.pixels_tested + options_.watched->x - begin + 1);
        for (int x = begin; x < end; ++x) {
            const double depth = depth_at(x, row_depth);
            const bool passes = lets_through<rule>(ids[x], depths[x], depth);
            if (x == end - 1) result_.last = {x, y, polygon_index_, depth, depths[x], passes};
            if (!passes) continue;
            ids[x] = id;
            depths[x] = depth;
            ++written;
            if (counts != nullptr) ++counts[x];
        }
        result_.counters.pixels_tested += end - begin;
        result_.counters.pixels_written += written;
    }

    const glm::dmat4 clip_from_world_, clip_plane_from_world_;
    const RasterOptions& options_;
    RasterResult& result_;
    const double least_w_;
    std::vector<glm::dvec4> clip_, clipped_;
    std::vector<ScreenPoint> screen_;
    std::vector<Span> spans_;  ///< one per row, empty between polygons
    int row_begin_ = 0, row_end_ = 0;
    double nearest_ = 0.0, farthest_ = 0.0;
    const Polygon* polygon_ = nullptr;
    int polygon_index_ = 0, place_ = 0;
    double depth_at_origin_ = 0.0, depth_per_x_ = 0.0, depth_per_y_ = 0.0;
    std::int64_t left_to_test_;
};

}  // namespace

RasterResult rasterize(std::span<const Polygon> polygons, std::span<const int> order, const glm::dmat4& clip_from_world,
                       const RasterOptions& options, WorkProgress* progress) {
    RasterResult result;
    result.image = IdImage(options.width, options.height);
    if (options.count_per_pixel) result.written_per_pixel.assign(result.image.ids.size(), 0);
    result.tested_after.reserve(order.size());
    Rasterizer rasterizer(clip_from_world, options, result);
    for (std::size_t i = 0; i < order.size() && !rasterizer.stopped(); ++i) {
        if (is_time_to_look(i)) {
            if (is_canceled(progress)) break;
            report(progress, static_cast<double>(i) / static_cast<double>(order.size()));
        }
        rasterizer.draw(polygons[order[i]], order[i], static_cast<int>(i));
        result.tested_after.push_back(result.counters.pixels_tested);
    }
    result.counters.pixels_covered = std::count_if(result.image.ids.begin(), result.image.ids.end(),
                                                   [](int id) { return id != IdImage::background; });
    return result;
}

RasterResult rasterize(std::span<const Polygon> polygons, const glm::dmat4& clip_from_world,
                       const RasterOptions& options, WorkProgress* progress) {
    std::vector<int> order(polygons.size());
    std::iota(order.begin(), order.end(), 0);
    return rasterize(polygons, order, clip_from_world, options, progress);
}

}  // namespace viewing
