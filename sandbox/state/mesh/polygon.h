// Internal to state/: cutting polygons into triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "state/mesh/hollow_grid.h"

namespace viewing {

/// Twice the polygon's area times its mean normal (Newell), which also holds for a concave one.
glm::dvec3 area_normal(std::span<const glm::dvec3> corners);

class PolygonCutter {
public:
    /// Looks at corners and cells that all polygons together may take, apart from 100 a corner.
    static constexpr std::uint64_t most_tests = 100'000'000;

    enum class Outcome {
        filled,
        crosses_itself,  ///< what cannot be cut right is covered by a fan
        takes_too_long,  ///< nothing was appended
    };

    /// Appends count − 2 triangles as indices into `corners`, wound as the polygon is. A polygon that turns one way
    /// throughout becomes a fan about its first corner, so a quad is cut from the first to the third; seen along its
    /// mean normal, one that is not flat is taken as if it were. A concave one loses ear after ear: each is held
    /// against the corners that turn inwards, found by a grid, which mostly takes a time in proportion to the corners
    /// and at worst to their square. Source: Meisters 1975, ear clipping; Eberly 2002, its lists.
    [[nodiscard]] Outcome cut(std::span<const glm::dvec3> corners, std::vector<std::uint32_t>& triangles);

    std::uint64_t tests() const { return tests_; }  ///< so far

private:
    using Index = std::uint32_t;

    void flatten(std::span<const glm::dvec3> corners);
    /// Twice the area of a triangle, positive where it turns to the left.
    double turn(Index a, Index b, Index c) const;
    double turn_at(Index corner) const { return turn(before_[corner], corner, after_[corner]); }
    bool lies_in_triangle_at(Index corner, Index hollow);
    bool is_ear(Index corner);
    bool clip_ears(std::vector<Index>& triangles);
    Outcome fan(Index about, std::vector<Index>& triangles);
    void fill_grid();
    void look_again(Index corner);

    std::vector<glm::dvec2> flat_;       ///< the corners in the polygon's plane
    std::vector<Index> before_, after_;  ///< neighbours of the corners that are left
    std::vector<Index> hollows_;  ///< corners that do not turn left, and some that did not when the grid was filled
    std::vector<char> is_hollow_, is_ear_, is_queued_;
    std::vector<Index> blocker_;  ///< of each corner, the hollow that was found in its triangle last
    std::vector<Index> ears_;     ///< those found, in turn
    HollowGrid grid_;
    std::size_t hollow_count_ = 0;  ///< how many of hollows_ still are
    std::uint64_t tests_ = 0, allowed_tests_ = most_tests;
};

}  // namespace viewing
