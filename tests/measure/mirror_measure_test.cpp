// Draws a mirror image with GL in all four ways and compares their effect on the picture and on the depths, with every
// kind of depth buffer. Also tests the case without an image.
#include "topics/planes/measured/mirror_measure.h"

#include "frame/ground.h"
#include "gl/gl_test.h"
#include "state/presets.h"

namespace viewing {
namespace {

using testing::scene_named;

constexpr glm::ivec2 mirror_px(480, 270);

class MirrorMeasure : public testing::GlTest {
protected:
    static Params params_of(const std::string& preset, const std::vector<std::string>& settings = {}) {
        const Result<LoadedState> state = load_state(preset);
        EXPECT_TRUE(state) << state.error();
        const Result<Params> params = apply_settings(state->params, settings);
        EXPECT_TRUE(params) << params.error();
        return *params;
    }
    static MirrorWays measure(const Params& params, std::array<View, mirror_way_count>* pictures = nullptr) {
        const Scene scene = scene_named(std::get<std::string>(params.scene));
        const Result<MirrorWays> ways = compare_mirror_ways(renderer(), params, scene, mirror_px, pictures);
        EXPECT_TRUE(ways) << ways.error();
        return *ways;
    }
    static MirrorWays measure(const std::vector<std::string>& settings) {
        return measure(params_of("mirror-unclipped", settings));
    }
    static const MirrorWayReport& of(const MirrorWays& ways, MirrorWay way) {
        return ways.reports[static_cast<std::size_t>(way)];
    }
    static int red_pixels(const View& view) {
        const Image image = renderer().read(view);
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                count += testing::rgb_at(image, {x, y}) ==
                                 testing::Rgb(difference_color.r, difference_color.g, difference_color.b)
                             ? 1
                             : 0;
        return count;
    }
};

TEST_F(MirrorMeasure, OnlyTheUnclippedImageDiffers) {
    const MirrorWays ways = measure(std::vector<std::string>{});
    const std::int64_t pixels = mirror_px.x * mirror_px.y;
    EXPECT_EQ(ways.size_px, mirror_px);
    for (const MirrorWayReport& report : ways.reports) EXPECT_EQ(report.compared, pixels);
    EXPECT_GT(of(ways, MirrorWay::none).different, pixels / 20);
    EXPECT_GT(of(ways, MirrorWay::none).worst, 40);
    for (const MirrorWay way : {MirrorWay::clip_distance, MirrorWay::oblique, MirrorWay::camera}) {
        EXPECT_EQ(of(ways, way).different, 0) << name_of(way);
        EXPECT_EQ(of(ways, way).worst, 0) << name_of(way);
        EXPECT_EQ(of(ways, way).image_pixels, of(ways, MirrorWay::clip_distance).image_pixels) << name_of(way);
    }
    EXPECT_GT(of(ways, MirrorWay::clip_distance).image_pixels, 2000);
}

TEST_F(MirrorMeasure, DepthsMatchTheirNearPlane) {
    // The plane crosses the torus, so the image begins at the plane itself, where an oblique near plane has depth 0.
    const MirrorWays ways = measure(std::vector<std::string>{});
    const MirrorWayReport &clipped = of(ways, MirrorWay::clip_distance), &oblique = of(ways, MirrorWay::oblique);
    EXPECT_LT(oblique.first_depth, 0.001);
    EXPECT_LT(oblique.last_depth, 0.5);
    // Points of the image are 5 to 15 from the eye. The depth is f/(f−n) − f n/((f−n) z), here with near 0.5 and far
    // 40.
    EXPECT_GT(clipped.first_depth, 40.0 / 39.5 - 20.0 / (39.5 * 5.0));
    EXPECT_LT(clipped.last_depth, 40.0 / 39.5 - 20.0 / (39.5 * 15.0));
    const MirrorWayReport& camera = of(ways, MirrorWay::camera);
    EXPECT_NEAR(camera.first_depth, clipped.first_depth, 1e-5);
    EXPECT_NEAR(camera.last_depth, clipped.last_depth, 1e-5);
    for (const MirrorWayReport& report : ways.reports) {
        EXPECT_LE(report.first_depth, report.last_depth);
        EXPECT_GT(report.distinct_depths, 1000);
        EXPECT_LE(report.distinct_depths, report.image_pixels);
    }
}

TEST_F(MirrorMeasure, AWrongProjectionOfTheMirroredCameraIsDetected) {
    const MirrorWays ways = measure({"reflection.same_projection=false"});
    EXPECT_GT(of(ways, MirrorWay::camera).different, 1000);
    EXPECT_EQ(of(ways, MirrorWay::oblique).different, 0) << "its camera is not mirrored";
}

TEST_F(MirrorMeasure, NothingIsComparedWithoutAnImage) {
    struct Empty {
        const char* what;
        std::vector<std::string> settings;
    };
    for (const Empty& empty : {Empty{"off", {"reflection.enabled=false"}}, Empty{"no mirror", {"plane.mirrors=false"}},
                               Empty{"no bounce", {"reflection.bounces=0"}},
                               Empty{"the eye in the plane", {"camera.position=[2.6,2.4,0.3]"}}}) {
        std::array<View, mirror_way_count> pictures;
        const MirrorWays ways = measure(params_of("mirror-unclipped", empty.settings), &pictures);
        for (const MirrorWayReport& report : ways.reports) {
            EXPECT_EQ(report.different, 0) << empty.what;
            EXPECT_EQ(report.image_pixels, 0) << empty.what;
            EXPECT_EQ(report.distinct_depths, 0) << empty.what;
            EXPECT_EQ(report.first_depth, 0.0) << empty.what;
            EXPECT_EQ(report.last_depth, 0.0) << empty.what;
        }
        for (const View& picture : pictures) EXPECT_EQ(picture.size_px(), mirror_px);
    }
}

TEST_F(MirrorMeasure, ObliqueAgreesWithEnoughDepthBits) {
    for (const std::vector<std::string>& depth :
         std::vector<std::vector<std::string>>{{"depth.format=d24"},
                                               {"depth.format=d32f"},
                                               {"depth.mapping=reversed"},
                                               {"depth.mapping=reversed", "depth.format=d32f"},
                                               {"depth.mapping=reversed", "depth.reversed_zero_to_one=false"},
                                               {"depth.mapping=logarithmic"},
                                               {"depth.mapping=logarithmic", "depth.format=d16"}}) {
        const MirrorWays ways = measure(depth);
        EXPECT_EQ(of(ways, MirrorWay::oblique).different, 0) << depth.front() << " " << depth.back();
        EXPECT_EQ(of(ways, MirrorWay::camera).different, 0) << depth.front() << " " << depth.back();
        EXPECT_GT(of(ways, MirrorWay::none).different, 1000) << depth.front() << " " << depth.back();
    }
}

TEST_F(MirrorMeasure, AnObliqueNearPlaneFightsMoreWithFewBits) {
    const std::int64_t sixteen = of(measure({"depth.format=d16"}), MirrorWay::oblique).different;
    const MirrorWays eight = measure({"depth.format=d8"});
    EXPECT_LE(sixteen, 10);
    EXPECT_GT(of(eight, MirrorWay::oblique).different, 0) << "its codes differ and are farther from the near plane";
    EXPECT_LT(of(eight, MirrorWay::oblique).different, 500);
    EXPECT_LT(of(eight, MirrorWay::clip_distance).distinct_depths, 8);
    EXPECT_EQ(of(eight, MirrorWay::camera).different, 0) << "the same codes, mirrored";
}

TEST_F(MirrorMeasure, ReversedDepthsOfAnObliqueNearPlaneBeginAtOne) {
    const MirrorWays ways = measure({"depth.mapping=reversed"});
    EXPECT_GT(of(ways, MirrorWay::oblique).last_depth, 0.999);
    EXPECT_LT(of(ways, MirrorWay::clip_distance).last_depth, 0.1);
}

TEST_F(MirrorMeasure, LogarithmicDepthsIgnoreAnObliqueNearPlane) {
    const MirrorWays ways = measure({"depth.mapping=logarithmic"});
    EXPECT_NEAR(of(ways, MirrorWay::oblique).first_depth, of(ways, MirrorWay::clip_distance).first_depth, 1e-4);
    EXPECT_NEAR(of(ways, MirrorWay::oblique).last_depth, of(ways, MirrorWay::clip_distance).last_depth, 1e-4);
}

/// The vertex shader writes its own z, so the projection's near plane has no effect.
TEST_F(MirrorMeasure, LogarithmsPerVertexUndoAnObliqueNearPlane) {
    const MirrorWays ways = measure({"depth.mapping=logarithmic", "depth.logarithm_per_vertex=true"});
    const MirrorWayReport &none = of(ways, MirrorWay::none), &oblique = of(ways, MirrorWay::oblique);
    EXPECT_GT(oblique.different, 1000);
    EXPECT_EQ(oblique.different, none.different);
    EXPECT_EQ(oblique.first_depth, none.first_depth);
    EXPECT_EQ(of(ways, MirrorWay::camera).different, 0);
}

TEST_F(MirrorMeasure, DrawsWithEveryDepthBufferMethodAndDisplay) {
    for (const std::vector<std::string>& settings : std::vector<std::vector<std::string>>{
             {"depth.mapping=logarithmic", "depth.logarithm_per_vertex=true"},
             {"depth.format=d4"},
             {"depth.test=false"},
             {"depth.write=false"},
             {"depth.clear=false"},
             {"depth.write_while_clearing=false"},
             {"depth.mapping=reversed", "depth.reversed_clear=false"},
             {"reflection.stencil=false"},
             {"reflection.stencil=false", "depth.format=d16"},
             {"reflection.after_objects=true"},
             {"reflection.flip_winding=false", "cull.enabled=true"},
             {"projection.type=orthographic"},
             {"view.samples=4"},
             {"overrides.mirror_from_world=[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,0]]"}}) {
        std::array<View, mirror_way_count> pictures;
        const MirrorWays ways = measure(params_of("mirror-unclipped", settings), &pictures);
        for (const MirrorWayReport& report : ways.reports) {
            EXPECT_LE(report.image_pixels, report.compared) << settings.front();
            EXPECT_GE(report.first_depth, 0.0) << settings.front();
            EXPECT_LE(report.last_depth, 1.0) << settings.front();
        }
    }
}

TEST_F(MirrorMeasure, ComparesTheWholeImageInColorWhateverTheViewShows) {
    const MirrorWays expected = measure(std::vector<std::string>{});
    for (const std::vector<std::string>& settings :
         std::vector<std::vector<std::string>>{{"view.shows=depth"},
                                               {"view.shows=stencil"},
                                               {"view.shows=overdraw"},
                                               {"view.shows=fighting"},
                                               {"view.pass=0"},
                                               {"view.call=1", "view.triangle=1"},
                                               {"visibility.method=painter"},
                                               {"visibility.method=ray_cast", "visibility.step=3"}}) {
        const MirrorWays ways = measure(settings);
        for (std::size_t way = 0; way < mirror_way_count; ++way) {
            EXPECT_EQ(ways.reports[way].different, expected.reports[way].different) << settings.front();
            EXPECT_EQ(ways.reports[way].image_pixels, expected.reports[way].image_pixels) << settings.front();
        }
    }
}

TEST_F(MirrorMeasure, MarksCountedPixelsInRed) {
    std::array<View, mirror_way_count> pictures;
    const MirrorWays ways = measure(params_of("mirror-unclipped", {"view.shows=depth"}), &pictures);
    for (std::size_t way = 0; way < mirror_way_count; ++way)
        EXPECT_EQ(red_pixels(pictures[way]), ways.reports[way].different) << name_of(static_cast<MirrorWay>(way));
    Params reference = params_of("mirror-unclipped", {"reflection.clip=clip_distance", "view.samples=0"});
    EXPECT_EQ(renderer().read(pictures[0]), draw(reference, scene_named("torus-and-boxes"), mirror_px))
        << "the first picture is the camera's own";
}

/// The image's own depths are identified even without a stencil or with objects drawn before the image.
TEST_F(MirrorMeasure, UsesOnlyTheDepthsOfTheImage) {
    const char* const small = "plane.extent=1";  // leaves objects beside the plane in the picture
    const MirrorWays expected = measure({small}), last = measure({small, "reflection.after_objects=true"});
    const MirrorWayReport &early = of(expected, MirrorWay::clip_distance), &late = of(last, MirrorWay::clip_distance);
    EXPECT_GT(early.image_pixels, 200);
    EXPECT_EQ(late.first_depth, early.first_depth);
    EXPECT_EQ(late.last_depth, early.last_depth);
    EXPECT_EQ(late.image_pixels, early.image_pixels);
    const MirrorWays both = measure({"reflection.after_objects=true", "reflection.stencil=false"});
    const MirrorWays none = measure({"reflection.stencil=false"});
    for (std::size_t way = 0; way < mirror_way_count; ++way) {
        EXPECT_EQ(both.reports[way].image_pixels, none.reports[way].image_pixels);
        EXPECT_EQ(both.reports[way].first_depth, none.reports[way].first_depth);
        EXPECT_EQ(both.reports[way].last_depth, none.reports[way].last_depth);
    }
}

TEST_F(MirrorMeasure, AgreesOnSeveralPlanesAndMirrorsInMirrors) {
    for (const int bounces : {1, 2, 3}) {
        Params params = params_of("opening");
        params.reflection.bounces = bounces;
        params.planes = {{}, {.equation = {0.0, 0.0, 1.0, 2.5}}, {.equation = {1.0, 0.0, 0.0, 3.0}}};
        const MirrorWays ways = measure(params);
        EXPECT_GT(of(ways, MirrorWay::clip_distance).image_pixels, 1000) << bounces;
        // Each level's edges may move by a pixel, and parts seen through two levels of mirrors may move by two.
        const std::int64_t most = bounces == 1 ? 0 : ways.reports[0].compared / 500;
        EXPECT_LE(of(ways, MirrorWay::camera).different, most) << bounces;
        EXPECT_LE(of(ways, MirrorWay::oblique).different, most) << bounces;
        params.planes.front().mirrors = false;
        EXPECT_GT(of(measure(params), MirrorWay::clip_distance).image_pixels, 100) << "the second plane's image";
    }
}

TEST_F(MirrorMeasure, IsDefinedInAPictureOfOnePixel) {
    const Params params = params_of("mirror-unclipped");
    const auto ways = compare_mirror_ways(renderer(), params, scene_named("torus-and-boxes"), {1, 1});
    ASSERT_TRUE(ways) << ways.error();
    for (const MirrorWayReport& report : ways->reports) EXPECT_EQ(report.compared, 1);
}

}  // namespace
}  // namespace viewing
