// The search for a view where a sort key fails: it finds such a view if there is one, and otherwise reports none.
#include "topics/hidden/methods/failure_search.h"

#include <gtest/gtest.h>

#include <limits>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

constexpr std::array keys{PainterKey::nearest, PainterKey::farthest, PainterKey::centroid};

Orbit orbit_about(const glm::dvec3& target, bool orthographic = false) {
    return {target, 8.0, clip_from_view({.orthographic = orthographic}, 16.0 / 9.0)};
}

/// Counts the wrong pixels away from edges in the painter's picture without the search's own code: world_from_view()
/// makes the view from its angles, and the picture is larger.
std::int64_t wrong_pixels(std::span<const Polygon> polygons, const Orbit& orbit, const FailureView& found,
                          PainterKey key) {
    const Viewpoint viewpoint{
        view_from_world(world_from_view(found.position_world, {found.view.yaw_deg, found.view.pitch_deg, 0.0})),
        orbit.clip_from_view};
    EXPECT_NEAR(glm::length(found.position_world - orbit.target_world), orbit.distance, 1e-12);
    const glm::dvec3 target_view(viewpoint.view_from_world * glm::dvec4(orbit.target_world, 1.0));
    EXPECT_NEAR(glm::length(target_view - glm::dvec3(0, 0, -orbit.distance)), 0.0, 1e-12) << "looks at the target";
    const glm::dmat4 clip_from_world = viewpoint.clip_from_world();
    const IdImage reference = cast_rays(RayScene(polygons), clip_from_world, {.width = 192, .height = 108}).image;
    const PainterOrder order = painter_order(polygons, viewpoint, key);
    const IdImage painted =
        rasterize(polygons, order.order, clip_from_world, {.rule = PaintRule::overwrite, .width = 192, .height = 108})
            .image;
    return difference(reference, painted).different;
}

/// Returns a slanted wall and a small card in front of or behind it. In some view from the front, the key sorts them
/// wrongly.
std::vector<Polygon> scene_for(PainterKey key) {
    std::vector<Polygon> polygons;
    add(polygons, {{-2, -1, 2}, {2, -1, -3}, {2, 1, -3}, {-2, 1, 2}});
    const double x = key == PainterKey::nearest ? 1 : -1;
    const double z = key == PainterKey::nearest ? 0 : key == PainterKey::farthest ? -1.5 : -0.2;
    add(polygons, {{x - 0.4, -0.5, z}, {x + 0.4, -0.5, z}, {x + 0.4, 0.5, z}, {x - 0.4, 0.5, z}});
    return polygons;
}

TEST(FailureSearch, FindsAViewForEachKey) {
    for (const bool orthographic : {false, true}) {
        for (const PainterKey key : keys) {
            SCOPED_TRACE(testing::Message() << "key " << static_cast<int>(key) << ", orthographic " << orthographic);
            const std::vector<Polygon> polygons = scene_for(key);
            const Orbit orbit = orbit_about({0, 0, -0.5}, orthographic);
            const FailureView found = find_failure(polygons, orbit, {.key = key});
            EXPECT_TRUE(found.found);
            EXPECT_GT(found.wrong_pixels, 20);
            EXPECT_EQ(found.compared, 96 * 54);
            EXPECT_GT(found.views_tried, 96);
            EXPECT_GT(wrong_pixels(polygons, orbit, found, key), 4 * 20);
            char share[32];
            std::snprintf(share, sizeof share, "%.1f%%",
                          100.0 * static_cast<double>(found.wrong_pixels) / static_cast<double>(found.compared));
            EXPECT_NE(say(found.sentence).find(share), std::string::npos) << say(found.sentence);
        }
    }
}

TEST(FailureSearch, FoundViewsAlsoFailOnRandomScenes) {
    for (int scene = 0; scene < 12; ++scene) {
        SCOPED_TRACE("seed " + std::to_string(seed + scene));
        Random random(seed + scene);
        const std::vector<Polygon> polygons = random_polygons(random);
        const PainterKey key = keys.at(scene % 3);
        const Orbit orbit = orbit_about(random.vec3(0.5), scene % 2 == 0);
        const OrbitView start{random.number(-180, 180), random.number(-60, 20)};
        const FailureView found = find_failure(polygons, orbit, {.key = key, .start = start});
        if (!found.found) continue;
        EXPECT_LE(found.view.pitch_deg, std::max(start.pitch_deg, 0.0));
        if (found.wrong_pixels > 10) {
            EXPECT_GT(wrong_pixels(polygons, orbit, found, key), 0);
        }
        // The search must find nearly the worst view: in an independent scan, no view may have many more wrong pixels.
        // The scan's pictures have four times as many pixels.
        FailureView other = found;
        for (int i = 0; i < 12; ++i) {
            other.view = {start.yaw_deg + 30.0 * i, start.pitch_deg};
            other.position_world = eye_on_orbit(orbit, other.view);
            EXPECT_LE(wrong_pixels(polygons, orbit, other, key), 4.4 * static_cast<double>(found.wrong_pixels) + 40);
        }
    }
}

