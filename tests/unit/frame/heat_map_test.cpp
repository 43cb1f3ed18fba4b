// Checks the table that the heat map's shader reads against the formulas of topics/depth/numbers/fighting.h and worked
// examples. Also checks its colors.
#include "topics/depth/numbers/heat_map.h"

#include "topics/depth/numbers/fighting.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::scene_of;

HeatMap map_of(const std::vector<std::string>& settings, const Scene& scene = {}) {
    const Params params = params_with(settings);
    return heat_map(params, derive(params, scene, {}), scene);
}

/// The onset at a distance, interpolated like the shader does: its logarithm is linear between the entries.
double onset_at(const HeatMap& map, double distance) {
    const double range = std::log(map.far / map.near);
    const double share =
        range > 0.0 ? std::clamp(std::log(std::max(distance, map.near) / map.near) / range, 0.0, 1.0) : 0.0;
    const double place = share * static_cast<double>(HeatMap::entry_count - 1);
    const auto entry = std::min(static_cast<std::size_t>(place), HeatMap::entry_count - 2);
    return std::exp(
        std::lerp(std::log(map.onsets[entry]), std::log(map.onsets[entry + 1]), place - static_cast<double>(entry)));
}

double lightness(const Color& color) {
    const auto linear = [](std::uint8_t byte) { return std::pow(byte / 255.0, 2.2); };
    return std::cbrt(0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b));
}

TEST(HeatMap, OnsetIsTheWorkedStepAt16Bits) {
    // Δz = z² (f − n) / (f n (2¹⁶ − 1)); the error of float32 arithmetic is far smaller.
    const HeatMap map = map_of({"projection.near=0.5", "projection.far=200", "depth.format=d16"});
    EXPECT_NEAR(map.distance_of(0), 0.5, 1e-12);
    EXPECT_NEAR(map.distance_of(HeatMap::entry_count - 1), 200.0, 1e-9);
    for (const double z : {1.0, 4.0, 14.0, 44.0}) {
        const double step = z * z * (200.0 - 0.5) / (200.0 * 0.5 * 65535.0);
        EXPECT_NEAR(onset_at(map, z), step, 0.03 * step) << z;
    }
}

TEST(HeatMap, IsCloseToTheFormulaBetweenEntries) {
    Random random(seed);
    for (const char* const format : {"depth.format=d8", "depth.format=d16", "depth.format=d24", "depth.format=d32f"}) {
        for (const char* const mapping : {"standard", "reversed", "logarithmic"}) {
            const std::vector<std::string> settings{"projection.near=0.1", "projection.far=500", format,
                                                    std::string("depth.mapping=") + mapping};
            const HeatMap map = map_of(settings);
            const Params params = params_with(settings);
            const DepthCoding coding = depth_coding(params, derive(params, Scene{}, {}));
            for (int trial = 0; trial < 100; ++trial) {
                const double z = 0.1 * std::pow(5000.0, random.number(0.3, 1.0));
                const FightingOnset onset = fighting_onset(coding, z);
                if (!onset.is_reachable) continue;
                EXPECT_GT(onset_at(map, z), 0.5 * onset.gap()) << format << " " << mapping << " z " << z;
                EXPECT_LT(onset_at(map, z), 2.0 * onset.gap()) << format << " " << mapping << " z " << z;
            }
        }
    }
}

TEST(HeatMap, IsPositiveAndFiniteForAnyLens) {
    for (const char* const near : {"projection.near=0.001", "projection.near=39.9"})
        for (const char* const format : {"depth.format=d4", "depth.format=d24", "depth.format=d32f"})
            for (const char* const type : {"projection.type=perspective", "projection.type=orthographic"}) {
                const HeatMap map = map_of({near, "projection.far=40", format, type});
                for (const double z : {-1.0, 0.0, 1e-9, 0.5, 39.95, 40.0, 1e9}) {
                    EXPECT_GT(onset_at(map, z), 0.0);
                    EXPECT_TRUE(std::isfinite(onset_at(map, z)));
                }
            }
}

TEST(HeatMap, NoGapIsWideEnoughJustBehindNear) {
    // At four bits, the first codes span a wide range, so a surface just behind the near plane has the same code as any
    // surface in front of it.
    const HeatMap map = map_of({"projection.near=1", "projection.far=100", "depth.format=d4"});
    for (const double z : {1.0, 1.01, 1.03}) EXPECT_GT(onset_at(map, z), z - 1.0) << z;
}

TEST(HeatMap, GivesEachObjectItsSmallestGap) {
    const auto square = [](double height) { return object("square", quad_mesh(), {0.0, height, 0.0}); };
    const Scene scene = scene_of({square(0.0), square(0.1), square(0.13), object("box", box_mesh(), {5.0, 0.0, 0.0})});
    const HeatMap map = map_of({"camera.position=[0,20,0]", "camera.pitch=-90", "camera.yaw=0"}, scene);
    ASSERT_EQ(map.gap_of_object.size(), 4U);
    EXPECT_NEAR(map.gap_of_object[0]->gap, 0.1, 1e-9);
    EXPECT_NEAR(map.gap_of_object[1]->gap, 0.03, 1e-9);
    EXPECT_NEAR(map.gap_of_object[2]->gap, 0.03, 1e-9);
    EXPECT_FALSE(map.gap_of_object[3]);
    EXPECT_NEAR(std::abs(map.gap_of_object[0]->normal_view.z), 1.0, 1e-9) << "seen from above";
}

/// The color of a ratio, interpolated like the shader does; a negative ratio counts as 0.
Color heat_color(double ratio) {
    const double place = ratio < 1.0 ? 2.0 * std::max(ratio, 0.0) : 3.0 + std::min(std::log2(ratio), 2.0);
    const auto first = std::min(static_cast<std::size_t>(place), ratio < 1.0 ? std::size_t{1} : std::size_t{4});
    const Color &a = heat_colors[first], &b = heat_colors[first + 1];
    const auto mixed = [share = place - static_cast<double>(first)](double from, double to) {
        return static_cast<std::uint8_t>(std::lround(std::lerp(from, to, share)));
    };
    return {mixed(a.r, b.r), mixed(a.g, b.g), mixed(a.b, b.b)};
}

TEST(HeatMap, ColorsIncreaseInLightness) {
    double before = 0.0;
    for (const double ratio : {0.0, 0.2, 0.5, 0.7, 0.99, 1.0, 1.5, 2.0, 3.0, 4.0}) {
        const double now = lightness(heat_color(ratio));
        EXPECT_GT(now, before) << ratio;
        before = now;
    }
    EXPECT_EQ(heat_color(4.0), heat_color(1e9));
    EXPECT_EQ(heat_color(-1.0), heat_color(0.0));
    EXPECT_EQ(heat_color(0.5), heat_colors[1]);
    EXPECT_EQ(heat_color(2.0), heat_colors[4]);
    EXPECT_GT(lightness(heat_color(1.0)), lightness(heat_color(0.9999)) + 0.05) << "a clear edge where fighting begins";
}

}  // namespace
}  // namespace viewing
