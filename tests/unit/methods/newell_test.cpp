// Newell's sort: the ladder test by test, cycles, budgets, and degenerate input.
#include "topics/hidden/methods/newell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "topics/hidden/methods/growth.h"
#include "unit/methods/scenes.h"

namespace viewing {
namespace {

std::vector<glm::dvec3> rectangle(double x0, double x1, double y0, double y1, double z_left, double z_right) {
    return {{x0, y0, z_left}, {x1, y0, z_right}, {x1, y1, z_right}, {x0, y1, z_left}};
}

std::int64_t wrong_pixels(std::span<const Polygon> polygons, const NewellOrder& result, const Viewpoint& viewpoint) {
    return difference(ray_cast_image(polygons, viewpoint), paint(result.fragments, result.order, viewpoint)).different;
}

/// Returns the steps that sort two polygons seen from +z, and expects a correct picture.
std::vector<NewellStep> ladder(std::vector<glm::dvec3> first, std::vector<glm::dvec3> second) {
    std::vector<Polygon> polygons;
    add(polygons, std::move(first));
    add(polygons, std::move(second));
    const NewellOrder result = newell_order(polygons, viewpoint_on_z(true));
    EXPECT_EQ(wrong_pixels(polygons, result, viewpoint_on_z(true)), 0);
    return result.steps;
}

TEST(Newell, EachTestDecidesItsOwnPair) {
    using enum NewellTest;
    const auto decider = [](std::vector<glm::dvec3> first, std::vector<glm::dvec3> second) {
        return ladder(std::move(first), std::move(second)).front().decided_by;
    };
    EXPECT_EQ(decider(rectangle(-1, 1, -1, 1, -2, -2), rectangle(-1, 1, -1, 1, 0, 0)), depth_extents);
    EXPECT_EQ(decider(rectangle(-2, -1, -1, 1, -2, 0), rectangle(1, 2, -1, 1, -1, 1)), x_extents);
    EXPECT_EQ(decider(rectangle(-1, 1, -2, -1, -2, 0), rectangle(-1, 1, 1, 2, -1, 1)), y_extents);
    // P spans z = −3 to −1, which overlaps Q's −2 to 0, but all of P is one unit behind Q's plane.
    EXPECT_EQ(decider(rectangle(-1, 1, -1, 1, -3, -1), rectangle(-1, 1, -1, 1, -2, 0)), p_behind_q);
    // A small Q is in front of P's plane, while Q's own plane cuts P.
    EXPECT_EQ(decider(rectangle(-2, 2, -1, 1, -4, 0), rectangle(-1, -0.5, -0.5, 0.5, 1, -2)), q_in_front_of_p);
    // The triangles are in the two halves of a square, and their planes cross.
    EXPECT_EQ(decider({{-1, -1, -3}, {0.9, -1, 0}, {-1, 0.9, 0}}, {{1, 1, -2}, {-0.9, 1, 1}, {1, -0.9, -2.5}}),
              projections_disjoint);
}

TEST(Newell, SwapsWhenTheFarthestVertexMisleads) {
    // The wall's farthest vertex is behind the card, but the wall hides the card.
    const std::vector<NewellStep> steps =
        ladder(rectangle(-2, 2, -1, 1, 1, -9), rectangle(-1.4, -0.6, -0.4, 0.4, -5, -5));
    ASSERT_EQ(steps.size(), 4U);
    EXPECT_EQ(steps[0].action, NewellAction::swaps);
    EXPECT_EQ(steps[0].decided_by, NewellTest::q_behind_p);
    EXPECT_EQ(steps[1].action, NewellAction::goes_on);
    EXPECT_EQ(steps[1].p, 1);
    EXPECT_EQ(steps[2].action, NewellAction::draws);
    EXPECT_EQ(steps[2].p, 1);
    EXPECT_EQ(steps[3].p, 0);
}

TEST(Newell, CutsInterpenetrationOnceAndReportsThePlace) {
    const std::vector<NewellStep> steps = ladder(rectangle(-1, 1, -1, 1, -2, 2), rectangle(-1, 1, -1, 1, 1, -1));
    ASSERT_FALSE(steps.empty());
    EXPECT_EQ(steps[0].action, NewellAction::splits);
    EXPECT_EQ(steps[0].decided_by, NewellTest::none);
    EXPECT_EQ(steps[0].split, 0);
    EXPECT_EQ(steps[0].first_piece, 2);
    EXPECT_NEAR(glm::length(glm::dvec3(steps[0].cut_plane)), 1, 1e-12);
    EXPECT_EQ(std::count_if(steps.begin(), steps.end(), [](auto& s) { return s.action == NewellAction::splits; }), 1);
}

TEST(Newell, CutsThreeCyclicBarsOnce) {
    const std::vector<Polygon> bars = cyclic_bars();
    for (const bool orthographic : {false, true}) {
        const Viewpoint viewpoint = viewpoint_on_z(orthographic);
        const NewellOrder result = newell_order(bars, viewpoint);
        EXPECT_EQ(result.counters.splits, 1);
        EXPECT_EQ(result.counters.forced, 0);
        EXPECT_EQ(result.order.size(), 4U);
        EXPECT_EQ(wrong_pixels(bars, result, viewpoint), 0);
    }
}

TEST(Newell, CutsCyclesThatNoPlaneSplitsAlongAnOutline) {
    std::int64_t cuts_through_eye = 0;
    for (int scene = 0; scene < 100; ++scene) {
        SCOPED_TRACE("seed " + std::to_string(seed + scene));
        Random random(seed + scene);
        const std::vector<Polygon> polygons = random_polygons(random);
        const Viewpoint viewpoint = random_viewpoint(random);
        const NewellOrder result = newell_order(polygons, viewpoint);
        for (const NewellStep& step : result.steps) {
            cuts_through_eye +=
                step.action == NewellAction::splits && std::abs(glm::dot(step.cut_plane, viewpoint.eye_world())) < 1e-9;
        }
        EXPECT_EQ(result.counters.forced, 0);
    }
    EXPECT_GT(cuts_through_eye, 0);
}

TEST(Newell, CountersMatchSteps) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int scene = 0; scene < 10; ++scene) {
        const std::vector<Polygon> polygons = random_polygons(random);
        const NewellOrder result = newell_order(polygons, random_viewpoint(random));
        std::int64_t swaps = 0, splits = 0, draws = 0, decided = 0;
        for (const NewellStep& step : result.steps) {
            swaps += step.action == NewellAction::swaps;
            splits += step.action == NewellAction::splits;
            draws += step.action == NewellAction::draws;
        }
        for (const std::int64_t count : result.counters.decided) decided += count;
        EXPECT_EQ(result.steps_left_out, 0);
        EXPECT_EQ(swaps, result.counters.swaps);
        EXPECT_EQ(splits, result.counters.splits);
        EXPECT_EQ(draws, static_cast<std::int64_t>(result.order.size()));
        EXPECT_EQ(decided, result.counters.pairs);
        std::vector<int> order = result.order;
        std::sort(order.begin(), order.end());
        EXPECT_EQ(std::adjacent_find(order.begin(), order.end()), order.end()) << "no polygon is drawn twice";
        EXPECT_EQ(result.fragments.size(), order.size() + static_cast<std::size_t>(splits));
    }
}

