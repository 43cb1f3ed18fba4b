// The BSP tree: it preserves area, does not depend on the eye, visits each polygon once, draws correctly, and survives
// degenerate input.
#include "topics/hidden/methods/bsp.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

constexpr std::array splitters{BspSplitter::first, BspSplitter::random, BspSplitter::fewest_splits,
                               BspSplitter::balanced};

/// Expects every structural property of a finished tree: front children are in front, fragments in their node's plane.
void expect_well_formed(const BspTree& tree, std::span<const Polygon> input) {
    EXPECT_NEAR(total_area(tree.fragments), total_area(input), 1e-9 * total_area(input));
    std::vector<int> held(tree.fragments.size(), 0);
    int splits = 0, depth = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const BspNode& node = tree.nodes[i];
        splits += node.split_count;
        depth = std::max(depth, node.depth);
        EXPECT_EQ(node.input_count + node.split_count, node.fragment_count + node.front_count + node.back_count);
        EXPECT_GE(node.fragment_count, 1);
        for (int k = 0; k < node.fragment_count; ++k) {
            ++held.at(static_cast<std::size_t>(node.first_fragment + k));
            const Polygon& fragment = tree.fragments[static_cast<std::size_t>(node.first_fragment + k)];
            EXPECT_EQ(side_of_plane(fragment, node.plane, 2 * tree.epsilon), PlaneSide::coplanar);
            // For every ancestor, the fragment lies on the side that the tree records.
            for (int child = static_cast<int>(i), up = node.parent; up >= 0; child = up, up = tree.nodes[up].parent) {
                const bool is_front = tree.nodes[up].front == child;
                EXPECT_NE(is_front, tree.nodes[up].back == child);
                const PlaneSide side = side_of_plane(fragment, tree.nodes[up].plane, 2 * tree.epsilon);
                EXPECT_TRUE(side == PlaneSide::coplanar || side == (is_front ? PlaneSide::front : PlaneSide::back));
            }
        }
    }
    EXPECT_TRUE(std::all_of(held.begin(), held.end(), [](int count) { return count == 1; }));
    EXPECT_EQ(splits, tree.counters.splits);
    EXPECT_EQ(depth, tree.counters.depth);
    EXPECT_EQ(tree.fragments.size(), input.size() + static_cast<std::size_t>(splits));
}

void expect_every_fragment_once(const BspTree& tree, const BspWalk& walk) {
    std::vector<int> seen = walk.fragments;
    std::sort(seen.begin(), seen.end());
    ASSERT_EQ(seen.size(), tree.fragments.size());
    for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], static_cast<int>(i));
    EXPECT_EQ(walk.visits.size(), tree.nodes.size());
}

TEST(Bsp, IsRightOnRandomScenesForEverySplitter) {
    for (int scene = 0; scene < 12; ++scene) {
        SCOPED_TRACE(seed + scene);
        Random random(seed + scene);
        const std::vector<Polygon> polygons = random_polygons(random);
        for (const BspSplitter splitter : splitters) {
            const BspTree tree = build_bsp(polygons, {.splitter = splitter});
            EXPECT_EQ(say(tree.problem), "");
            expect_well_formed(tree, polygons);
            const Viewpoint viewpoint = random_viewpoint(random);
            const BspWalk back_to_front = walk_bsp(tree, viewpoint.eye_world(), BspOrder::back_to_front);
            BspWalk front_to_back = walk_bsp(tree, viewpoint.eye_world(), BspOrder::front_to_back);
            expect_every_fragment_once(tree, back_to_front);
            expect_every_fragment_once(tree, front_to_back);
            std::reverse(front_to_back.fragments.begin(), front_to_back.fragments.end());
            EXPECT_EQ(back_to_front.fragments, front_to_back.fragments);
            const IdImage reference = ray_cast_image(polygons, viewpoint);
            EXPECT_EQ(difference(reference, paint(tree.fragments, back_to_front.fragments, viewpoint)).different, 0);
        }
    }
}

TEST(Bsp, WalkReportsTheEyeSideOfEachPlane) {
    Random random(seed);
    const BspTree tree = build_bsp(random_polygons(random));
    const Viewpoint viewpoint = random_viewpoint(random);
    for (const BspVisit& visit : walk_bsp(tree, viewpoint.eye_world(), BspOrder::back_to_front).visits) {
        const double distance = glm::dot(tree.nodes[visit.node].plane, viewpoint.eye_world());
        EXPECT_EQ(visit.eye_side, distance > 0 ? 1 : -1);
    }
}

