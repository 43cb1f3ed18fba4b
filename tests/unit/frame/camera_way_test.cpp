// Checks the followed point's path into the picture against GLM's projection and the definition of the clip volume.
#include "topics/camera/numbers/camera_way.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "state/file/state_json.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

Params camera_at(const glm::dvec3& eye) {
    Params params;
    params.camera.look({eye, {0, 0, 0}, {0, 1, 0}});
    return params;
}

TEST(CameraWay, IsTheProjectionThatGlmComputes) {
    constexpr unsigned seed = 3905;
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    constexpr double aspect = 1.6;
    int inside = 0, cut = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const glm::dvec3 eye(uniform(-5, 5), uniform(1, 5), uniform(2, 6));
        Params params = camera_at(eye);
        params.projection.near = uniform(0.1, 2.0);
        params.projection.far = uniform(5.0, 20.0);
        const Derived derived = derive(params, Scene{}, {{1600, 1000}});
        const glm::dvec3 p(uniform(-8, 8), uniform(-8, 8), uniform(-8, 8));
        const CameraWay way = camera_way(params, derived, p);
        const glm::dmat4 v = glm::lookAt(eye, glm::dvec3(0.0), glm::dvec3(0, 1, 0));
        const glm::dmat4 projection = glm::perspective(glm::radians(params.projection.fovy), aspect,
                                                       params.projection.near, params.projection.far);
        const glm::dvec4 clip = projection * v * glm::dvec4(p, 1.0);
        ASSERT_LE(glm::length(way.point_clip - clip), 1e-9) << "trial " << trial;
        ASSERT_LE(glm::length(way.point_view - glm::dvec3(v * glm::dvec4(p, 1.0))), 1e-9);
        const bool is_inside =
            clip.w > 0.0 && glm::all(glm::lessThanEqual(glm::abs(glm::dvec3(clip)), glm::dvec3(clip.w)));
        EXPECT_EQ(way.cut_by == FrustumPlane::none, is_inside) << "trial " << trial;
        ++(is_inside ? inside : cut);
        if (!is_inside) continue;
        const double depth = 0.5 * clip.z / clip.w + 0.5;
        ASSERT_TRUE(way.window_depth);
        EXPECT_NEAR(*way.window_depth, depth, 1e-9);
        EXPECT_NEAR(way.code, depth * 16777215.0, 1.0);
    }
    EXPECT_GT(inside, 20);
    EXPECT_GT(cut, 20);
}

TEST(CameraWay, NamesThePlaneThatCutsThePoint) {
    Params params = camera_at({0, 0, 5});
    params.projection.near = 1.0;
    params.projection.far = 10.0;
    const Derived derived = derive(params, Scene{}, {{800, 800}});
    const auto cut_by = [&](double x, double y, double z) { return camera_way(params, derived, {x, y, z}).cut_by; };
    EXPECT_EQ(cut_by(0, 0, 0), FrustumPlane::none);
    EXPECT_EQ(cut_by(0, 0, 4.5), FrustumPlane::near);
    EXPECT_EQ(cut_by(0, 0, 6), FrustumPlane::near) << "behind the camera";
    EXPECT_EQ(cut_by(0, 0, -5.1), FrustumPlane::far);
    EXPECT_EQ(cut_by(-9, 0, 0), FrustumPlane::left);
    EXPECT_EQ(cut_by(9, 0, 0), FrustumPlane::right);
    EXPECT_EQ(cut_by(0, -9, 0), FrustumPlane::bottom);
    EXPECT_EQ(cut_by(0, 9, 0), FrustumPlane::top);
    const CameraWay at_eye = camera_way(params, derived, {1, 0, 5});
    EXPECT_FALSE(at_eye.point_ndc) << "w = 0";
    EXPECT_FALSE(at_eye.window_depth);
}

TEST(CameraWay, TheViewportPutsTheCornersOfNdcAtTheWindowsCorners) {
    const auto at = [](const glm::dvec3& ndc, bool zero_to_one) {
        return glm::dvec3(window_from_ndc({640, 480}, zero_to_one) * glm::dvec4(ndc, 1.0));
    };
    EXPECT_EQ(at({-1, -1, -1}, false), glm::dvec3(0, 0, 0));
    EXPECT_EQ(at({1, 1, 1}, false), glm::dvec3(640, 480, 1));
    EXPECT_EQ(at({0, 0.5, 0}, false), glm::dvec3(320, 360, 0.5));
    EXPECT_EQ(at({-1, 1, 0}, true), glm::dvec3(0, 480, 0));
    EXPECT_EQ(at({1, -1, 1}, true), glm::dvec3(640, 0, 1));
}

TEST(CameraWay, FollowsAPointOfItsOwn) {
    const Scene scene = testing::box_scene();
    const Params params = testing::params_with({"follow.point=[1, 2.5, -3]", "light.position=[2, 5, 1, 1]"});
    const Derived derived = derive(params, scene, {});
    ASSERT_TRUE(derived.followed);
    EXPECT_EQ(derived.followed->point_world, glm::dvec3(1, 2.5, -3));
    // The light, at height 5, projects p, at height 2.5, to twice p's distance from the light: s = l + 2 (p − l).
    EXPECT_LT(glm::distance(*derived.followed->shadow_world, glm::dvec3(0, 0, -7)), 1e-12);
    EXPECT_TRUE(find_problems(params, derived, scene, plan(params, derived)).empty());
}

}  // namespace
}  // namespace viewing
