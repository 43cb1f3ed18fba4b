// Pairs of polygons in which one hides the other, checked by rays through many points of the picture. Also tests orders
// and cycles of whole polygons.
#include "topics/hidden/methods/hiding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "trials.h"
#include "unit/methods/scenes.h"

namespace viewing {
namespace {

/// A ray through a point of the picture, starting at the near plane, and the distance along it to a polygon.
struct Sight {
    glm::dvec3 origin, direction;

    std::optional<double> meets(const Polygon& polygon) const {
        const glm::dvec3 normal(polygon.plane);
        const double slope = glm::dot(normal, direction);
        if (std::abs(slope) < 1e-9) return std::nullopt;
        const double t = -(glm::dot(normal, origin) + polygon.plane.w) / slope;
        const glm::dvec3 at = origin + t * direction;
        for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
            const glm::dvec3& a = polygon.vertices[i];
            const glm::dvec3 edge = polygon.vertices[(i + 1) % polygon.vertices.size()] - a;
            // Hits need to be only 1e−9 inside each edge, so that rays still hit thin overlaps.
            if (glm::dot(glm::cross(normal, edge), at - a) < 1e-9 * glm::length(edge)) return std::nullopt;
        }
        return t > 1e-6 ? std::optional(t) : std::nullopt;
    }
};

Sight sight_through(const Viewpoint& viewpoint, double x, double y) {
    const glm::dmat4 world_from_clip = glm::inverse(viewpoint.clip_from_world());
    const auto at = [&](double z) {
        const glm::dvec4 point = world_from_clip * glm::dvec4(x, y, z, 1.0);
        return glm::dvec3(point) / point.w;
    };
    return {at(-1.0), glm::normalize(at(1.0) - at(-1.0))};
}

/// Projects the part of a polygon that is in front of the eye and beyond the near plane, and returns its corners
/// counterclockwise on the screen.
std::vector<glm::dvec2> on_screen(const Polygon& polygon, const Viewpoint& viewpoint) {
    std::vector<glm::dvec4> corners;
    for (const glm::dvec3& vertex : polygon.vertices)
        corners.push_back(viewpoint.clip_from_world() * glm::dvec4(vertex, 1.0));
    for (const glm::dvec4& plane : {glm::dvec4(0, 0, 1, 1), glm::dvec4(0, 0, 0, 1)}) {
        std::vector<glm::dvec4> kept;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec4 &a = corners[i], &b = corners[(i + 1) % corners.size()];
            const double at_a = glm::dot(plane, a) - 1e-9, at_b = glm::dot(plane, b) - 1e-9;
            if (at_a >= 0.0) kept.push_back(a);
            if ((at_a < 0.0) != (at_b < 0.0)) kept.push_back(glm::mix(a, b, at_a / (at_a - at_b)));
        }
        corners = kept;
    }
    std::vector<glm::dvec2> outline;
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        outline.push_back(glm::dvec2(corners[i]) / corners[i].w);
        const glm::dvec2 next = glm::dvec2(corners[(i + 1) % corners.size()]) / corners[(i + 1) % corners.size()].w;
        area += outline[i].x * next.y - outline[i].y * next.x;
    }
    if (area < 0.0) std::reverse(outline.begin(), outline.end());
    return outline;
}

/// Intersects two convex outlines.
std::vector<glm::dvec2> common_part(std::vector<glm::dvec2> part, const std::vector<glm::dvec2>& other) {
    for (std::size_t edge = 0; edge < other.size(); ++edge) {
        const glm::dvec2 from = other[edge], along = other[(edge + 1) % other.size()] - from;
        const auto inside = [&](const glm::dvec2& point) {
            return along.x * (point.y - from.y) - along.y * (point.x - from.x);
        };
        std::vector<glm::dvec2> kept;
        for (std::size_t i = 0; i < part.size(); ++i) {
            const glm::dvec2 &a = part[i], &b = part[(i + 1) % part.size()];
            if (inside(a) >= 0.0) kept.push_back(a);
            if ((inside(a) < 0.0) != (inside(b) < 0.0))
                kept.push_back(glm::mix(a, b, inside(a) / (inside(a) - inside(b))));
        }
        part = kept;
    }
    return part;
}