TEST(FailureSearch, ReportsThatNoViewFails) {
    std::vector<Polygon> one;
    add(one, {{-1, -1, 0}, {1, -1, 0.5}, {0, 1, 1}});
    // Two equal parallel triangles, one behind the other: every key sorts them correctly from everywhere.
    std::vector<Polygon> two = one;
    add(two, {{-1, -1, 3}, {1, -1, 3.5}, {0, 1, 4}});
    for (const std::vector<Polygon>& polygons : {one, two}) {
        for (const PainterKey key : keys) {
            const FailureView none = find_failure(polygons, orbit_about({0, 0, 1}, true), {.key = key});
            EXPECT_FALSE(none.found);
            EXPECT_EQ(none.wrong_pixels, 0);
            EXPECT_EQ(none.views_tried, 2 * 96);
            EXPECT_NE(say(none.sentence).find("Views tried: 192"), std::string::npos) << say(none.sentence);
        }
    }
}

TEST(FailureSearch, IsRepeatableAndStartsAtTheCamera) {
    const std::vector<Polygon> polygons = scene_for(PainterKey::centroid);
    const FailureSearchOptions options{.key = PainterKey::centroid, .start = {33.0, -20.0}};
    const FailureView once = find_failure(polygons, orbit_about({0, 0, 0}), options);
    const FailureView again = find_failure(polygons, orbit_about({0, 0, 0}), options);
    EXPECT_EQ(once.view.yaw_deg, again.view.yaw_deg);
    EXPECT_EQ(once.view.pitch_deg, again.view.pitch_deg);
    EXPECT_EQ(once.sentence, again.sentence);
    const FailureView none = find_failure(std::span(polygons).first(1), orbit_about({0, 0, 0}), options);
    EXPECT_EQ(none.view.yaw_deg, 33.0);
    EXPECT_EQ(none.view.pitch_deg, -20.0);
    EXPECT_EQ(none.position_world, eye_on_orbit(orbit_about({0, 0, 0}), options.start));
}

TEST(FailureSearch, CanBeCanceled) {
    const std::vector<Polygon> polygons = scene_for(PainterKey::farthest);
    WorkProgress progress;
    const FailureView whole = find_failure(polygons, orbit_about({0, 0, 0}), {}, &progress);
    EXPECT_FALSE(whole.canceled);
    EXPECT_GT(progress.fraction.load(), 0.4F);
    progress.canceled = true;
    const FailureView canceled = find_failure(polygons, orbit_about({0, 0, 0}), {}, &progress);
    EXPECT_TRUE(canceled.canceled);
    EXPECT_FALSE(canceled.found);
    EXPECT_EQ(canceled.views_tried, 0);
    EXPECT_NE(say(canceled.sentence).find("canceled"), std::string::npos) << say(canceled.sentence);
}

TEST(FailureSearch, ReportsDegenerateInputWithoutSearching) {
    const std::vector<Polygon> polygons = scene_for(PainterKey::farthest);
    Orbit endless = orbit_about({0, 0, 0});
    endless.distance = std::numeric_limits<double>::infinity();
    for (const FailureView& view :
         {find_failure({}, orbit_about({0, 0, 0}), {}), find_failure(polygons, orbit_about({0, 0, 0}), {.width = 0}),
          find_failure(polygons, endless, {})}) {
        EXPECT_FALSE(view.found);
        EXPECT_EQ(view.views_tried, 0);
        EXPECT_FALSE(view.sentence.empty());
    }
    Orbit at_target = orbit_about({0, 0, 0});
    at_target.distance = 0.0;
    EXPECT_GT(find_failure(polygons, at_target, {}).views_tried, 0);
}

}  // namespace
}  // namespace viewing
