// The naive painter's algorithm: it sorts correctly, counts its work, and fails where it must.
#include "topics/hidden/methods/painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "unit/methods/scenes.h"

namespace viewing {
namespace {

std::int64_t wrong_pixels(std::span<const Polygon> polygons, std::span<const int> order, const Viewpoint& viewpoint) {
    return difference(ray_cast_image(polygons, viewpoint), paint(polygons, order, viewpoint)).different;
}

std::int64_t wrong_pixels(std::span<const Polygon> polygons, PainterKey key) {
    const Viewpoint viewpoint = viewpoint_on_z(true);
    return wrong_pixels(polygons, painter_order(polygons, viewpoint, key).order, viewpoint);
}

TEST(PainterOrder, HasEachPolygonOnceByDescendingKey) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int scene = 0; scene < 20; ++scene) {
        const std::vector<Polygon> polygons = random_polygons(random);
        const Viewpoint viewpoint = random_viewpoint(random);
        for (const PainterKey key : {PainterKey::nearest, PainterKey::farthest, PainterKey::centroid}) {
            const PainterOrder result = painter_order(polygons, viewpoint, key);
            for (std::size_t i = 0; i < polygons.size(); ++i) {
                std::vector<double> distances;
                for (const glm::dvec3& v : polygons[i].vertices) {
                    distances.push_back(-(viewpoint.view_from_world * glm::dvec4(v, 1)).z);
                }
                const auto [low, high] = std::minmax_element(distances.begin(), distances.end());
                const double mean =
                    std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());
                EXPECT_NEAR(result.distances[i],
                            key == PainterKey::nearest    ? *low
                            : key == PainterKey::farthest ? *high
                                                          : mean,
                            1e-12);
            }
            for (std::size_t i = 1; i < result.order.size(); ++i) {
                EXPECT_GE(result.distances[result.order[i - 1]], result.distances[result.order[i]]);
            }
            std::vector<int> sorted = result.order;
            std::sort(sorted.begin(), sorted.end());
            for (std::size_t i = 0; i < polygons.size(); ++i) EXPECT_EQ(sorted.at(i), static_cast<int>(i));
            EXPECT_EQ(sorted.size(), polygons.size());
        }
    }
}

TEST(PainterOrder, ComparisonsGrowAsNLogN) {
    Random random(seed);
    std::vector<Polygon> polygons;
    for (int i = 0; i < 1024; ++i) {
        const glm::dvec3 at = random.vec3(5);
        add(polygons, {at, at + glm::dvec3(0.1, 0, 0), at + glm::dvec3(0, 0.1, 0)});
    }
    const PainterOrder result = painter_order(polygons, viewpoint_on_z(), PainterKey::nearest);
    EXPECT_GT(result.comparisons, 1024 * 10);
    EXPECT_LT(result.comparisons, 1024 * 10 * 2 + 2 * 1024);
    EXPECT_GT(result.swaps, 1024);
    EXPECT_LT(result.swaps, result.comparisons);
    EXPECT_TRUE(painter_order({}, viewpoint_on_z(), PainterKey::nearest).order.empty());
}

TEST(PainterOrder, ShowsTheLowerIndexOfEqualKeys) {
    std::vector<Polygon> polygons;
    for (int i = 0; i < 3; ++i) add(polygons, {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    EXPECT_EQ(painter_order(polygons, viewpoint_on_z(), PainterKey::centroid).order, (std::vector{2, 1, 0}));
}

// A long wall that recedes from z = 1 to z = −9 and a small card in front of or behind it. Two of the three keys sort
// each scene correctly.
struct FailureScene {
    PainterKey fails;
    std::vector<std::vector<glm::dvec3>> polygons;
};

std::vector<glm::dvec3> wall(double z_left, double z_right) {
    return {{-2, -1, z_left}, {2, -1, z_right}, {2, 1, z_right}, {-2, 1, z_left}};
}

std::vector<glm::dvec3> card(double x, double z) {
    return {{x - 0.4, -0.4, z}, {x + 0.4, -0.4, z}, {x + 0.4, 0.4, z}, {x - 0.4, 0.4, z}};
}

TEST(PainterOrder, EveryKeyFailsOnItsOwnScene) {
    // At x, the wall from z_left to z_right is at z = z_left + (x + 2) / 4 · (z_right − z_left).
    const std::vector<FailureScene> scenes{
        {PainterKey::nearest,
         {wall(1, -9), card(1, 0)}},  // the wall's nearest point is at 1, but at the card the wall is at −6.5
        {PainterKey::farthest,
         {wall(1, -9), card(-1, -5)}},  // the wall's farthest point is at −9, but at the card the wall is at −1.5
        {PainterKey::centroid, {wall(1, -9), card(-1, -3.5)}}};  // the wall's centroid: −4; the wall at the card: −1.5
    for (const FailureScene& scene : scenes) {
        std::vector<Polygon> polygons;
        for (const auto& corners : scene.polygons) add(polygons, corners);
        EXPECT_GT(wrong_pixels(polygons, scene.fails), 50) << static_cast<int>(scene.fails);
    }
    std::vector<Polygon> nearest_fails;
    for (const auto& corners : scenes[0].polygons) add(nearest_fails, corners);
    EXPECT_EQ(wrong_pixels(nearest_fails, PainterKey::farthest), 0);
    EXPECT_EQ(wrong_pixels(nearest_fails, PainterKey::centroid), 0);
    std::vector<Polygon> farthest_fails;
    for (const auto& corners : scenes[1].polygons) add(farthest_fails, corners);
    EXPECT_EQ(wrong_pixels(farthest_fails, PainterKey::nearest), 0);
}

TEST(PainterOrder, AllSixOrdersOfThreeCyclicBarsAreWrong) {
    const std::vector<Polygon> bars = cyclic_bars();
    for (const bool orthographic : {false, true}) {
        const Viewpoint viewpoint = viewpoint_on_z(orthographic);
        std::vector<int> order{0, 1, 2};
        int orders = 0;
        do {
            EXPECT_GT(wrong_pixels(bars, order, viewpoint), 0);
            ++orders;
        } while (std::next_permutation(order.begin(), order.end()));
        EXPECT_EQ(orders, 6);
    }
}

}  // namespace
}  // namespace viewing