/// Returns whether some ray through the overlap of both polygons on the screen hits `front` before `back`. The corners
/// of the overlap decide which plane is nearer, so rays pass close to them.
bool some_ray_sees(const Polygon& back, const Polygon& front, const Viewpoint& viewpoint) {
    const std::vector<glm::dvec2> part = common_part(on_screen(front, viewpoint), on_screen(back, viewpoint));
    glm::dvec2 middle(0.0);
    for (const glm::dvec2& corner : part) middle += corner / static_cast<double>(part.size());
    for (const glm::dvec2& corner : part)
        for (double share = 1.0; share > 1e-7; share *= 0.1) {
            const glm::dvec2 place = glm::mix(corner, middle, share);
            const Sight sight = sight_through(viewpoint, place.x, place.y);
            const std::optional<double> near = sight.meets(front), far = sight.meets(back);
            if (near && far && *far > *near) return true;
        }
    return false;
}

/// Returns the hiding pairs that a grid of rays sees, each with the number of rays that see it.
std::map<HidingPair, int> seen_pairs(const std::vector<Polygon>& polygons, const Viewpoint& viewpoint) {
    constexpr int side = 60;
    std::map<HidingPair, int> pairs;
    for (int cell = 0; cell < side * side; ++cell) {
        const Sight sight = sight_through(viewpoint, 2.0 * (cell % side + 0.37) / side - 1.0,
                                          2.0 * (static_cast<double>(cell / side) + 0.41) / side - 1.0);
        std::vector<std::pair<double, int>> met;
        for (std::size_t i = 0; i < polygons.size(); ++i)
            if (const auto t = sight.meets(polygons[i])) met.emplace_back(*t, static_cast<int>(i));
        for (const auto& [near, front] : met)
            for (const auto& [far, back] : met)
                if (far > near + 1e-6) ++pairs[{back, front}];
    }
    return pairs;
}

TEST(HidingPairs, MatchThoseSeenByRays) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::size_t compared = 0;
    for (int scene = 0; scene < testing::trials(is_sanitized ? 100 : 400); ++scene) {
        const std::vector<Polygon> polygons = random_polygons(random);
        const Viewpoint viewpoint = random_viewpoint(random);
        const std::vector<HidingPair> found = hiding_pairs(polygons, viewpoint);
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "no duplicates";
        const auto seen = seen_pairs(polygons, viewpoint);
        for (const auto& [pair, rays] : seen) {
            EXPECT_TRUE(std::binary_search(found.begin(), found.end(), pair))
                << "scene " << scene << ": " << rays << " rays see " << pair.after << " in front of " << pair.before;
        }
        compared += seen.size();
        for (const HidingPair& pair : found) {
            const auto at = [&](int index) { return polygons[static_cast<std::size_t>(index)]; };
            EXPECT_TRUE(seen.contains(pair) || some_ray_sees(at(pair.before), at(pair.after), viewpoint))
                << "scene " << scene << ": no ray sees " << pair.after << " in front of " << pair.before;
        }
    }
    EXPECT_GT(compared, is_sanitized ? 2500U : 10000U);
}

