// Sorts by one key, and counts every comparison and swap. Read bsp_build.cpp next.
#include "topics/hidden/methods/painter.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace viewing {
namespace {

double key_of(const Polygon& polygon, const Viewpoint& viewpoint, PainterKey key) {
    if (key == PainterKey::centroid) return viewpoint.distance(centroid(polygon));
    double nearest = viewpoint.distance(polygon.vertices.front()), farthest = nearest;
    for (const glm::dvec3& vertex : polygon.vertices) {
        nearest = std::min(nearest, viewpoint.distance(vertex));
        farthest = std::max(farthest, viewpoint.distance(vertex));
    }
    return key == PainterKey::nearest ? nearest : farthest;
}

/// A heap of polygon indices with the next one to draw at the top; counts its comparisons and swaps in `result`.
class FarthestFirst {
public:
    explicit FarthestFirst(PainterOrder& result) : result_(result), heap_(result.distances.size()) {
        std::iota(heap_.begin(), heap_.end(), 0);
        for (std::size_t i = heap_.size() / 2; i-- > 0;) sift_down(i);
    }

    bool empty() const { return heap_.empty(); }
    const std::vector<int>& rest() const { return heap_; }

    int take() {
        const int top = heap_.front();
        if (heap_.size() > 1) {
            std::swap(heap_.front(), heap_.back());
            ++result_.swaps;
        }
        heap_.pop_back();
        sift_down(0);
        return top;
    }

private:
    bool is_drawn_before(int a, int b) {
        ++result_.comparisons;
        return std::pair(result_.distances[a], a) > std::pair(result_.distances[b], b);
    }

    void sift_down(std::size_t parent) {
        for (;;) {
            std::size_t child = 2 * parent + 1;
            if (child >= heap_.size()) return;
            if (child + 1 < heap_.size() && is_drawn_before(heap_[child + 1], heap_[child])) ++child;
            if (!is_drawn_before(heap_[child], heap_[parent])) return;
            std::swap(heap_[parent], heap_[child]);
            ++result_.swaps;
            parent = child;
        }
    }

    PainterOrder& result_;
    std::vector<int> heap_;
};

}  // namespace

PainterOrder painter_order(std::span<const Polygon> polygons, const Viewpoint& viewpoint, PainterKey key,
                           WorkProgress* progress) {
    PainterOrder result;
    result.key = key;
    result.distances.reserve(polygons.size());
    for (const Polygon& polygon : polygons) {
        if (is_time_to_look(result.distances.size()) && is_canceled(progress)) break;
        result.distances.push_back(key_of(polygon, viewpoint, key));
    }
    result.distances.resize(polygons.size());
    result.order.reserve(polygons.size());
    FarthestFirst heap(result);
    while (!heap.empty()) {
        if (is_time_to_look(result.order.size())) {
            report(progress, static_cast<double>(result.order.size()) / static_cast<double>(polygons.size()));
            if (is_canceled(progress)) break;
        }
        result.order.push_back(heap.take());
    }
    result.order.insert(result.order.end(), heap.rest().begin(), heap.rest().end());
    return result;
}

}  // namespace viewing
