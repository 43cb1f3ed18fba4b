#include "state/mesh/hollow_grid.h"

#include <algorithm>
#include <cmath>

namespace viewing {

namespace {

constexpr double margin = 1e-6;         // in cells, to allow for rounding
constexpr double least_height = 1e-12;  // fraction of the longer side, so that even collinear corners get a height

}  // namespace

void HollowGrid::fill(const std::vector<glm::dvec2>& places, const std::vector<Index>& hollows) {
    glm::dvec2 max = origin_ = places[hollows.front()];
    for (const Index hollow : hollows) {
        origin_ = glm::min(origin_, places[hollow]);
        max = glm::max(max, places[hollow]);
    }
    const glm::dvec2 extent = max - origin_;
    const glm::dvec2 size = glm::max(extent, glm::dvec2(least_height * std::max(extent.x, extent.y)));
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

/// Uses the parts of the three edges that are inside the slab.
HollowGrid::Cells HollowGrid::cells_in_slab(const Triangle& in_cells, int across, Slab slab, std::uint32_t count) {
    const int along = 1 - across;
    double first = count, last = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 &a = in_cells[i], &b = in_cells[(i + 1) % 3];
        if (std::max(a[across], b[across]) < slab.low || std::min(a[across], b[across]) > slab.high) continue;
        for (const glm::dvec2& end : {a, b}) {
            const double at = std::clamp(end[across], slab.low, slab.high);
            const double share = at == end[across] ? 0.0 : (at - a[across]) / (b[across] - a[across]);
            const double place = at == end[across] ? end[along] : a[along] + (b[along] - a[along]) * share;
            first = std::min(first, place);
            last = std::max(last, place);
        }
    }
    const bool is_beside = first - margin > count || last + margin < 0.0;
    return is_beside ? no_cells : Cells{clamped(first - margin, count), clamped(last + margin, count)};
}

HollowGrid::Cells HollowGrid::rows_of(const Triangle& in_cells) const {
    return cells_in_slab(in_cells, 0, {-margin, columns_ + margin}, rows_);
}

HollowGrid::Cells HollowGrid::columns_of(const Triangle& in_cells, std::uint32_t row) const {
    return cells_in_slab(in_cells, 1, {row - margin, row + 1.0 + margin}, columns_);
}

}  // namespace viewing
