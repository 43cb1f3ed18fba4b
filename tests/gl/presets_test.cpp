// The presets that show an artifact show it clearly: much of it is visible, and nothing obstructs it.
#include "state/presets.h"
#include "gl/gl_test.h"

namespace viewing {
namespace {

constexpr glm::ivec2 preset_px{1280, 720};

class Presets : public testing::GlTest {
protected:
    static Params preset(const std::string& name) {
        const Result<LoadedState> state = load_state(name);
        EXPECT_TRUE(state) << state.error();
        Params params = state->params;
        params.view.samples = 0;
        return params;
    }
    static Image picture(const Params& params) {
        return draw(params, testing::scene_named(std::get<std::string>(params.scene)), preset_px);
    }
};

/// Counts the transitions between orange and blue, from left to right and from top to bottom.
int meetings(const Image& image) {
    const auto blueness = [&image](int x, int y) {
        const auto rgb = testing::rgb_at(image, {x, y});
        return static_cast<int>(rgb[2]) - static_cast<int>(rgb[0]);
    };
    int count = 0;
    for (int y = 1; y < image.height; ++y) {
        for (int x = 1; x < image.width; ++x) {
            const int here = blueness(x, y);
            for (const int there : {blueness(x - 1, y), blueness(x, y - 1)})
                count += std::max(here, there) > 60 && std::min(here, there) < -60 ? 1 : 0;
        }
    }
    return count;
}

TEST_F(Presets, DepthFightingIsFullOfStripes) {
    const int clean = meetings(picture(preset("coplanar")));
    EXPECT_GT(clean, 500) << "six quads are in front of six others";
    EXPECT_GT(meetings(picture(preset("depth-fighting"))), 3 * clean);
}

TEST_F(Presets, ShadowFightsTearsTheShadow) {
    Params params = preset("shadow-fights");
    const Image torn = picture(params);
    params.shadow.offset = ShadowOffset::polygon_offset;
    const Image whole = picture(params);
    params.shadow.enabled = false;
    const Image none = picture(params);
    const int shadow = testing::pixels_beyond(whole, none, 10);
    const int missing = testing::pixels_beyond(torn, whole, 10);
    EXPECT_GT(shadow, 40'000);
    EXPECT_GT(missing, shadow / 4);
    EXPECT_GT(shadow - missing, shadow / 10) << "some of it is left";
}

TEST_F(Presets, ShadowDoubleBlendHasSeveralLevels) {
    Params params = preset("shadow-double-blend");
    const Image twice = picture(params);
    params.shadow.stencil_once = true;
    const Image once = picture(params);
    int two_layers = 0, more_layers = 0;  // pixels by the ratio to one layer; each further layer transmits 0.7
    for (int y = 0; y < preset_px.y; ++y) {
        for (int x = 0; x < preset_px.x; ++x) {
            const double ratio = static_cast<double>(testing::rgb_at(twice, {x, y})[2]) /
                                 std::max<double>(testing::rgb_at(once, {x, y})[2], 1.0);
            two_layers += ratio > 0.6 && ratio < 0.8 ? 1 : 0;
            more_layers += ratio < 0.5 ? 1 : 0;
        }
    }
    EXPECT_GT(two_layers, 20'000);
    EXPECT_GT(more_layers, 3'000);
}

}  // namespace
}  // namespace viewing