TEST(HidingPairs, OfParallelSquaresDependOnDepthAlone) {
    std::vector<Polygon> squares;
    for (const double z : {0.0, 2.0, 1.0}) add(squares, {{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
    add(squares, {{3, -1, 1.5}, {5, -1, 1.5}, {5, 1, 1.5}, {3, 1, 1.5}});  // beside the other squares
    const std::vector<HidingPair> expected = {{0, 1}, {0, 2}, {2, 1}};
    EXPECT_EQ(hiding_pairs(squares, viewpoint_on_z(true)), expected);
    EXPECT_EQ(whole_order(4, expected).order, (std::vector<int>{0, 2, 1, 3}));
}

TEST(HidingPairs, StopSoonAfterTheRequestedNumber) {
    std::vector<Polygon> pile;
    for (int i = 0; i < 60; ++i)
        add(pile, {{-1, -1, 0.01 * i}, {1, -1, 0.01 * i}, {1, 1, 0.01 * i}, {-1, 1, 0.01 * i}});
    const std::size_t all = hiding_pairs(pile, viewpoint_on_z(true)).size();
    EXPECT_EQ(all, 60U * 59U / 2U);
    const std::size_t some = hiding_pairs(pile, viewpoint_on_z(true), std::nullopt, 100).size();
    EXPECT_GT(some, 100U);
    EXPECT_LT(some, 100U + 2U * 60U);
}

TEST(HidingPairs, OfInterpenetratingPolygonsGoBothWays) {
    std::vector<Polygon> crossing;
    add(crossing, {{-1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, -1}});
    add(crossing, {{-1, -1, 1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, 1}});
    const std::vector<HidingPair> pairs = hiding_pairs(crossing, viewpoint_on_z(true));
    EXPECT_EQ(pairs, (std::vector<HidingPair>{{0, 1}, {1, 0}}));
    const WholeOrder order = whole_order(2, pairs);
    EXPECT_TRUE(order.order.empty());
    EXPECT_EQ(order.cycle.size(), 2U);
}

TEST(HidingPairs, PutTheLowerSourceOfCoplanarPolygonsInFront) {
    std::vector<Polygon> coplanar;
    add(coplanar, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    add(coplanar, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
    EXPECT_EQ(hiding_pairs(coplanar, viewpoint_on_z()), (std::vector<HidingPair>{{1, 0}}));
}

TEST(WholeOrder, MatchesRaysOrReportsACycle) {
    SCOPED_TRACE(seed);
    Random random(seed);
    int painted = 0;
    for (int scene = 0; scene < 60; ++scene) {
        std::vector<Polygon> polygons = random_polygons(random);
        polygons.resize(std::min<std::size_t>(polygons.size(), 5));
        const Viewpoint viewpoint = random_viewpoint(random);
        const std::vector<HidingPair> pairs = hiding_pairs(polygons, viewpoint);
        const int count = static_cast<int>(polygons.size());
        const WholeOrder found = whole_order(count, pairs);
        ASSERT_NE(found.order.empty(), found.cycle.empty());
        if (found.order.empty()) {
            for (std::size_t i = 0; i < found.cycle.size(); ++i) {
                const HidingPair link{found.cycle[i], found.cycle[(i + 1) % found.cycle.size()]};
                EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), link)) << "scene " << scene;
            }
            continue;
        }
        EXPECT_EQ(wrong_pairs(pairs, found.order), 0);
        EXPECT_EQ(difference(ray_cast_image(polygons, viewpoint), paint(polygons, found.order, viewpoint)).different, 0)
            << "scene " << scene;
        ++painted;
    }
    EXPECT_GT(painted, 10);
}

TEST(WholeOrder, OfThreeCyclicBarsDoesNotExist) {
    const std::vector<Polygon> bars = cyclic_bars();
    const std::vector<HidingPair> pairs = hiding_pairs(bars, viewpoint_on_z());
    EXPECT_EQ(pairs.size(), 3U);
    const WholeOrder found = whole_order(3, pairs);
    EXPECT_TRUE(found.order.empty());
    EXPECT_EQ(std::set<int>(found.cycle.begin(), found.cycle.end()), (std::set<int>{0, 1, 2}));
    std::vector<int> order = {0, 1, 2};
    do EXPECT_GE(wrong_pairs(pairs, order), 1);
    while (std::next_permutation(order.begin(), order.end()));
}

TEST(WholeOrder, FindsTheShortCycleBehindALongOne) {
    // 0 → 1 → 2 → 3 → 0, and 4 ⇄ 5, which also depend on the first cycle.
    const std::vector<HidingPair> pairs = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {3, 4}, {4, 5}, {5, 4}};
    EXPECT_EQ(whole_order(6, pairs).cycle.size(), 2U);
    EXPECT_TRUE(whole_order(0, {}).order.empty());
}

TEST(Grouped, HasEachPairOfGroupsOnce) {
    const std::vector<HidingPair> pairs = {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {3, 0}};
    const std::vector<int> group_of = {0, 0, 1, 1};
    EXPECT_EQ(grouped(pairs, group_of), (std::vector<HidingPair>{{0, 1}, {1, 0}}));
}

}  // namespace
}  // namespace viewing