TEST(Newell, NeverComparesAReleasedPairAgain) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::int64_t again = 0, let_go_count = 0;
    for (int scene = 0; scene < 20; ++scene) {
        const NewellOrder result = newell_order(random_polygons(random), random_viewpoint(random));
        ASSERT_EQ(result.steps_left_out, 0);
        std::set<std::pair<int, int>> let_go;
        for (const NewellStep& step : result.steps) {
            if (step.action != NewellAction::goes_on || step.decided_by == NewellTest::depth_extents) continue;
            ++let_go_count;
            again += !let_go.emplace(step.p, step.q).second;
        }
    }
    // P may meet Q again only if the farthest corner of Q is exactly as far as the farthest corner of a polygon that P
    // waited for, such as another piece with the same corner.
    EXPECT_LE(again, let_go_count / 100);
    const std::vector<Polygon> large = growth_polygons({.scene = GrowthScene::large_triangles}, 60);
    const NewellOrder result = newell_order(large, viewpoint_on_z());
    EXPECT_TRUE(result.problem.empty());
    const auto pieces = static_cast<std::int64_t>(result.order.size());
    EXPECT_LT(result.counters.pairs, pieces * pieces / 20);
}

TEST(Newell, ShowsTheLowestSourceOfCoplanarOverlaps) {
    std::vector<Polygon> polygons;
    const glm::dvec3 tilt(0, 0, 0.3);
    for (const double y : {0.4, 0.0, -0.4, 0.0}) {
        add(polygons, {glm::dvec3(-1, y - 1, 0) - tilt, glm::dvec3(1, y - 1, 0) + tilt, glm::dvec3(0, y + 1, 0)});
    }
    for (const bool orthographic : {false, true}) {
        const Viewpoint viewpoint = viewpoint_on_z(orthographic);
        const NewellOrder result = newell_order(polygons, viewpoint);
        EXPECT_EQ(result.counters.splits, 0);
        EXPECT_EQ(wrong_pixels(polygons, result, viewpoint), 0);
    }
}

