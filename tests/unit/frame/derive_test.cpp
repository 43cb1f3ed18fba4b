// derive() against worked examples and properties: shadow and mirror matrices, the followed point, facts, views, and
// the sentences about undrawable states. See also derive_camera_test.cpp.
#include "frame/derive.h"

#include <algorithm>
#include <cmath>

#include "frame/matrix_facts.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::box_scene;
using testing::object;
using testing::params_with;
using testing::problems_of;
using testing::scene_of;

glm::dvec3 sent_by(const glm::dmat4& matrix, const glm::dvec3& point) {
    const glm::dvec4 sent = matrix * glm::dvec4(point, 1.0);
    return glm::dvec3(sent) / sent.w;
}

void expect_near(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 1e-12) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], expected[axis], tolerance) << "axis " << axis;
}

Params with_light_and_plane(const glm::dvec4& light, const glm::dvec4& plane) {
    Params params;
    params.lights.front().position = light;
    params.planes.front().equation = plane;
    return params;
}

Derived derived_of(const Params& params, const Scene& scene = box_scene()) {
    return derive(params, scene, Viewport{});
}

/// Makes a scene whose only triangle has its first vertex at `point`; following() follows that vertex.
Scene scene_at(const glm::dvec3& point) {
    return scene_of({object("marker", triangle_mesh({point, point + glm::dvec3(1, 0, 0), point + glm::dvec3(0, 1, 0)}),
                            glm::dvec3(0.0))});
}

Params following(Params params) {
    params.follow = Follow{"marker", 0};
    return params;
}

bool says(const Params& params, std::string_view group, const std::string& words, const Scene& scene = box_scene()) {
    return testing::says(problems_of(params, scene), group, words);
}

const glm::dvec4 tilted_plane = glm::dvec4(1.0, 1.0, 1.0, -2.0 * std::sqrt(3.0));  // n = (1, 1, 1)/√3, d = −2

TEST(DeriveShadow, ParallelLightOnTheGround) {
    const Derived derived = derived_of(with_light_and_plane({12, 20, 0, 0}, {0, 1, 0, 0}));
    expect_near(sent_by(derived.planes[0].shadows[0].shadowed_world_from_world, {0, 10, 0}), {-6, 0, 0});
}

TEST(DeriveShadow, PointLightOnTheGround) {
    const Derived derived = derived_of(with_light_and_plane({12, 20, 0, 1}, {0, 1, 0, 0}));
    expect_near(sent_by(derived.planes[0].shadows[0].shadowed_world_from_world, {0, 10, 0}), {-12, 0, 0});
}

TEST(DeriveShadow, TiltedPlane) {
    const Derived derived = derived_of(with_light_and_plane({5, 9, 7, 1}, tilted_plane));
    expect_near(sent_by(derived.planes[0].shadows[0].shadowed_world_from_world, {1, 2, 3}),
                {0.323760, 0.816581, 2.323760}, 1e-6);
}

TEST(DeriveShadow, GroundMatrixIsThatOfTheSlide) {
    const double x = 2.6, y = 5.2, z = 2.2;
    const Derived derived = derived_of(with_light_and_plane({x, y, z, 1}, {0, 1, 0, 0}));
    const glm::dmat4 slide_rows(y, -x, 0, 0,  //
                                0, 0, 0, 0,   //
                                0, -z, y, 0,  //
                                0, -1, 0, y);
    EXPECT_LT(worst_difference(derived.planes[0].shadows[0].shadowed_world_from_world, glm::transpose(slide_rows)),
              1e-15);
}

TEST(DeriveShadow, SignFollowsTheSideOfTheLight) {
    const glm::dvec4 above(2, 5, 1, 1), below(2, -5, 1, 1);
    const glm::dvec4 up(0, 1, 0, 0);
    EXPECT_EQ(derived_of(with_light_and_plane(above, up)).planes[0].shadows[0].sign, 1.0);
    EXPECT_EQ(derived_of(with_light_and_plane(below, up)).planes[0].shadows[0].sign, -1.0);
    EXPECT_EQ(derived_of(with_light_and_plane(above, -up)).planes[0].shadows[0].sign, -1.0);
    EXPECT_EQ(derived_of(with_light_and_plane(below, -up)).planes[0].shadows[0].sign, 1.0);
}

