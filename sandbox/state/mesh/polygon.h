// Internal to state/: cutting polygons into triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace viewing {

class PolygonCutter {
public:
    /// Corners held against triangles at most, for all polygons together.
    static constexpr std::uint64_t most_tests = 100'000'000;

    /// Appends count − 2 triangles as indices into `corners`, wound as the polygon is. The polygon may be concave and
    /// slightly out of plane; of more than 256 corners it is taken as convex. A convex one takes linear time, one with
    /// r corners that turn inwards or not at all 3 · count · r tests at most. False, and nothing is appended, when with
    /// these there could be more than most_tests. Source: Meisters 1975, ear clipping; Eberly 2002, its lists.
    [[nodiscard]] bool cut(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles);

    std::uint64_t tests() const { return tests_; }  ///< so far

private:
    using Index = std::uint32_t;

    /// How far a corner turns to the left, seen against the normal: twice the area of the triangle at it.
    double turn_at(Index corner) const;
    bool is_ear(Index corner);
    void clip_ears(std::vector<Index>& triangles);
    void look_again(Index corner);

    std::span<const glm::vec3> corners_;
    glm::dvec3 normal_{0.0};
    std::vector<Index> before_, after_;  ///< neighbours of the corners that are left
    std::vector<Index> hollows_;         ///< corners that do not turn left, and some that did not before
    std::vector<char> is_hollow_, is_ear_, is_queued_;
    std::vector<Index> ears_;  ///< those found, in turn
    std::uint64_t tests_ = 0;
};

}  // namespace viewing
