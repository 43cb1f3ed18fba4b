// Tests the depth picture: which gray or which band shows a known depth, on both scales and over a range.
#include <cmath>

#include "frame/depth_colors.h"
#include "gl_test.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::Rgb;
using testing::rgb_at;
using testing::scene_of;
using testing::worst_channel;

constexpr glm::ivec2 depths_px(16, 16);
constexpr double near = 0.5, far = 40.0;

class DepthPicture : public testing::GlTest {
protected:
    /// Returns the color of a square that fills the picture at this distance from the eye.
    static Rgb color_of(double distance, const std::vector<std::string>& more) {
        std::vector<std::string> settings = {
            "view.shows=depth",     "camera.position=[0,0,0]",  "camera.yaw=0",       "camera.pitch=0",
            "shadow.enabled=false", "reflection.enabled=false", "plane.extent=0.001", "plane.equation=[0,1,0,1000000]",
            "depth.format=d32f",    "projection.near=0.5",      "projection.far=40"};
        settings.insert(settings.end(), more.begin(), more.end());
        SceneObject quad = object("quad", quad_mesh(), {0, 0, 0});
        quad.world_from_model = world_from_model({0, 0, -distance}, {0, 90, 0}, glm::dvec3(distance * 2.0));
        return rgb_at(draw(params_with(settings), scene_of({quad}), depths_px), depths_px / 2);
    }
};

/// Returns the window depth by a formula that is written out here.
double depth_at(const std::string& mapping, double z) {
    if (mapping == "logarithmic") return std::log(z / near) / std::log(far / near);
    const double standard = far / (far - near) - far * near / ((far - near) * z);
    return mapping == "reversed" ? 1.0 - standard : standard;
}

/// Returns the position of z's depth on a scale from the depth of `first` (0) to that of `last` (1).
double share(const std::string& mapping, bool linear, double z, double first, double last) {
    if (linear) return (z - first) / (last - first);
    return (depth_at(mapping, z) - depth_at(mapping, first)) / (depth_at(mapping, last) - depth_at(mapping, first));
}

std::string range_text(double first, double last) {
    return "view.depth_range=[" + std::to_string(first) + "," + std::to_string(last) + "]";
}

TEST_F(DepthPicture, GrayIsEvenOverTheRangeOnItsScale) {
    for (const std::string mapping : {"standard", "reversed", "logarithmic"})
        for (const bool linear : {true, false})
            for (const glm::dvec2 range : {glm::dvec2(near, far), glm::dvec2(4, 12), glm::dvec2(0.8, 1.2)})
                for (const double at : {0.02, 0.3, 0.77, 0.98}) {
                    const double z = range.x + at * (range.y - range.x);
                    const Rgb color = color_of(z, {"depth.mapping=" + mapping, range_text(range.x, range.y),
                                                   linear ? "view.depth_scale=linear" : "view.depth_scale=window"});
                    const double grey = 255.0 * share(mapping, linear, z, range.x, range.y);
                    EXPECT_LE(worst_channel(color, Rgb(static_cast<int>(std::lround(grey)))), 1)
                        << mapping << (linear ? " linear " : " window ") << range.x << " … " << range.y << " z " << z;
                }
}

TEST_F(DepthPicture, IsBlackAndWhiteAtAndBeyondTheRange) {
    for (const std::string mapping : {"standard", "reversed", "logarithmic"})
        for (const char* const scale : {"view.depth_scale=linear", "view.depth_scale=window"}) {
            const auto at = [&](double z, const std::string& range) {
                return color_of(z, {"depth.mapping=" + mapping, scale, range});
            };
            EXPECT_EQ(at(3, range_text(3.001, 9)), Rgb(0)) << mapping << scale;
            EXPECT_EQ(at(1, range_text(3, 9)), Rgb(0)) << mapping << scale;
            EXPECT_EQ(at(9.001, range_text(3, 9)), Rgb(255)) << mapping << scale;
            EXPECT_EQ(at(30, range_text(3, 9)), Rgb(255)) << mapping << scale;
        }
}

TEST_F(DepthPicture, BandsAreInOrderOverTheRange) {
    for (const std::string mapping : {"standard", "reversed", "logarithmic"})
        for (const bool linear : {true, false})
            for (std::size_t band = 0; band < depth_bands.size(); ++band) {
                // Bisection finds the distance in the middle of the band, since share() increases with distance.
                const double middle = (static_cast<double>(band) + 0.5) / static_cast<double>(depth_bands.size());
                double nearest = 2.0, farthest = 20.0;
                for (int i = 0; i < 60; ++i) {
                    const double z = (nearest + farthest) / 2.0;
                    (share(mapping, linear, z, 2.0, 20.0) < middle ? nearest : farthest) = z;
                }
                const Rgb color =
                    color_of(nearest, {"depth.mapping=" + mapping, range_text(2, 20), "view.depth_colors=bands",
                                       linear ? "view.depth_scale=linear" : "view.depth_scale=window"});
                const Color expected = depth_bands[band];
                EXPECT_EQ(color, Rgb(expected.r, expected.g, expected.b)) << mapping << linear << " band " << band;
            }
}

TEST_F(DepthPicture, BandsEndWithTheFirstAndTheLast) {
    const auto band = [&](double z) { return color_of(z, {range_text(3, 9), "view.depth_colors=bands"}); };
    EXPECT_EQ(band(1), Rgb(0x18, 0x18, 0x18));
    EXPECT_EQ(band(30), Rgb(0xff, 0xf3, 0xcf));
}

TEST_F(DepthPicture, PixelsNeverWrittenStayTinted) {
    for (const char* const colors : {"view.depth_colors=grey", "view.depth_colors=bands"}) {
        const Rgb beyond_far = color_of(100, {colors});
        EXPECT_GT(beyond_far.b, beyond_far.r + 20) << colors;
    }
}

TEST_F(DepthPicture, AnEmptyRangeIsAStep) {
    Params params = params_with({"view.shows=depth"});
    const Scene scene = testing::box_scene();
    FramePlan frame = plan(params, derive_for(params, scene, depths_px));
    frame.shown_range = {5.0, 5.0};
    const Image image = draw(frame, scene, depths_px);
    for (int y = 0; y < depths_px.y; ++y)
        for (int x = 0; x < depths_px.x; ++x) {
            const Rgb color = rgb_at(image, {x, y});
            EXPECT_TRUE(color == Rgb(0) || color == Rgb(255) || color.b > color.r) << x << ", " << y;
        }
}

/// Returns CIE 1976 L*, from 0 to 100.
double lightness(const Color& color) {
    const auto linear = [](int value) {
        const double v = value / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

TEST(DepthBands, HaveOrderedLightnessAndNoBluishColor) {
    for (std::size_t band = 0; band < depth_bands.size(); ++band) {
        EXPECT_LE(depth_bands[band].b, depth_bands[band].r) << band;
        if (band > 0) {
            EXPECT_GT(lightness(depth_bands[band]), lightness(depth_bands[band - 1]) + 5.0) << band;
        }
    }
}

}  // namespace
}  // namespace viewing
