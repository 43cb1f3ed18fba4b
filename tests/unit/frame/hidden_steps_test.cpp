// The methods step by step, as the frame shows them. See also plan_hidden_test.cpp.
#include <algorithm>
#include <set>

#include "unit/frame/hidden_scenes.h"

namespace viewing {
namespace {

using testing::hidden_px;
using testing::random_scene;
using testing::request_of;
using testing::with_method;

/// A scene and a view that give every method work to do.
class HiddenSteps : public ::testing::Test {
protected:
    HiddenSteps() {
        Random random(seed + 7);
        scene = random_scene(random);
        Params params;
        params.camera.position = {1.0, 2.0, 7.0};
        const Angles angles = angles_looking_at(params.camera.position, {0, 0, 0});
        params.camera.yaw = angles.yaw_deg;
        params.camera.pitch = angles.pitch_deg;
        request = request_of(params, scene, hidden_px);
    }

    std::shared_ptr<const HiddenResult> at(VisibilityMethod method, int step) {
        return solver().solve(with_method(request, method, step));
    }
    HiddenSurfaceSolver& solver() {
        if (!solver_) solver_.emplace(scene);
        return *solver_;
    }

    Scene scene;
    HiddenRequest request;

private:
    std::optional<HiddenSurfaceSolver> solver_;
};

TEST_F(HiddenSteps, OfThePainterDrawOnePolygonEach) {
    const auto whole = at(VisibilityMethod::painter, -1);
    const int count = static_cast<int>(solver().surface()->polygons.size());
    EXPECT_EQ(whole->step_count, count);
    for (int step = 0; step < count; ++step) {
        const auto result = at(VisibilityMethod::painter, step);
        EXPECT_EQ(result->step, step);
        EXPECT_EQ(result->drawn, step);
        EXPECT_EQ(result->order, whole->order);
        const RasterResult painted =
            rasterize(*whole->fragments, std::span(whole->order.data(), static_cast<std::size_t>(step)),
                      request.viewpoint.clip_from_world(),
                      {.rule = PaintRule::overwrite, .width = hidden_px.x, .height = hidden_px.y});
        EXPECT_EQ(result->image.ids, painted.image.ids);
        EXPECT_EQ(result->counters.pixels_written, painted.counters.pixels_written);
    }
    for (const int step : {count, count + 1, 1'000'000}) {
        EXPECT_EQ(at(VisibilityMethod::painter, step)->step, -1);
        EXPECT_EQ(at(VisibilityMethod::painter, step)->image.ids, whole->image.ids);
    }
}

TEST_F(HiddenSteps, OfNewellAreTestsOfTheLadder) {
    const auto whole = at(VisibilityMethod::newell, -1);
    ASSERT_EQ(whole->newell->steps_left_out, 0);
    EXPECT_EQ(whole->step_count, static_cast<int>(whole->newell->steps.size()));
    EXPECT_GT(whole->counters.splits, 0) << "the scene is too easy";
    int drawn = 0;
    for (int step = 0; step < whole->step_count; ++step) {
        const auto result = at(VisibilityMethod::newell, step);
        EXPECT_EQ(result->newell, whole->newell) << "all steps share one order";
        EXPECT_EQ(result->drawn, drawn);
        const NewellAction action = whole->newell->steps[static_cast<std::size_t>(step)].action;
        drawn += action == NewellAction::draws || action == NewellAction::forces;
    }
    EXPECT_EQ(drawn, static_cast<int>(whole->order.size()));
    EXPECT_EQ(whole->drawn, drawn);
}

TEST_F(HiddenSteps, OfTheTreeBuildItAndThenWalkIt) {
    for (const bool culls : {false, true}) {
        request.cull.enabled = culls;
        const auto whole = at(VisibilityMethod::bsp, -1);
        const int nodes = static_cast<int>(whole->tree->nodes.size());
        EXPECT_EQ(whole->step_count, 2 * nodes);
        EXPECT_EQ(whole->counters.culled > 0, culls);
        for (int step = 0; step < whole->step_count; ++step) {
            const auto result = at(VisibilityMethod::bsp, step);
            EXPECT_EQ(result->built_nodes, std::min(step, nodes));
            EXPECT_EQ(result->visited_nodes, std::max(0, step - nodes));
            std::set<int> reached;
            for (int visit = 0; visit < result->visited_nodes; ++visit) {
                const BspNode& node =
                    whole->tree
                        ->nodes[static_cast<std::size_t>(whole->walk->visits[static_cast<std::size_t>(visit)].node)];
                for (int i = 0; i < node.fragment_count; ++i) reached.insert(node.first_fragment + i);
            }
            ASSERT_LE(result->drawn, static_cast<int>(result->order.size()));
            for (int place = 0; place < result->drawn; ++place)
                EXPECT_TRUE(reached.contains(result->order[static_cast<std::size_t>(place)]));
            if (result->drawn < static_cast<int>(result->order.size())) {
                EXPECT_FALSE(reached.contains(result->order[static_cast<std::size_t>(result->drawn)]));
            }
        }
    }
}

TEST_F(HiddenSteps, OfTheTreeShareOneTreeForEveryEye) {
    const auto here = at(VisibilityMethod::bsp, -1);
    request.viewpoint.view_from_world[3].x += 2.0;
    request.viewpoint.view_from_world[3].z += 4.0;
    const auto there = at(VisibilityMethod::bsp, -1);
    EXPECT_EQ(here->tree, there->tree);
    EXPECT_NE(here->walk, there->walk);
    for (const auto& result : {here, there}) {
        std::set<int> nodes;
        for (const BspVisit& visit : result->walk->visits) nodes.insert(visit.node);
        EXPECT_EQ(nodes.size(), result->tree->nodes.size());
        EXPECT_EQ(nodes.size(), result->walk->visits.size());
    }
    request.visibility.splitter = BspSplitter::first;
    EXPECT_NE(at(VisibilityMethod::bsp, -1)->tree, here->tree);
}

TEST_F(HiddenSteps, OfTheDepthBufferCompareOneFragmentEach) {
    const auto whole = at(VisibilityMethod::software_depth_buffer, -1);
    const auto& polygons = *whole->fragments;
    std::vector<IdImage> alone;  // the coverage of each polygon alone
    std::vector<int> tested{0};  // the number of fragments tested before each polygon
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        alone.push_back(rasterize(std::span(&polygons[i], 1), request.viewpoint.clip_from_world(),
                                  {.width = hidden_px.x, .height = hidden_px.y})
                            .image);
        const auto covered = std::ranges::count_if(alone.back().ids, [](int id) { return id >= 0; });
        tested.push_back(tested.back() + static_cast<int>(covered));
    }
    ASSERT_EQ(whole->step_count, tested.back());
    for (int step = 1; step < whole->step_count; step += 13) {
        const auto result = at(VisibilityMethod::software_depth_buffer, step);
        const auto current = static_cast<std::size_t>(std::ranges::lower_bound(tested, step) - tested.begin()) - 1;
        ASSERT_TRUE(result->compare);
        EXPECT_EQ(result->counters.pixels_tested, step);
        EXPECT_EQ(result->compare->polygon, static_cast<int>(current));
        EXPECT_EQ(result->drawn, static_cast<int>(polygons.size())) << "the steps are fragments, not polygons";
        const std::size_t pixel = result->image.index(result->compare->x, result->compare->y);
        const double depth = alone[current].depths[pixel];
        EXPECT_EQ(result->compare->depth, depth);
        double stored = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < current; ++i) stored = std::min(stored, alone[i].depths[pixel]);
        if (std::isfinite(stored)) {
            EXPECT_NEAR(result->compare->stored_depth, stored, 1e-12);
        } else {
            EXPECT_EQ(result->compare->stored_depth, stored);
        }
        if (std::abs(depth - stored) > 1e-11) {
            EXPECT_EQ(result->compare->written, depth < stored);
        }
        EXPECT_EQ(result->image.ids[pixel] == polygons[current].source, result->compare->written);
    }
}

