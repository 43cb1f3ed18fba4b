#include "state/mesh/hollow_grid.h"

#include <algorithm>
#include <cmath>

namespace viewing {

namespace {

constexpr double margin = 1e-6;  // of a cell: what rounding may put beside it

}  // namespace

void HollowGrid::fill(const std::vector<glm::dvec2>& places, const std::vector<Index>& hollows) {
    glm::dvec2 max = origin_ = places[hollows.front()];
    for (const Index hollow : hollows) {
        origin_ = glm::min(origin_, places[hollow]);
        max = glm::max(max, places[hollow]);
    }
    const glm::dvec2 size = max - origin_;
    const auto most = static_cast<double>(hollows.size());
    const double across = size.y > 0.0 ? std::sqrt(most * size.x / size.y) : most;
    columns_ = static_cast<std::uint32_t>(std::clamp(across, 1.0, most));
    rows_ = static_cast<std::uint32_t>(std::clamp(most / columns_, 1.0, most));
    per_unit_ = {size.x > 0.0 ? columns_ / size.x : 0.0, size.y > 0.0 ? rows_ / size.y : 0.0};
    begin_.resize(std::size_t{columns_} * rows_);
    count_.assign(begin_.size(), 0);
    for (const Index hollow : hollows) ++count_[cell_of(places[hollow])];
    std::uint32_t next = 0;
    for (std::size_t cell = 0; cell < count_.size(); ++cell) {
        begin_[cell] = next;
        next += std::exchange(count_[cell], 0);
    }
    corners_.resize(hollows.size());
    for (const Index hollow : hollows) {
        const std::size_t cell = cell_of(places[hollow]);
        corners_[begin_[cell] + count_[cell]++] = hollow;
    }
}

std::uint32_t HollowGrid::clamped(double cell, std::uint32_t count) {
    return static_cast<std::uint32_t>(std::clamp(cell, 0.0, count - 1.0));
}

std::size_t HollowGrid::cell_of(const glm::dvec2& place) const {
    const glm::dvec2 cell = in_cells(place);
    return std::size_t{clamped(cell.y, rows_)} * columns_ + clamped(cell.x, columns_);
}

HollowGrid::Cells HollowGrid::rows_of(const Triangle& in_cells) const {
    const auto [low, high] = std::minmax({in_cells[0].y, in_cells[1].y, in_cells[2].y});
    return {clamped(low - margin, rows_), clamped(high + margin, rows_)};
}

/// By the parts of the three edges that lie in the row.
HollowGrid::Cells HollowGrid::columns_of(const Triangle& in_cells, std::uint32_t row) const {
    const double bottom = row - margin, top = row + 1.0 + margin;
    double left = columns_, right = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 &a = in_cells[i], &b = in_cells[(i + 1) % 3];
        if (std::max(a.y, b.y) < bottom || std::min(a.y, b.y) > top) continue;
        for (const glm::dvec2& end : {a, b}) {
            const double y = std::clamp(end.y, bottom, top);
            const double x = y == end.y ? end.x : a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
            left = std::min(left, x);
            right = std::max(right, x);
        }
    }
    return {clamped(left - margin, columns_), clamped(right + margin, columns_)};
}

}  // namespace viewing