TEST(Bsp, OneTreeServesEveryCameraAndRebuildsEqual) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<Polygon> polygons = random_polygons(random);
    for (const BspSplitter splitter : splitters) {
        const BspTree tree = build_bsp(polygons, {.splitter = splitter});
        for (int i = 0; i < 10; ++i) {
            const Viewpoint viewpoint = random_viewpoint(random);
            const BspWalk walk = walk_bsp(tree, viewpoint.eye_world(), BspOrder::back_to_front);
            expect_every_fragment_once(tree, walk);
            const IdImage image = paint(tree.fragments, walk.fragments, viewpoint);
            EXPECT_EQ(difference(ray_cast_image(polygons, viewpoint), image).different, 0);
        }
        const BspTree again = build_bsp(polygons, {.splitter = splitter});
        ASSERT_EQ(again.nodes.size(), tree.nodes.size());
        ASSERT_EQ(again.fragments.size(), tree.fragments.size());
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            EXPECT_EQ(again.nodes[i].plane, tree.nodes[i].plane);
            EXPECT_EQ(again.nodes[i].front, tree.nodes[i].front);
            EXPECT_EQ(again.nodes[i].back, tree.nodes[i].back);
        }
        for (std::size_t i = 0; i < tree.fragments.size(); ++i) {
            EXPECT_EQ(again.fragments[i].vertices, tree.fragments[i].vertices);
        }
    }
}

TEST(Bsp, FewestSplitsCutsLessAndBalancedIsShallower) {
    Random random(seed);
    std::vector<Polygon> polygons;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 at = random.vec3(4);
        add(polygons, {at + random.vec3(0.5), at + random.vec3(0.5), at + random.vec3(0.5)});
    }
    const auto counters = [&](BspSplitter splitter) { return build_bsp(polygons, {.splitter = splitter}).counters; };
    EXPECT_LT(counters(BspSplitter::fewest_splits).splits, counters(BspSplitter::first).splits / 2);
    EXPECT_LT(counters(BspSplitter::balanced).depth, counters(BspSplitter::first).depth);
    EXPECT_LE(counters(BspSplitter::balanced).depth, counters(BspSplitter::fewest_splits).depth);
    EXPECT_EQ(counters(BspSplitter::random).splits, counters(BspSplitter::random).splits) << "the seed is fixed";
}

TEST(Bsp, DrawsThreeCyclicBarsRightFromAllSides) {
    const std::vector<Polygon> bars = cyclic_bars();
    const BspTree tree = build_bsp(bars);
    EXPECT_GE(tree.counters.splits, 1);
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
        const Viewpoint viewpoint = random_viewpoint(random);
        const BspWalk walk = walk_bsp(tree, viewpoint.eye_world(), BspOrder::back_to_front);
        EXPECT_EQ(
            difference(ray_cast_image(bars, viewpoint), paint(tree.fragments, walk.fragments, viewpoint)).different, 0);
    }
}

TEST(Bsp, ConvexMeshIsAChainWithoutSplits) {
    const Mesh cone = cone_mesh(24);
    const MeshInstance instance{&cone};
    const std::vector<Polygon> polygons = polygons_of(std::span(&instance, 1)).polygons;
    const BspTree tree = build_bsp(polygons);
    EXPECT_EQ(tree.counters.splits, 0);
    EXPECT_EQ(tree.nodes.size(), 25U) << "the base is one plane";
    EXPECT_EQ(tree.counters.depth, 25);
    for (const BspNode& node : tree.nodes) EXPECT_EQ(node.front, -1);
    const Viewpoint inside = viewpoint_at({0, -0.3, 0.2}, {0.3, -0.4, -1}, {.near = 0.01});
    const BspWalk walk = walk_bsp(tree, inside.eye_world(), BspOrder::back_to_front);
    EXPECT_EQ(difference(ray_cast_image(polygons, inside), paint(tree.fragments, walk.fragments, inside)).different, 0)
        << "from inside a mesh the eye sees its far side";
}

