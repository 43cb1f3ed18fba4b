// The common mistakes with projection and mirror, and a window without a depth buffer: their effect on P, R and the
// passes, and the sentences about them.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/projection.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

using testing::params_with;

Derived derived_with_slips(const Params& params, const Viewport& viewport = {}) {
    return derive(params, testing::box_scene(), viewport);
}

std::vector<Problem> problems_of_slips(const std::vector<std::string>& settings, const Viewport& viewport = {}) {
    return testing::problems_of(params_with(settings), testing::box_scene(), viewport);
}

TEST(Aspect, CustomAspectIsThatOfPForAnyView) {
    for (const glm::ivec2 size_px : {glm::ivec2(1280, 720), glm::ivec2(300, 600)}) {
        for (const char* const type : {"perspective", "orthographic"}) {
            const Derived derived = derived_with_slips(
                params_with({"projection.aspect=1.6", std::string("projection.type=") + type}), {size_px});
            EXPECT_NEAR(derived.clip_from_view[1][1] / derived.clip_from_view[0][0], 1.6, 1e-12);
            EXPECT_EQ(derived.aspect, 1.6);
            EXPECT_NEAR(derived.view_aspect, static_cast<double>(size_px.x) / size_px.y, 1e-12);
        }
        const Derived usual = derived_with_slips({}, {size_px});
        EXPECT_EQ(usual.aspect, usual.view_aspect) << "0 means the aspect of the view";
    }
}

TEST(Aspect, CustomAspectReportsItsStretch) {
    EXPECT_TRUE(testing::says(problems_of_slips({"projection.aspect=1"}), "projection", "stretched to 1.78 times"));
    EXPECT_FALSE(testing::says(problems_of_slips({"projection.aspect=1"}, {{600, 600}}), "projection", "stretched"));
    EXPECT_FALSE(testing::says(problems_of_slips({}), "projection", "stretched"));
}

TEST(DegreesAsRadians, UseTheCotangentOfTheNumberItself) {
    for (double fovy = 1.0; fovy <= 179.0; fovy += 0.25) {
        Params params;
        params.projection.fovy = fovy;
        params.slips.degrees_as_radians = true;
        const double expected = 1.0 / std::tan(fovy / 2.0);
        EXPECT_NEAR(derived_with_slips(params).clip_from_view[1][1], expected, 1e-9 * std::max(1.0, std::abs(expected)))
            << fovy;
    }
    Params slide = params_with({"projection.fovy=45", "slips.degrees_as_radians=true"});
    EXPECT_NEAR(slide.lens().fovy_deg, 58.31, 0.005) << "45 radians look like 58.3°";
    slide.projection.type = ProjectionType::orthographic;
    Params right = slide;
    right.slips = {};
    EXPECT_EQ(derived_with_slips(slide).clip_from_view, derived_with_slips(right).clip_from_view)
        << "orthographic views have no angle";
}

// If fovy is a multiple of π, cot(fovy / 2) is infinite or 0.
TEST(DegreesAsRadians, KeepAUsableStateAtEveryAngle) {
    for (int half_turns = 1; half_turns * glm::pi<double>() < 179.0; ++half_turns) {
        Params params;
        params.projection.fovy = half_turns * glm::pi<double>();
        params.slips.degrees_as_radians = true;
        const glm::dmat4 back = glm::inverse(derived_with_slips(params).clip_from_view);
        for (int entry = 0; entry < 16; ++entry) ASSERT_TRUE(std::isfinite(back[entry / 4][entry % 4])) << half_turns;
        testing::problems_of(params, testing::box_scene());
    }
}

TEST(DegreesAsRadians, ReportTheVisibleAngle) {
    const auto said = [](const char* fovy, const char* words) {
        return testing::says(
            problems_of_slips({"slips.degrees_as_radians=true", std::string("projection.fovy=") + fovy}), "projection",
            words);
    };
    EXPECT_TRUE(said("45", "58.3°"));
    EXPECT_TRUE(said("45", "is 1.79"));
    EXPECT_FALSE(said("45", "flipped top to bottom"));
    EXPECT_TRUE(said("4", "flipped top to bottom")) << "cot 2 < 0";
    EXPECT_FALSE(testing::says(problems_of_slips({"projection.fovy=45"}), "projection", "mistake"));
    EXPECT_FALSE(testing::says(problems_of_slips({"slips.degrees_as_radians=true", "projection.type=orthographic"}),
                               "projection", "mistake"));
}

TEST(Plus2ab, FlipsOneSignAndIsReportedWhereItShows) {
    const char* const tilted = "plane.equation=[0.3,1,0.15,0.5]";
    const glm::dmat4 right = derived_with_slips(params_with({tilted})).planes[0].mirrored_world_from_world;
    const DerivedPlane slipped = derived_with_slips(params_with({tilted, "slips.plus_2ab=true"})).planes[0];
    const double n2 = 0.09 + 1.0 + 0.0225;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            const bool is_slip = row == 1 && column == 0;
            EXPECT_NEAR(slipped.mirrored_world_from_world[column][row], is_slip ? 2.0 * 0.3 / n2 : right[column][row],
                        1e-12);
        }
    }
    EXPECT_TRUE(slipped.mirror_has_slip);
    EXPECT_TRUE(testing::says(problems_of_slips({tilted, "slips.plus_2ab=true"}), "reflection", "+2ab = 0.539"));
    // The floor has a = 0, so there is no change and no sentence.
    EXPECT_FALSE(derived_with_slips(params_with({"slips.plus_2ab=true"})).planes[0].mirror_has_slip);
    EXPECT_FALSE(testing::says(problems_of_slips({"slips.plus_2ab=true"}), "reflection", "mistake"));
    EXPECT_FALSE(testing::says(problems_of_slips({tilted, "slips.plus_2ab=true", "reflection.enabled=false"}),
                               "reflection", "mistake"));
}