/// Returns false if rounding would decide. Otherwise, sets `meets_it` to whether the ray hits the polygon, judged by
/// where the ray meets the polygon's plane and on which side of each edge that point is.
bool meets(const Polygon& polygon, const Ray& ray, double max_t, bool& meets_it) {
    const double slope = glm::dot(glm::dvec3(polygon.plane), ray.direction);
    if (std::abs(slope) < 1e-9) return false;
    const double t = -glm::dot(polygon.plane, glm::dvec4(ray.origin, 1.0)) / slope;
    if (std::abs(t) < 1e-9 || std::abs(t - max_t) < 1e-9) return false;
    const glm::dvec3 point = ray.origin + t * ray.direction;
    meets_it = t > 0.0 && t < max_t;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
        const glm::dvec3& from = polygon.vertices[i];
        const glm::dvec3& to = polygon.vertices[(i + 1) % polygon.vertices.size()];
        const double side = glm::dot(glm::cross(to - from, point - from), glm::dvec3(polygon.plane));
        if (std::abs(side) < 1e-9) return false;
        meets_it &= side > 0.0;
    }
    return true;
}

TEST_F(HiddenSteps, OfRayCastingAreOneRayEachWithAllItsHits) {
    const auto whole = at(VisibilityMethod::ray_cast, -1);
    EXPECT_EQ(whole->step_count, hidden_px.x * hidden_px.y);
    EXPECT_FALSE(whole->traced);
    int hits = 0, sure = 0;
    for (int step = 1; step < whole->step_count; step += 7) {
        const auto result = at(VisibilityMethod::ray_cast, step);
        EXPECT_EQ(result->counters.rays, step);
        ASSERT_TRUE(result->traced);
        const TracedRay& traced = *result->traced;
        EXPECT_EQ(traced.pixel, glm::ivec2((step - 1) % hidden_px.x, (step - 1) / hidden_px.x));
        for (int pixel = 0; pixel < whole->step_count; ++pixel) {
            const auto at_pixel = static_cast<std::size_t>(pixel);
            EXPECT_EQ(result->image.ids[at_pixel], pixel < step ? whole->image.ids[at_pixel] : IdImage::background);
        }
        const int seen = result->image.id(traced.pixel.x, traced.pixel.y);
        EXPECT_EQ(traced.hits.empty() ? IdImage::background : traced.hits.front().source, seen);
        EXPECT_TRUE(std::ranges::is_sorted(traced.hits, {}, &RayCastHit::t));

        const double max_t = PixelRays(request.viewpoint.clip_from_world(), hidden_px.x, hidden_px.y)
                                 .through(traced.pixel.x, traced.pixel.y)
                                 .max_t;
        std::size_t expected = 0;
        bool all_sure = true;
        for (const Polygon& polygon : *result->fragments) {
            bool is_hit = false;
            all_sure &= meets(polygon, traced.ray, max_t, is_hit);
            expected += is_hit;
        }
        if (all_sure) {
            EXPECT_EQ(traced.hits.size(), expected);
            hits += static_cast<int>(expected);
            ++sure;
        }
    }
    EXPECT_GT(hits, 20);
    EXPECT_GT(sure, 200);
}

}  // namespace
}  // namespace viewing