TEST(Bsp, CoplanarPolygonsShareANodeAndTheLowestNumberWins) {
    std::vector<Polygon> polygons;
    add(polygons, {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    add(polygons, {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    add(polygons, {{-1, 1, 0}, {1, 1, 0}, {0, -1, 0}});
    add(polygons, {{-1, -1, 0}, {0, 1, 0}, {1, -1, 0}});  // flipped
    const Viewpoint viewpoint = viewpoint_on_z();
    const IdImage reference = ray_cast_image(polygons, viewpoint);
    EXPECT_EQ(std::count(reference.ids.begin(), reference.ids.end(), 1), 0);
    EXPECT_GT(std::count(reference.ids.begin(), reference.ids.end(), 0), 100);
    EXPECT_GT(std::count(reference.ids.begin(), reference.ids.end(), 2), 50);
    EXPECT_EQ(difference(reference, zbuffer_image(polygons, viewpoint)).different, 0);
    for (const BspSplitter splitter : splitters) {
        const BspTree tree = build_bsp(polygons, {.splitter = splitter});
        EXPECT_EQ(tree.nodes.size(), 1U);
        EXPECT_EQ(tree.nodes[0].fragment_count, 4);
        for (const auto& [order, rule] : {std::pair(BspOrder::back_to_front, PaintRule::overwrite),
                                          std::pair(BspOrder::front_to_back, PaintRule::keep_first)}) {
            const BspWalk walk = walk_bsp(tree, viewpoint.eye_world(), order);
            EXPECT_EQ(difference(reference, paint(tree.fragments, walk.fragments, viewpoint, rule)).different, 0);
        }
    }
}

TEST(Bsp, EyeInASplittingPlaneSeesTheRestRight) {
    // The eye and the view direction are in the plane of the first polygon, which divides the other two.
    std::vector<Polygon> polygons;
    add(polygons, {{0, -2, -2}, {0, -2, 2}, {0, 2, 0}});
    add(polygons, {{0.5, -1, 0}, {2, -1, 0}, {1, 1, 0}});
    add(polygons, {{-2, -1, 0}, {-0.5, -1, 0}, {-1, 1, 0}});
    const BspTree tree = build_bsp(polygons, {.splitter = BspSplitter::first});
    ASSERT_EQ(tree.nodes.size(), 3U);
    for (const bool orthographic : {false, true}) {
        const Viewpoint viewpoint = viewpoint_on_z(orthographic);
        for (const BspOrder order : {BspOrder::back_to_front, BspOrder::front_to_back}) {
            const BspWalk walk = walk_bsp(tree, viewpoint.eye_world(), order);
            EXPECT_EQ(walk.visits[1].eye_side, 0);
            expect_every_fragment_once(tree, walk);
            EXPECT_EQ(difference(ray_cast_image(polygons, viewpoint),
                                 paint(tree.fragments, walk.fragments, viewpoint,
                                       order == BspOrder::back_to_front ? PaintRule::overwrite : PaintRule::keep_first))
                          .different,
                      0);
        }
    }
}

TEST(Bsp, SliversKeepTheirArea) {
    SCOPED_TRACE(seed);
    Random random(seed);
    std::vector<Polygon> polygons;
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 a = random.vec3(2), b = random.vec3(2);
        add(polygons, {a, b, 0.5 * (a + b) + 1e-7 * random.direction()});
    }
    expect_well_formed(build_bsp(polygons), polygons);
}

TEST(Bsp, StopsAtItsBudgetWithASentenceAndLosesNothing) {
    Random random(seed);
    std::vector<Polygon> polygons;
    for (int i = 0; i < 60; ++i) add(polygons, {random.vec3(2), random.vec3(2), random.vec3(2)});
    const BspTree tree = build_bsp(polygons, {.splitter = BspSplitter::first, .max_fragments = 100});
    EXPECT_EQ(say(tree.problem), "The BSP tree stopped at its budget of 100 fragments; the rest is drawn unsorted.");
    EXPECT_NEAR(total_area(tree.fragments), total_area(polygons), 1e-9 * total_area(polygons));
    EXPECT_LT(tree.fragments.size(), 160U);
    EXPECT_TRUE(std::any_of(tree.nodes.begin(), tree.nodes.end(), [](const BspNode& n) { return !n.sorted; }));
    expect_every_fragment_once(tree, walk_bsp(tree, {0, 0, 10, 1}, BspOrder::back_to_front));
}

TEST(Bsp, HandlesCancellationAndEmptyInput) {
    Random random(seed);
    const std::vector<Polygon> polygons = random_polygons(random);
    WorkProgress progress;
    EXPECT_EQ(say(build_bsp(polygons, {}, &progress).problem), "");
    EXPECT_EQ(progress.fraction, 1.0F);
    progress.canceled = true;
    const BspTree canceled = build_bsp(polygons, {}, &progress);
    EXPECT_EQ(say(canceled.problem), "The BSP tree is not finished: it was canceled.");
    EXPECT_EQ(canceled.nodes.size(), 1U);
    EXPECT_EQ(canceled.fragments.size(), polygons.size());
    const BspTree empty = build_bsp({});
    EXPECT_TRUE(empty.nodes.empty());
    EXPECT_TRUE(walk_bsp(empty, {0, 0, 1, 1}, BspOrder::back_to_front).fragments.empty());
}

}  // namespace
}  // namespace viewing