TEST(NormalNotUnit, MovesEveryPointByTheSquareOfTheLength) {
    const std::vector<std::string> settings = {"plane.equation=[0,2,0,1]", "slips.normal_not_unit=true"};
    const glm::dmat4 mirror = derived_with_slips(params_with(settings)).planes[0].mirrored_world_from_world;
    const glm::dvec4 point(0.3, 1.5, -2.0, 1.0), moved = mirror * point;
    // p − 2 (n·p + d) n with n = (0, 2, 0), d = 1.
    EXPECT_NEAR(moved.x, 0.3, 1e-12);
    EXPECT_NEAR(moved.y, 1.5 - 2.0 * (2.0 * 1.5 + 1.0) * 2.0, 1e-12);
    EXPECT_NEAR(moved.z, -2.0, 1e-12);
    EXPECT_TRUE(testing::says(problems_of_slips(settings), "reflection", "|n|² = 4 times"));
    EXPECT_FALSE(testing::says(problems_of_slips({"slips.normal_not_unit=true"}), "reflection", "mistake"));
    // A matrix entered by hand is not reported as a mistake.
    std::vector<std::string> by_hand = settings;
    by_hand.emplace_back("overrides.mirror_from_world=[[1,0,0,0],[0,-1,0,0],[0,0,1,0],[0,0,0,1]]");
    EXPECT_FALSE(derived_with_slips(params_with(by_hand)).planes[0].mirror_has_slip);
}

TEST(NoDepthBuffer, NothingIsTestedForAnySetting) {
    for (const char* const func : {"depth.func=less", "depth.func=never"}) {
        const Params without = params_with({"depth.buffer=false", func});
        for (const Pass& pass : plan(without, derived_with_slips(without)).passes)
            EXPECT_FALSE(pass.depth.test) << say(pass.name);
    }
    const Params with = params_with({});
    const FramePlan usual = plan(with, derived_with_slips(with));
    EXPECT_TRUE(
        std::any_of(usual.passes.begin(), usual.passes.end(), [](const Pass& pass) { return pass.depth.test; }));
    const std::vector<Problem> problems = problems_of_slips({"depth.buffer=false", "depth.func=never"});
    EXPECT_TRUE(testing::says(problems, "depth", "GLUT_DEPTH"));
    EXPECT_FALSE(testing::says(problems, "depth", "GL_NEVER")) << "no depth function is used";
    EXPECT_FALSE(
        testing::says(problems_of_slips({"depth.buffer=false", "visibility.method=painter"}), "depth", "GLUT"));
}

TEST(EffectiveCamera, IsWhereTheUploadedMatrixPutsTheEye) {
    for (const std::vector<std::string>& slips : {std::vector<std::string>{"slips.swapped_order=true"},
                                                  {"slips.camera_as_view=true"},
                                                  {"slips.swapped_order=true", "slips.camera_as_view=true"}}) {
        std::vector<std::string> settings = {"camera.position=[1,2,3]", "camera.yaw=40", "camera.pitch=-20",
                                             "camera.roll=5"};
        settings.insert(settings.end(), slips.begin(), slips.end());
        const Params params = params_with(settings);
        const Derived derived = derived_with_slips(params);
        const glm::dmat4 effective = effective_camera(derived);
        const glm::dvec4 eye_view = derived.view_from_world * effective[3];
        EXPECT_LT(glm::length(glm::dvec3(eye_view)), 1e-12) << "V takes it to the origin";
        EXPECT_GT(glm::length(effective[3] - placed_camera(params)[3]), 0.1);
        EXPECT_LT(glm::length(glm::dvec3(placed_camera(params)[3]) - params.camera.position), 1e-12);
    }
    const Params right = params_with({"camera.roll=5"});
    const glm::dmat4 effective = effective_camera(derived_with_slips(right)), placed = placed_camera(right);
    for (int column = 0; column < 4; ++column)
        EXPECT_LT(glm::length(effective[column] - placed[column]), 1e-12) << "both cameras agree";
}

TEST(DepthStep, MatchesTheStateAtAnyDistance) {
    // The width of a code in worked examples.
    EXPECT_NEAR(depth_step(params_with({"projection.near=1", "projection.far=100", "depth.format=d16"}), 10.0),
                1.511e-3, 1e-6);
    EXPECT_NEAR(depth_step(params_with({"projection.near=0.1", "projection.far=100", "depth.format=d24"}), 100.0),
                5.955e-3, 1e-6);
    const Params params = params_with({"projection.near=0.3"});
    const Facts facts = derived_with_slips(params).facts;
    EXPECT_EQ(depth_step(params, facts.target_distance), facts.depth_step_at_target);
    EXPECT_EQ(depth_step(params, -1.0), depth_step(params, 0.3)) << "distances below near count as near";
}

}  // namespace
}  // namespace viewing
