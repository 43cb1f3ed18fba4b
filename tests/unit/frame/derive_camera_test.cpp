// The views of derive(): the camera with its mistakes, the uploaded projection, the observer, the moving world, and the
// frustum. Also checks that no possible setting yields a non-finite number.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "frame/derive.h"
#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"
#include "unit/state/random_params.h"

namespace viewing {
namespace {

using testing::box_scene;
using testing::params_with;

Derived derived_camera(const Params& params, bool clip_control = true) {
    return derive(params, box_scene(), Viewport{{160, 90}, clip_control});
}

/// Computes C as in the lecture: rotate about y, then about the new x, then about the new z, and move to the position.
glm::dmat4 lecture_camera(const CameraParams& camera) {
    glm::dmat4 made = glm::translate(glm::dmat4(1.0), camera.position);
    made = glm::rotate(made, glm::radians(camera.yaw), glm::dvec3(0, 1, 0));
    made = glm::rotate(made, glm::radians(camera.pitch), glm::dvec3(1, 0, 0));
    return glm::rotate(made, glm::radians(camera.roll), glm::dvec3(0, 0, 1));
}

Params random_pose(Random& random) {
    Params params;
    params.camera.position = random.vec3(10);
    const Angles angles = random.angles();
    params.camera.yaw = angles.yaw_deg;
    params.camera.pitch = angles.pitch_deg;
    params.camera.roll = angles.roll_deg;
    return params;
}

glm::dvec3 divided(const glm::dvec4& point) {
    return glm::dvec3(point) / point.w;
}

TEST(DeriveCamera, ViewIsTheInverseOfTheLectureCamera) {
    Random random(seed);
    for (int trial = 0; trial < 100; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        const Params params = random_pose(random);
        const Derived derived = derived_camera(params);
        EXPECT_LT(worst_difference(derived.world_from_view, lecture_camera(params.camera)), 1e-12);
        EXPECT_LT(worst_difference(derived.view_from_world * lecture_camera(params.camera), glm::dmat4(1.0)), 1e-12);
        EXPECT_LT(worst_difference(derived.clip_from_world, derived.clip_from_view * derived.view_from_world), 1e-12);
        EXPECT_EQ(derived.eye_world, glm::dvec4(params.camera.position, 1.0));
        EXPECT_LT(derived.facts.view_residual, 1e-12);
    }
}

TEST(DeriveCamera, ParallelViewHasADirectionAsEye) {
    Params params = params_with({"projection.type=orthographic", "camera.pitch=-30", "camera.yaw=0"});
    Derived derived = derived_camera(params);
    EXPECT_EQ(derived.eye_world.w, 0.0);
    EXPECT_NEAR(derived.eye_world.y, 0.5, 1e-12);
    EXPECT_NEAR(derived.eye_world.z, std::sqrt(0.75), 1e-12);
    EXPECT_NEAR(derived.planes[0].eye_side, 0.5, 1e-12);
    // A parallel view that looks up shows the plane's lower side, even though the camera is above the plane.
    params.camera.pitch = 30.0;
    derived = derived_camera(params);
    EXPECT_NEAR(derived.planes[0].eye_side, -0.5, 1e-12);
    EXPECT_FALSE(derived.planes[0].shadows[0].reaches(derived.planes[0].eye_side));
}

TEST(DeriveCamera, SwappedOrderRotatesThePositionToo) {
    Params params;
    params.camera.position = {1, 2, 3};
    params.camera.yaw = 90.0;
    params.camera.pitch = params.camera.roll = 0.0;
    params.slips.swapped_order = true;
    const glm::dvec3 eye = divided(derived_camera(params).world_from_view[3]);
    EXPECT_NEAR(eye.x, 3.0, 1e-12);  // Ry(90°) takes z to x and x to −z
    EXPECT_NEAR(eye.y, 2.0, 1e-12);
    EXPECT_NEAR(eye.z, -1.0, 1e-12);
}

TEST(DeriveCamera, CameraAsViewUploadsC) {
    Random random(seed);
    for (int trial = 0; trial < 20; ++trial) {
        Params params = random_pose(random);
        params.slips.camera_as_view = true;
        const Derived derived = derived_camera(params);
        EXPECT_LT(worst_difference(derived.view_from_world, lecture_camera(params.camera)), 1e-12);
        // The eye is the viewpoint of the picture: the point that the uploaded matrix takes to the origin.
        const glm::dvec4 eye_view = derived.view_from_world * derived.eye_world;
        EXPECT_LT(glm::length(glm::dvec3(eye_view)), 1e-12);
        // The camera itself keeps its position.
        EXPECT_LT(glm::length(divided(derived.world_from_view[3]) - params.camera.position), 1e-12);
    }
}

TEST(DeriveProjection, NearAndFarMapToTheClipRange) {
    struct Case {
        const char* mapping;
        bool clip_control;
        double near_ndc, far_ndc;
        bool zero_to_one;
    };
    for (const char* const type : {"perspective", "orthographic", "frustum", "orthographic_window"}) {
        for (const Case& each : {Case{"standard", true, -1, 1, false},
                                 {"standard", false, -1, 1, false},
                                 {"logarithmic", true, -1, 1, false},
                                 {"reversed", true, 1, 0, true},
                                 {"reversed", false, 1, -1, false}}) {
            SCOPED_TRACE(std::string(type) + " " + each.mapping + (each.clip_control ? " with" : " without") +
                         " clip control");
            const Params params =
                params_with({std::string("projection.type=") + type, std::string("depth.mapping=") + each.mapping,
                             "projection.left=-0.7", "projection.top=0.5"});
            const Derived derived = derived_camera(params, each.clip_control);
            EXPECT_EQ(derived.clip_zero_to_one, each.zero_to_one);
            EXPECT_NEAR(divided(derived.clip_from_view * glm::dvec4(0.1, 0.2, -0.5, 1.0)).z, each.near_ndc, 1e-12);
            EXPECT_NEAR(divided(derived.clip_from_view * glm::dvec4(0.1, 0.2, -40.0, 1.0)).z, each.far_ndc, 1e-12);
        }
    }
}

TEST(DeriveProjection, AnInfiniteFarIsWhereDirectionsGo) {
    for (const char* const mapping : {"standard", "reversed"})
        for (const bool clip_control : {true, false}) {
            const Params params = params_with({"projection.far=infinite", std::string("depth.mapping=") + mapping});
            const Derived derived = derived_camera(params, clip_control);
            const glm::dvec4 end = derived.clip_from_view * glm::dvec4(0.2, 0.1, -1.0, 0.0);
            const bool reversed = params.depth.mapping == DepthMapping::reversed;
            EXPECT_EQ(end.z / end.w, !reversed ? 1.0 : clip_control ? 0.0 : -1.0);
            EXPECT_TRUE(std::isfinite(derived.facts.depth_step_at_target));
            for (const glm::dvec3& corner : frustum_corners(params, derived))
                EXPECT_LT(glm::length(corner), 1e3) << "drawn to a finite length";
        }
}

TEST(DeriveProjection, MappingKeepsScreenPositions) {
    const glm::dvec4 point(0.3, -0.7, -5.0, 1.0);
    const glm::dvec3 standard = divided(derived_camera(Params{}).clip_from_view * point);
    EXPECT_NEAR(standard.y, -0.7 / (5.0 * std::tan(glm::radians(20.0))), 1e-12);
    EXPECT_NEAR(standard.x, 0.3 / (5.0 * std::tan(glm::radians(20.0))) * 90.0 / 160.0, 1e-12);
    for (const bool clip_control : {true, false}) {
        const Derived reversed = derived_camera(params_with({"depth.mapping=reversed"}), clip_control);
        const glm::dvec3 found = divided(reversed.clip_from_view * point);
        EXPECT_NEAR(found.x, standard.x, 1e-12);
        EXPECT_NEAR(found.y, standard.y, 1e-12);
    }
}

TEST(DeriveFrustum, CornersProjectToTheCube) {
    Random random(seed);
    for (const char* const type : {"perspective", "orthographic", "frustum", "orthographic_window"}) {
        for (int trial = 0; trial < 20; ++trial) {
            SCOPED_TRACE(std::string(type) + " seed " + std::to_string(seed) + " trial " + std::to_string(trial));
            Params params = random_pose(random);
            params.projection =
                params_with({std::string("projection.type=") + type, "projection.left=-0.7", "projection.top=0.5"})
                    .projection;
            const Derived derived = derived_camera(params);
            const auto corners = frustum_corners(params, derived);
            // Near, then far, each counterclockwise from bottom left as seen by the camera.
            const glm::dvec2 order[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 ndc =
                    divided(derived.clip_from_world * glm::dvec4(corners[static_cast<std::size_t>(corner)], 1.0));
                EXPECT_NEAR(ndc.x, order[corner % 4].x, 1e-9);
                EXPECT_NEAR(ndc.y, order[corner % 4].y, 1e-9);
                EXPECT_NEAR(ndc.z, corner < 4 ? -1.0 : 1.0, 1e-9);
            }
        }
    }
}

TEST(DeriveFrustum, ShowsTheCameraDespiteAViewMistake) {
    const Params right = params_with({"camera.position=[1,2,3]"});
    const Params broken = params_with({"camera.position=[1,2,3]", "slips.camera_as_view=true"});
    EXPECT_EQ(frustum_corners(right, derived_camera(right)), frustum_corners(broken, derived_camera(broken)));
}

TEST(DeriveObserver, LooksAtItsTargetFromItsDistance) {
    Random random(seed);
    for (int trial = 0; trial < 50; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        ObserverParams observer;
        observer.target = random.vec3(5);
        observer.yaw = random.number(-180, 180);
        observer.pitch = random.number(-89, 89);
        observer.distance = random.number(1, 30);
        const ObserverView view = derive_observer(observer, Viewport{});
        const glm::dvec3 target_ndc = divided(view.clip_from_world * glm::dvec4(observer.target, 1.0));
        EXPECT_NEAR(target_ndc.x, 0.0, 1e-9);
        EXPECT_NEAR(target_ndc.y, 0.0, 1e-9);
        EXPECT_NEAR(glm::distance(divided(view.eye_world), observer.target), observer.distance, 1e-9);
        EXPECT_LT(worst_difference(view.view_from_world * view.world_from_view, glm::dmat4(1.0)), 1e-9);
        const glm::dvec4 above = view.clip_from_world * glm::dvec4(observer.target + glm::dvec3(0, 0.1, 0), 1.0);
        EXPECT_GT(divided(above).y, 0.0);  // up stays up
    }
}

TEST(DeriveMovingWorld, CameraFixedPointsStay) {
    Random random(seed);
    const ObserverParams observer;
    const glm::dvec4 fixed_to_camera[] = {{0, 0, 0, 1}, {0, 0, -2, 1}, {0.4, -0.3, -1, 1}};
    const Params somewhere = random_pose(random);
    const ObserverView first = derive_moving_world(observer, derived_camera(somewhere), Viewport{});
    for (int trial = 0; trial < 50; ++trial) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        const Params params = random_pose(random);
        const ObserverView view = derive_moving_world(observer, derived_camera(params), Viewport{});
        for (const glm::dvec4& point : fixed_to_camera) {
            const glm::dvec3 there = divided(first.clip_from_world * lecture_camera(somewhere.camera) * point);
            const glm::dvec3 here = divided(view.clip_from_world * lecture_camera(params.camera) * point);
            EXPECT_LT(glm::length(there - here), 1e-9);
        }
        EXPECT_LT(glm::length(glm::dvec3(view.view_from_world * view.eye_world)), 1e-9);
        // The world has moved, so its origin is elsewhere.
        const glm::dvec3 origin = divided(view.view_from_world[3]), before = divided(first.view_from_world[3]);
        EXPECT_GT(glm::length(origin - before), 1e-3);
    }
}

bool is_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

bool is_finite(const glm::dvec3& vector) {
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

TEST(DeriveEverything, IsFiniteForAnySetting) {
    constexpr unsigned first_seed = 7100;
    for (unsigned run = 0; run < 300; ++run) {
        SCOPED_TRACE("seed " + std::to_string(first_seed + run));
        Params params = testing::RandomParams(first_seed + run).make();
        clamp_to_ranges(params);
        const Viewport viewport{{1 + static_cast<int>(run % 7) * 300, 1 + static_cast<int>(run % 5) * 200},
                                run % 2 == 0};
        const Derived derived = derive(params, box_scene(), viewport);
        for (const glm::dmat4* matrix :
             {&derived.world_from_view, &derived.view_from_world, &derived.clip_from_view, &derived.clip_from_world})
            EXPECT_TRUE(is_finite(*matrix));
        for (const DerivedPlane& plane : derived.planes) {
            EXPECT_TRUE(is_finite(plane.mirrored_world_from_world));
            EXPECT_TRUE(is_finite(plane.patch.world_from_patch()));
            for (const CastShadow& cast : plane.shadows) EXPECT_TRUE(is_finite(cast.shadowed_world_from_world));
        }
        const Facts& facts = derived.facts;
        for (const double number :
             {derived.chosen_shadow().plane_dot_light, facts.view_residual, facts.depth_step_at_target,
              facts.target_distance, derived.planes[0].eye_side, derived.aspect})
            EXPECT_TRUE(std::isfinite(number));
        EXPECT_GT(facts.depth_step_at_target, 0.0);
        for (const glm::dvec3& corner : frustum_corners(params, derived)) EXPECT_TRUE(is_finite(corner));
        if (derived.followed) {
            EXPECT_TRUE(is_finite(derived.followed->mirrored_world));
            EXPECT_TRUE(is_finite(derived.followed->foot_world));
        }
        const ObserverView observer = derive_observer(params.observer, viewport);
        EXPECT_TRUE(is_finite(observer.clip_from_world));
        for (const FramePlan& frame : {plan(params, derived), plan_observer(params, derived, observer)}) {
            for (const Pass& pass : frame.passes) {
                EXPECT_TRUE(is_finite(pass.clip_from_world * pass.world_from_scene)) << say(pass.name);
                EXPECT_FALSE(gl_calls(frame, pass, first_gl_state()).empty());
            }
        }
    }
}

}  // namespace
}  // namespace viewing
