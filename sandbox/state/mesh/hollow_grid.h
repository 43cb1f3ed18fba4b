// Internal to state/: a grid for finding the hollow (reflex) corners of a polygon that may be inside an ear. Read
// polygon.h first.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

namespace viewing {

/// A grid with about as many cells as corners, so that each cell contains only a few of them.
class HollowGrid {
public:
    using Index = std::uint32_t;
    using Triangle = std::array<glm::dvec2, 3>;

    void fill(const std::vector<glm::dvec2>& places, const std::vector<Index>& hollows);

    std::size_t size() const { return corners_.size(); }  ///< number of corners at the last fill()

    /// Returns whether `is_found` is true for any corner that may be inside a triangle or on its border. Tests the
    /// corners in the cells that the triangle touches until it finds one, and permanently drops those that are no
    /// longer hollow.
    template <typename IsHollow, typename IsFound>
    bool any_in(const Triangle& triangle, const IsHollow& is_hollow, const IsFound& is_found);

    /// Returns the number of cells searched since the last call.
    std::uint64_t take_cells_seen() { return std::exchange(cells_seen_, 0); }

private:
    struct Cells {
        std::uint32_t first, last;
    };
    static constexpr Cells no_cells{1, 0};
    /// An interval along one axis, in cells.
    struct Slab {
        double low, high;
    };
    glm::dvec2 in_cells(const glm::dvec2& place) const { return (place - origin_) * per_unit_; }
    static std::uint32_t clamped(double cell, std::uint32_t count);
    std::size_t cell_of(const glm::dvec2& place) const;
    /// Returns the cells, out of `count` along one axis, that a triangle touches inside a slab of the other axis
    /// (`across`).
    static Cells cells_in_slab(const Triangle& in_cells, int across, Slab slab, std::uint32_t count);
    Cells rows_of(const Triangle& in_cells) const;
    Cells columns_of(const Triangle& in_cells, std::uint32_t row) const;

    std::uint32_t columns_ = 1, rows_ = 1;
    glm::dvec2 origin_{0.0}, per_unit_{0.0};
    std::vector<std::uint32_t> begin_, count_;  ///< each cell's range in corners_
    std::vector<Index> corners_;
    std::uint64_t cells_seen_ = 0;
};

template <typename IsHollow, typename IsFound>
bool HollowGrid::any_in(const Triangle& triangle, const IsHollow& is_hollow, const IsFound& is_found) {
    const Triangle placed = {in_cells(triangle[0]), in_cells(triangle[1]), in_cells(triangle[2])};
    const Cells rows = rows_of(placed);
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
        const Cells columns = columns_of(placed, row);
        for (std::uint32_t column = columns.first; column <= columns.last; ++column) {
            ++cells_seen_;
            const std::size_t cell = std::size_t{row} * columns_ + column;
            Index* const corners = corners_.data() + begin_[cell];
            for (std::uint32_t i = 0; i < count_[cell];) {
                if (!is_hollow(corners[i]))
                    corners[i] = corners[--count_[cell]];
                else if (is_found(corners[i++]))
                    return true;
            }
        }
    }
    return false;
}

}  // namespace viewing