TEST(Newell, EdgeOnPolygonsHideNothing) {
    std::vector<Polygon> polygons;
    add(polygons, {{0, -2, -2}, {0, -2, 2}, {0, 2, 0}});
    add(polygons, rectangle(-1, 1, -1, 1, -1, 1));
    const Viewpoint viewpoint = viewpoint_on_z(true);
    const NewellOrder result = newell_order(polygons, viewpoint);
    EXPECT_EQ(result.counters.splits, 0);
    EXPECT_EQ(result.order.size(), 2U);
    EXPECT_EQ(wrong_pixels(polygons, result, viewpoint), 0);
}

TEST(Newell, ClipsAtTheNearPlaneAndCountsTheLoss) {
    const Mesh box = box_mesh();
    const MeshInstance instance{&box};
    const std::vector<Polygon> polygons = polygons_of(std::span(&instance, 1)).polygons;
    const Viewpoint inside = viewpoint_at({0, 0, 0}, {0, 0, -1}, {.near = 0.5});
    const NewellOrder result = newell_order(polygons, inside);
    EXPECT_NEAR(result.clipped_area, 4 + 4 * 2 * 1.5, 1e-9) << "everything behind z = −0.5";
    EXPECT_EQ(wrong_pixels(polygons, result, inside), 0);
}

TEST(Newell, StopsWithASentenceAndLosesNothing) {
    Random random(seed);
    std::vector<Polygon> polygons;
    for (int i = 0; i < 60; ++i) add(polygons, {random.vec3(2), random.vec3(2), random.vec3(2)});
    const Viewpoint viewpoint = viewpoint_on_z();
    const auto expect_stopped = [&](const NewellOrder& result, const std::string& problem) {
        EXPECT_EQ(say(result.problem), problem);
        double drawn = 0;
        for (const int fragment : result.order) drawn += area(result.fragments[fragment]);
        EXPECT_NEAR(drawn, total_area(polygons), 1e-9 * drawn);
    };
    expect_stopped(newell_order(polygons, viewpoint, {.max_fragments = 80}),
                   "Newell's sort stopped at its budget of 80 fragments; the rest is sorted by farthest vertex.");
    expect_stopped(newell_order(polygons, viewpoint, {.max_pairs = 50}),
                   "Newell's sort stopped at its budget of 50 comparisons; the rest is sorted by farthest vertex.");
    const NewellOrder few_steps = newell_order(polygons, viewpoint, {.max_steps = 10});
    EXPECT_EQ(few_steps.steps.size(), 10U);
    EXPECT_GT(few_steps.steps_left_out, 100);
    WorkProgress progress;
    progress.canceled = true;
    expect_stopped(newell_order(polygons, viewpoint, {}, &progress),
                   "Newell's sort was canceled; the rest is sorted by farthest vertex.");
    EXPECT_TRUE(newell_order({}, viewpoint).order.empty());
}

}  // namespace
}  // namespace viewing
