// Internal to state/: splits polygons into triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "state/mesh/hollow_grid.h"

namespace viewing {

/// Returns twice the polygon's area times its mean normal (Newell); also correct for a concave polygon.
glm::dvec3 area_normal(std::span<const glm::dvec3> corners);

class PolygonCutter {
public:
    /// The limit on tests of corners and cells, for all polygons together; each corner of a concave polygon adds 100 to
    /// it.
    static constexpr std::uint64_t most_tests = 100'000'000;

    enum class Outcome {
        filled,
        crosses_itself,  ///< a fan covers the part that cannot be cut correctly
        takes_too_long,  ///< nothing was appended
    };

    /// Appends count − 2 triangles as indices into `corners`, with the polygon's winding. A polygon that always turns
    /// the same way becomes a fan around its first corner, so a quad is cut from the first to the third corner. A
    /// polygon that is not flat is treated as its projection along the mean normal. A concave polygon is cut by
    /// clipping ears. A grid finds the inward-turning corners that each ear must be tested against, so that the time is
    /// usually proportional to the number of corners, and in the worst case to its square. Source: Meisters 1975 for
    /// ear clipping; Eberly 2002 for the lists that it uses.
    [[nodiscard]] Outcome cut(std::span<const glm::dvec3> corners, std::vector<std::uint32_t>& triangles);

    std::uint64_t tests() const { return tests_; }  ///< the number of tests so far

private:
    using Index = std::uint32_t;

    void flatten(std::span<const glm::dvec3> corners);
    /// Returns twice the area of a triangle, positive if it turns left.
    double turn(Index a, Index b, Index c) const;
    double turn_at(Index corner) const { return turn(before_[corner], corner, after_[corner]); }
    bool lies_in_triangle_at(Index corner, Index hollow);
    bool is_ear(Index corner);
    bool clip_ears(std::vector<Index>& triangles);
    Outcome fan(Index about, std::vector<Index>& triangles);
    void fill_grid();
    void look_again(Index corner);

    std::vector<glm::dvec2> flat_;       ///< the corners in the polygon's plane
    std::vector<Index> before_, after_;  ///< neighbors among the remaining corners
    std::vector<Index> hollows_;         ///< corners that do not turn left, or did not at the last fill
    std::vector<char> is_hollow_, is_ear_, is_queued_;
    std::vector<Index> blocker_;  ///< the hollow corner last found in each corner's triangle
    std::vector<Index> ears_;     ///< ears found so far, in order
    HollowGrid grid_;
    std::size_t hollow_count_ = 0;  ///< how many entries of hollows_ are still hollow
    std::uint64_t tests_ = 0, allowed_tests_ = most_tests;
};

}  // namespace viewing