TEST(DeriveShadow, SignMakesWPositiveBetweenLightAndPlane) {
    Random random(seed);
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        const glm::dvec4 plane = glm::dvec4(random.direction(), random.number(-2, 2)) * random.number(-3, 3);
        const glm::dvec3 light = random.vec3(5);
        const Derived derived = derived_of(with_light_and_plane({light, 1.0}, plane));
        if (std::abs(derived.planes[0].shadows[0].plane_dot_light) < 1e-3) continue;
        const glm::dvec3 foot =
            light - glm::dvec3(derived.planes[0].unit_plane) * derived.planes[0].shadows[0].plane_dot_light;
        const glm::dvec3 across = glm::cross(glm::dvec3(derived.planes[0].unit_plane), random.direction());
        const glm::dvec3 caster = glm::mix(foot, light, random.number(0.01, 0.99)) + across;
        EXPECT_GT((derived.planes[0].shadows[0].sign * derived.planes[0].shadows[0].shadowed_world_from_world *
                   glm::dvec4(caster, 1.0))
                      .w,
                  0.0);
    }
}

TEST(DeriveMirror, TiltedPlane) {
    const Derived derived = derived_of(with_light_and_plane({5, 9, 7, 1}, tilted_plane));
    expect_near(sent_by(derived.planes[0].mirrored_world_from_world, {1, 2, 3}), {-0.690599, 0.309401, 1.309401}, 1e-6);
}

TEST(DeriveMirror, PlanesOfTheSlide) {
    const glm::dvec3 point(2, 3, 4);
    expect_near(
        sent_by(derived_of(with_light_and_plane({9, 9, 9, 1}, {1, 0, 0, 0})).planes[0].mirrored_world_from_world,
                point),
        {-2, 3, 4});
    expect_near(
        sent_by(derived_of(with_light_and_plane({9, 9, 9, 1}, {0, 1, 0, 0})).planes[0].mirrored_world_from_world,
                point),
        {2, -3, 4});
    expect_near(
        sent_by(derived_of(with_light_and_plane({9, 9, 9, 1}, {0, 0, 1, 0})).planes[0].mirrored_world_from_world,
                point),
        {2, 3, -4});
}

TEST(DeriveFacts, DescribeTheOpeningState) {
    const Derived derived = derived_of(Params{});
    const Facts& facts = derived.facts;
    const CastShadow& cast = derived.planes[0].shadows[0];
    const glm::dmat4 &shadow = cast.shadowed_world_from_world, &mirror = derived.planes[0].mirrored_world_from_world;
    EXPECT_DOUBLE_EQ(cast.plane_dot_light, 5.2);
    EXPECT_EQ(glm::determinant(shadow), 0.0);
    EXPECT_DOUBLE_EQ(glm::determinant(mirror), -1.0);
    EXPECT_EQ(rank_of(shadow), 3);
    EXPECT_LT(shadow_residual(shadow, 5.2), 1e-12);
    EXPECT_LT(mirror_residual(mirror), 1e-12);
    EXPECT_LT(facts.view_residual, 1e-12);
    // −z of the target in view space, computed from the angles alone; the eye minus the target is (3.9, 2.25, 6.6).
    const double yaw = glm::radians(30.6), pitch = glm::radians(-16.4);
    const glm::dvec3 back(std::sin(yaw) * std::cos(pitch), -std::sin(pitch), std::cos(yaw) * std::cos(pitch));
    const double distance = glm::dot(back, glm::dvec3(3.9, 2.25, 6.6));
    EXPECT_NEAR(facts.target_distance, distance, 1e-12);
    const double step = distance * distance * (40 - 0.5) / (40 * 0.5 * (std::pow(2.0, 24) - 1.0));
    EXPECT_NEAR(facts.depth_step_at_target, step, step * 1e-9);
}

TEST(DeriveFacts, RankOfTheShadowMatrix) {
    Random random(seed);
    for (int trial = 0; trial < 100; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        const glm::dvec4 plane(random.direction(), random.number(-3, 3));
        const glm::dvec3 light = random.vec3(8);
        const double side = glm::dot(glm::dvec3(plane), light) + plane.w;
        if (std::abs(side) > 0.01) {
            const Derived derived = derived_of(with_light_and_plane({light, 1.0}, plane));
            EXPECT_EQ(rank_of(derived.chosen_shadow().shadowed_world_from_world), 3);
        }
        const glm::dvec3 in_plane = light - glm::dvec3(plane) * side;
        const CastShadow flat = derived_of(with_light_and_plane({in_plane, 1.0}, plane)).chosen_shadow();
        EXPECT_EQ(rank_of(flat.shadowed_world_from_world), 1);
        EXPECT_NEAR(flat.plane_dot_light, 0.0, 1e-12);
    }
}

TEST(DeriveFacts, ResidualsAreMeasured) {
    Params params;
    params.overrides[0].shadowed_world_from_world[0] = glm::dmat4(2.0);  // S² − (Π·L) S = 4 − 5.2 · 2
    params.overrides[0].mirrored_world_from_world = glm::dmat4(3.0);     // R² − I = 9 − 1
    const Derived derived = derived_of(params);
    const glm::dmat4& shadow = derived.chosen_shadow().shadowed_world_from_world;
    EXPECT_NEAR(shadow_residual(shadow, derived.chosen_shadow().plane_dot_light), 6.4, 1e-12);
    EXPECT_NEAR(mirror_residual(derived.chosen_plane().mirrored_world_from_world), 8.0, 1e-12);
    EXPECT_EQ(rank_of(shadow), 4);
    params.slips.camera_as_view = true;
    EXPECT_GT(derived_of(params).facts.view_residual, 1.0);
}

TEST(DeriveFollowed, PassesThroughBothMatrices) {
    const Derived derived =
        derived_of(following(with_light_and_plane({5, 9, 7, 1}, tilted_plane)), scene_at({1, 2, 3}));
    ASSERT_TRUE(derived.followed);
    const FollowedPoint& followed = *derived.followed;
    expect_near(followed.point_world, {1, 2, 3});
    // S p = (Π·L) p − (P·p) l: Π·L = 21/√3 − 2, P·p = 6/√3 − 2.
    const double plane_dot_light = 21.0 / std::sqrt(3.0) - 2.0, k = 6.0 / std::sqrt(3.0) - 2.0;
    expect_near(glm::dvec3(followed.shadow_homogeneous),
                plane_dot_light * glm::dvec3(1, 2, 3) - k * glm::dvec3(5, 9, 7));
    EXPECT_NEAR(followed.shadow_homogeneous.w, plane_dot_light - k, 1e-12);
    ASSERT_TRUE(followed.shadow_world);
    expect_near(*followed.shadow_world, {0.323760, 0.816581, 2.323760}, 1e-6);
    EXPECT_NEAR(followed.plane_distance, k, 1e-12);
    expect_near(followed.foot_world, glm::dvec3(1, 2, 3) - k / std::sqrt(3.0) * glm::dvec3(1.0));
    expect_near(followed.mirrored_world, {-0.690599, 0.309401, 1.309401}, 1e-6);
}

TEST(DeriveFollowed, StartsAtTheObjectsPose) {
    ObjectDescription description;
    description.name = "marker";
    const Mesh mesh = triangle_mesh({glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)});
    // A quarter turn about y takes x to −z, after a scale of 2 and before a move by (10, 0, 0).
    const Scene scene{
        {{description, std::make_shared<const Mesh>(mesh), world_from_model({10, 0, 0}, {90, 0, 0}, {2, 2, 2})}}, {}};
    const Derived derived = derived_of(following(Params{}), scene);
    ASSERT_TRUE(derived.followed);
    expect_near(derived.followed->point_world, {10, 0, -2});
}

TEST(DeriveFollowed, HasNoShadowAtTheHeightOfTheLight) {
    const Derived derived =
        derived_of(following(with_light_and_plane({2, 5, 2, 1}, {0, 1, 0, 0})), scene_at({-1, 5, 3}));
    ASSERT_TRUE(derived.followed);
    EXPECT_EQ(derived.followed->shadow_homogeneous.w, 0.0);
    EXPECT_FALSE(derived.followed->shadow_world);
    expect_near(derived.followed->mirrored_world, {-1, -5, 3});
}

TEST(DeriveFollowed, ReportsAMissingVertexOrObject) {
    const Scene scene = scene_at({1, 2, 3});
    Params params = following(Params{});
    params.follow->vertex = 3;
    EXPECT_FALSE(derived_of(params, scene).followed);
    EXPECT_TRUE(says(params, "follow", "does not exist", scene));
    params.follow = Follow{"nobody", 0};
    EXPECT_FALSE(derived_of(params, scene).followed);
    EXPECT_TRUE(says(params, "follow", "does not exist", scene));
}

TEST(DeriveProblems, AreAbsentInTheOpeningState) {
    const std::vector<Problem> problems = problems_of(Params{}, box_scene());
    EXPECT_TRUE(problems.empty()) << say(problems.front().sentence);
}

TEST(DeriveProblems, LightInThePlane) {
    Params params = params_with({"light.position=[3,0,-2,1]"});
    EXPECT_TRUE(derived_of(params).chosen_shadow().light_in_plane);
    EXPECT_TRUE(says(params, "light", "lies in the plane"));
    EXPECT_FALSE(says(params, "light", "opposite sides"));
    params = params_with({"light.position=[3,0,-2,0]"});
    EXPECT_TRUE(derived_of(params).chosen_shadow().light_in_plane);
    EXPECT_TRUE(says(params, "light", "run along the plane"));
    EXPECT_FALSE(derived_of(params_with({"light.position=[3,0.01,-2,1]"})).chosen_shadow().light_in_plane);
}

TEST(DeriveProblems, LightAndEyeOnOppositeSides) {
    for (const char* const setting : {"light.position=[1,-4,1,1]", "camera.position=[3.9,-3,6.6]"}) {
        for (const char* const plane : {"plane.equation=[0,1,0,0]", "plane.equation=[0,-2,0,0]"}) {
            SCOPED_TRACE(std::string(setting) + " " + plane);
            const Params params = params_with({setting, plane});
            const Derived derived = derived_of(params);
            EXPECT_TRUE(says(params, "light", "opposite sides of the plane"));
            EXPECT_FALSE(derived.planes[0].shadows[0].reaches(derived.planes[0].eye_side));
            EXPECT_TRUE(derived.planes[0].shadows[0].reaches(-derived.planes[0].eye_side));
        }
    }
}

TEST(DeriveProblems, EyeInThePlane) {
    const Params inside = params_with({"camera.position=[3.9,0,6.6]"});
    EXPECT_EQ(derived_of(inside).chosen_plane().eye_side, 0.0);
    EXPECT_TRUE(says(inside, "plane", "the eye lies in the plane"));
    const Params along = params_with({"camera.pitch=0", "projection.type=orthographic"});
    EXPECT_TRUE(says(along, "plane", "lines of sight are parallel to the plane"));
}

TEST(DeriveProblems, CasterBeyondTheLightIsNamed) {
    const Scene scene = scene_of({object("low", box_mesh(), {0, 1, 0}), object("high", sphere_mesh(), {0, 6, 0})});
    const auto problem_with_light_at = [&](double height) {
        Params params;
        params.lights.front().position = {2.6, height, 2.2, 1.0};
        const std::vector<Problem> problems = problems_of(params, scene);
        return problems.empty() ? std::string() : say(problems.front().sentence);
    };
    EXPECT_NE(problem_with_light_at(5.5).find("the part of high that is not between"), std::string::npos);
    EXPECT_EQ(problem_with_light_at(5.5).find("low"), std::string::npos);
    EXPECT_NE(problem_with_light_at(1.0).find("the part of low and high that is not"), std::string::npos);
    EXPECT_EQ(problem_with_light_at(7.01), "");
}

TEST(DeriveProblems, CasterBelowTheLightDespiteItsBounds) {
    // Rotated by 45°, the box around the sphere extends above the light, but the sphere does not.
    SceneObject ball = object("ball", sphere_mesh(), {0, 1, 0});
    ball.world_from_model = world_from_model({0, 1, 0}, {0, 45, 45}, {1, 1, 1});
    EXPECT_TRUE(problems_of(with_light_and_plane({3, 2.1, 0, 1}, {0, 1, 0, 0}), scene_of({ball})).empty());
}

TEST(DeriveProblems, ParallelLightHasNothingBeyondIt) {
    const Scene scene = scene_of({object("high", sphere_mesh(), {0, 600, 0})});
    for (const Problem& problem : problems_of(with_light_and_plane({2.6, 5.2, 2.2, 0}, {0, 1, 0, 0}), scene))
        EXPECT_EQ(problem.group, "view") << say(problem.sentence);  // the sphere is too high to be in the picture
}

TEST(DeriveProblems, OverridesAreUsedAndReported) {
    const Params params = params_with({"overrides.shadow_from_world=[[1,2,3,4],[5,6,7,8],[9,10,11,12],[0,0,0,1]]",
                                       "overrides.mirror_from_world=[[1,0,0,7],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"});
    const Derived derived = derived_of(params);
    EXPECT_EQ(derived.planes[0].shadows[0].shadowed_world_from_world[3][0], 4.0);  // row 0, column 3
    EXPECT_EQ(derived.planes[0].shadows[0].shadowed_world_from_world[0][1], 5.0);
    EXPECT_EQ(derived.planes[0].mirrored_world_from_world[3][0], 7.0);
    EXPECT_TRUE(says(params, "shadow", "S is entered by hand"));
    EXPECT_TRUE(says(params, "reflection", "R is entered by hand"));
}

TEST(DeriveProblems, MethodsAndPicturesCauseNone) {
    for (const char* drawn : {"visibility.method=bsp", "visibility.method=ray_cast", "visibility.step=3",
                              "view.shows=overdraw", "view.shows=difference"})
        EXPECT_TRUE(problems_of(params_with({drawn}), box_scene()).empty()) << drawn;
}

}  // namespace
}  // namespace viewing
