// Navigation: the limits of each mode, frame-rate independence, coming to rest, and the effect of each common mistake.
#include "geometry/navigation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/geometry/expect_near.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::expect_near;

constexpr MotionTuning tuning;
constexpr MotionTuning at_once{.smoothing_s = 0.0};

/// Holds `input` for `seconds` in frames of `dt`.
Pose hold(Pose pose, Motion& motion, const MotionInput& input, Navigation mode, double seconds, double dt,
          const MotionSlips& slips = {}, const MotionTuning& used = tuning) {
    for (int frame = 0; frame < static_cast<int>(std::round(seconds / dt)); ++frame) {
        pose = step(pose, motion, input, mode, slips, used, dt);
    }
    return pose;
}

Pose held_at_once(const Pose& pose, const MotionInput& input, Navigation mode, double seconds,
                  const MotionSlips& slips = {}) {
    Motion motion;
    return hold(pose, motion, input, mode, seconds, 0.01, slips, at_once);
}

glm::dmat3 axes_of(const Pose& pose) {
    return glm::dmat3(rotation_from_angles(pose.angles));
}

MotionInput everything_held() {
    MotionInput input;
    input.move = {0.7, -0.4, 1.0};
    input.yaw = 1.0, input.pitch = -0.6, input.roll = 0.3;
    return input;
}

TEST(Fly, MovesAlongTheCamerasOwnAxes) {
    const Pose start{{1, 2, 3}, {35, -50, 20}, {}};
    const glm::dmat3 axes = axes_of(start);
    const glm::dvec3 own[] = {axes[0], axes[1], -axes[2]};  // right, up, forward
    for (int i = 0; i < 3; ++i) {
        MotionInput input;
        input.move[i] = 1;
        const Pose end = held_at_once(start, input, Navigation::fly, 1.0);
        expect_near(end.position, start.position + 2.5 * own[i], 1e-9);
        EXPECT_EQ(end.angles, start.angles) << "unchanged to the last bit";
    }
}

TEST(Fly, TurnsAboutTheCamerasOwnAxes) {
    const Pose start{{1, 2, 3}, {35, -50, 20}, {}};
    const glm::dmat4 before = rotation_from_angles(start.angles);
    const Angles half_second[] = {{30, 0, 0}, {0, 30, 0}, {0, 0, 30}};  // at 60°/s
    for (int i = 0; i < 3; ++i) {
        MotionInput input;
        (i == 0 ? input.yaw : i == 1 ? input.pitch : input.roll) = 1;
        const Pose end = held_at_once(start, input, Navigation::fly, 0.5);
        EXPECT_LT(worst_difference(rotation_from_angles(end.angles), before * rotation_from_angles(half_second[i])),
                  1e-9);
        EXPECT_EQ(end.position, start.position);
    }
}

TEST(Fly, ADragThatKeepsTheHorizonTurnsYawAndPitchAlone) {
    Random random(4);
    for (int round = 0; round < 200; ++round) {
        const double yaw = random.number(-180, 180), pitch = random.number(-60, 60), roll = random.number(-90, 90);
        Pose pose{{1, 2, 3}, {yaw, pitch, round % 2 == 0 ? 0.0 : roll}, {}};
        const Pose start = pose;
        glm::dvec2 turned(0.0);
        for (int drag = 0; drag < 5; ++drag) {
            MotionInput input;
            input.keeps_horizon = true;
            input.look_deg = {random.number(-20, 20), random.number(-5, 5)};
            turned += input.look_deg;
            Motion motion;
            pose = step(pose, motion, input, Navigation::fly, {}, tuning, 0.0);
        }
        EXPECT_EQ(pose.position, start.position);
        EXPECT_EQ(pose.angles.roll_deg, start.angles.roll_deg);
        EXPECT_NEAR(pose.angles.pitch_deg, pitch + turned.y, 1e-9);
        EXPECT_NEAR(std::remainder(pose.angles.yaw_deg - yaw - turned.x, 360.0), 0.0, 1e-9);
        EXPECT_TRUE(round % 2 != 0 || std::abs(axes_of(pose)[0].y) < 1e-9) << "the camera's right axis is level";
    }
    MotionInput up;
    up.keeps_horizon = true;
    up.look_deg.y = 300.0;
    Motion motion;
    EXPECT_EQ(step({}, motion, up, Navigation::fly, {}, tuning, 0.0).angles.pitch_deg, 89.9);
    EXPECT_EQ(step({{}, {0, 120, 0}, {}}, motion, up, Navigation::fly, {}, tuning, 0.0).angles.pitch_deg, 120.0)
        << "a camera that is upside down stays so";
}

TEST(Fly, ADragAboutTheCamerasOwnAxesTiltsTheHorizon) {
    MotionInput input;
    input.look_deg = {40.0, 0.0};
    Motion motion;
    const Pose end = step({{}, {30, -40, 0}, {}}, motion, input, Navigation::fly, {}, tuning, 0.0);
    EXPECT_GT(std::abs(axes_of(end)[0].y), 0.1);
}

TEST(Fly, AnOrbitingDragKeepsItsCenterInPlaceInThePicture) {
    Random random(5);
    for (int round = 0; round < 200; ++round) {
        const Pose start{{random.number(-5, 5), random.number(-5, 5), random.number(-5, 5)},
                         {random.number(-180, 180), random.number(-60, 60), 0.0},
                         {7, 8, 9}};
        MotionInput input;
        input.orbit_center = {random.number(-5, 5), random.number(-5, 5), random.number(-5, 5)};
        input.orbit_deg = {random.number(-90, 90), random.number(-20, 20)};
        Motion motion;
        const Pose end = step(start, motion, input, Navigation::fly, {}, tuning, 0.0);
        const auto in_view = [&](const Pose& pose) {
            return glm::transpose(axes_of(pose)) * (input.orbit_center - pose.position);
        };
        expect_near(in_view(end), in_view(start), 1e-9);
        EXPECT_NEAR(axes_of(end)[0].y, 0.0, 1e-9);
        EXPECT_EQ(end.target, start.target);
        EXPECT_NE(end.angles, start.angles);
    }
    MotionInput input, look;
    input.orbit_deg = look.look_deg = {30.0, 10.0};
    const Pose start{{0, 1, 5}, {0, 0, 0}, {0, 1, 0}};
    for (const Navigation mode : {Navigation::orbit, Navigation::walk}) {
        Motion motion;
        const Pose orbited = step(start, motion, input, mode, {}, tuning, 0.0);
        const Pose looked = step(start, motion, look, mode, {}, tuning, 0.0);
        EXPECT_EQ(orbited.position, looked.position);
        EXPECT_EQ(orbited.angles, looked.angles);
    }
}

TEST(Fly, OrderOfYawAndPitchMatters) {
    const Pose start;
    MotionInput yaw, pitch;
    yaw.look_deg = {30, 0};
    pitch.look_deg = {0, 40};
    Motion motion;
    const auto look = [&](const Pose& pose, const MotionInput& input) {
        return step(pose, motion, input, Navigation::fly, {}, tuning, 0.0);
    };
    const Pose yaw_first = look(look(start, yaw), pitch), pitch_first = look(look(start, pitch), yaw);
    EXPECT_NEAR(yaw_first.angles.roll_deg, 0, 1e-9);
    EXPECT_NEAR(yaw_first.angles.yaw_deg, 30, 1e-9);
    EXPECT_NEAR(yaw_first.angles.pitch_deg, 40, 1e-9);
    EXPECT_GT(std::abs(pitch_first.angles.roll_deg), 10) << "yaw about the pitched camera's own up";
}

TEST(Fly, LoopsThroughThePoleWithoutAJump) {
    Pose pose{{0, 0, 0}, {20, 80, 0}, {}};
    MotionInput up;
    up.pitch = 1;
    Motion motion;
    double path = 0;
    for (int frame = 0; frame < 600; ++frame) {
        const Pose next = step(pose, motion, up, Navigation::fly, {}, at_once, 0.01);
        const double turned = glm::degrees(std::acos(std::min(1.0, glm::dot(axes_of(pose)[2], axes_of(next)[2]))));
        EXPECT_NEAR(turned, 0.6, 1e-3);
        path += turned;
        pose = next;
    }
    EXPECT_NEAR(path, 360, 1e-2);
    expect_near({pose.angles.yaw_deg, pose.angles.pitch_deg, pose.angles.roll_deg}, {20, 80, 0}, 1e-6);
}

TEST(Fly, StaysARotationForever) {
    Motion motion;
    const Pose end = hold({}, motion, everything_held(), Navigation::fly, 100, 0.016);
    const glm::dmat4 rotation = rotation_from_angles(end.angles);
    EXPECT_LT(worst_difference(rotation * glm::transpose(rotation), glm::dmat4(1.0)), 1e-13);
}

TEST(Walk, SpeedDoesNotDependOnPitch) {
    MotionInput forward;
    forward.move.z = 1;
    for (const double pitch : {0.0, 45.0, -60.0, 89.0, 90.0, -90.0}) {
        const Pose start{{0, 1.7, 0}, {30, pitch, 0}, {}};
        const Pose end = held_at_once(start, forward, Navigation::walk, 1.0);
        const double yaw = glm::radians(30.0);
        expect_near(end.position, {-2.5 * std::sin(yaw), 1.7, -2.5 * std::cos(yaw)}, 1e-9);
    }
}

TEST(Walk, UpsideDownMovesWhereTheCameraLooks) {
    MotionInput forward;
    forward.move.z = 1;
    const Pose end = held_at_once({{0, 0, 0}, {0, 150, 0}, {}}, forward, Navigation::walk, 1.0);
    expect_near(end.position, {0, 0, 2.5}, 1e-9);
}

TEST(Walk, NeverChangesHeightPitchOrRoll) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (int i = 0; i < 50; ++i) {
        Pose pose{random.vec3(9), random.angles(), {}};
        const Pose start = pose;
        Motion motion;
        MotionInput input = everything_held();
        input.look_deg = {1.3, 2.4};
        input.pan = {1, 1};
        input.zoom = 0.5;
        pose = hold(pose, motion, input, Navigation::walk, 2, 0.017);
        EXPECT_EQ(pose.position.y, start.position.y);
        EXPECT_EQ(pose.angles.pitch_deg, start.angles.pitch_deg);
        EXPECT_EQ(pose.angles.roll_deg, start.angles.roll_deg);
        EXPECT_EQ(pose.target, start.target);
        EXPECT_NE(pose.angles.yaw_deg, start.angles.yaw_deg);
        EXPECT_NE(pose.position, start.position);
    }
}

TEST(Walk, StrafeLiftPitchAndRollDoNothing) {
    const Pose start{{1, 2, 3}, {10, 20, 30}, {}};
    MotionInput input;
    input.move = {1, 1, 0};
    input.pitch = input.roll = 1;
    input.look_deg = {0, 25};
    Motion motion;
    const Pose end = hold(start, motion, input, Navigation::walk, 1, 0.01);
    EXPECT_EQ(end.position, start.position);
    EXPECT_EQ(end.angles, start.angles);
    EXPECT_TRUE(motion.at_rest());
}

TEST(Walk, YawIsAboutTheWorldsY) {
    const Pose start{{0, 0, 0}, {0, -40, 15}, {}};
    MotionInput left;
    left.yaw = 1;
    const Pose end = held_at_once(start, left, Navigation::walk, 1.5);
    const glm::dmat4 turned = rotation_from_angles({90, 0, 0}) * rotation_from_angles(start.angles);
    EXPECT_LT(worst_difference(rotation_from_angles(end.angles), turned), 1e-9);
}

TEST(Walk, YawStaysWithinOneTurn) {
    MotionInput drag;
    drag.look_deg = {100, 0};
    Motion motion;
    Pose pose;
    for (int i = 0; i < 5; ++i) {
        pose = step(pose, motion, drag, Navigation::walk, {}, tuning, 0.01);
    }
    EXPECT_NEAR(pose.angles.yaw_deg, 500 - 360, 1e-9);
}

TEST(Orbit, KeepsDistanceAimAndRoll) {
    Pose pose{{4, 3, 5}, {}, {0, 1, 0}};
    pose.angles = angles_looking_at(pose.position, pose.target);
    pose.angles.roll_deg = 12;
    const double distance = glm::length(pose.position - pose.target);
    MotionInput input;
    input.yaw = 0.4, input.pitch = -0.2, input.roll = 1;
    input.look_deg = {0.5, 0.1};
    Motion motion;
    const Pose end = hold(pose, motion, input, Navigation::orbit, 3, 0.02);
    EXPECT_GT(glm::length(end.position - pose.position), 1.0);
    EXPECT_NEAR(glm::length(end.position - end.target), distance, 1e-9);
    EXPECT_EQ(end.angles.roll_deg, 12.0);
    EXPECT_EQ(end.target, pose.target);
    expect_near(end.position - axes_of(end)[2] * distance, end.target, 1e-9);
}

TEST(Orbit, PitchStopsBeforeThePoles) {
    Pose pose{{0, 0, 5}, {}, {0, 0, 0}};
    for (const double direction : {1.0, -1.0}) {
        MotionInput input;
        input.pitch = direction;
        Motion motion;
        const Pose end = hold(pose, motion, input, Navigation::orbit, 5, 0.02);
        EXPECT_DOUBLE_EQ(end.angles.pitch_deg, direction * 89.9);
        EXPECT_EQ(end.angles.yaw_deg, 0.0) << "no flip";
    }
    const Pose above{{0, 5, 0}, {0, -90, 0}, {0, 0, 0}};
    MotionInput down;
    down.pitch = -1;
    Motion motion;
    EXPECT_EQ(hold(above, motion, down, Navigation::orbit, 1, 0.02).angles.pitch_deg, -90.0) << "no jump back";
}

TEST(Orbit, SidewaysAndUpKeysCircleTheTarget) {
    const Pose start{{0, 0, 5}, {}, {0, 0, 0}};
    MotionInput right;
    right.move.x = 1;
    const Pose end = held_at_once(start, right, Navigation::orbit, 1.5);
    expect_near(end.position, {5, 0, 0}, 1e-9);
    MotionInput up;
    up.move.y = 1;
    EXPECT_GT(held_at_once(start, up, Navigation::orbit, 0.5).position.y, 1.0);
}

TEST(Orbit, ZoomScalesTheDistanceAndPanShiftsBoth) {
    const Pose start{{0, 0, 5}, {}, {0, 0, 0}};
    MotionInput input;
    input.zoom = 0.5;
    Motion motion;
    expect_near(step(start, motion, input, Navigation::orbit, {}, tuning, 0.01).position, {0, 0, 2.5}, 1e-12);
    input.zoom = 1e-9;
    EXPECT_NEAR(step(start, motion, input, Navigation::orbit, {}, tuning, 0.01).position.z, 0.01, 1e-12)
        << "never reaches the target";

    MotionInput pan;
    EXPECT_TRUE(pan.idle());
    pan.dolly = 1.0;
    EXPECT_FALSE(pan.idle());
    pan.dolly = 0.0;
    pan.pan = {1, 2};
    const Pose panned = step(start, motion, pan, Navigation::orbit, {}, tuning, 0.01);
    expect_near(panned.position, {1, 2, 5}, 1e-12);
    expect_near(panned.target, {1, 2, 0}, 1e-12);

    MotionInput forward;
    forward.move.z = 1;
    EXPECT_NEAR(held_at_once(start, forward, Navigation::orbit, 1.0).position.z, 5 / std::exp(1.0), 1e-9);
}

TEST(Step, IsIndependentOfTheFrameRate) {
    for (const Navigation mode : {Navigation::fly, Navigation::walk, Navigation::orbit}) {
        const Pose start{{3, 2, 4}, {20, -10, 5}, {0, 1, 0}};
        Motion reference_motion;
        Pose reference = hold(start, reference_motion, everything_held(), mode, 1.0, 0.001);
        reference = hold(reference, reference_motion, {}, mode, 1.0, 0.001);
        for (const double dt : {0.1, 0.05, 0.02, 1.0 / 60.0, 0.01, 0.005}) {
            SCOPED_TRACE(::testing::Message() << "mode " << static_cast<int>(mode) << " dt " << dt);
            Motion motion;
            Pose pose = hold(start, motion, everything_held(), mode, 1.0, dt);
            pose = hold(pose, motion, {}, mode, 1.0, dt);
            expect_near(pose.position, reference.position, 2e-3);
            EXPECT_LT(worst_difference(rotation_from_angles(pose.angles), rotation_from_angles(reference.angles)),
                      2e-3);
        }
        // At full speed, rotation bends the path most.
        Motion one = reference_motion;
        Pose cruising = hold(start, one, everything_held(), mode, 1.0, 0.01);
        Motion ten = one;
        const Pose once = step(cruising, one, everything_held(), mode, {}, tuning, 0.1);
        const Pose often = hold(cruising, ten, everything_held(), mode, 0.1, 0.01);
        EXPECT_GT(glm::length(once.position - cruising.position), 0.1);
        expect_near(once.position, often.position, 2e-6);
        EXPECT_LT(glm::length(one.velocity - ten.velocity), 1e-12);
        EXPECT_LT(glm::length(one.turn_rate_deg - ten.turn_rate_deg), 1e-12);
    }
}

TEST(Step, StartsAndStopsSmoothlyAndRestsExactly) {
    MotionInput forward;
    forward.move.z = 1;
    Motion motion;
    Pose pose = step({}, motion, forward, Navigation::fly, {}, tuning, 0.012);
    EXPECT_NEAR(motion.velocity.z, 2.5 * (1 - std::exp(-0.1)), 1e-12) << "exponential, time constant 0.12 s";
    EXPECT_FALSE(motion.at_rest());
    pose = hold(pose, motion, forward, Navigation::fly, 2, 0.01);
    EXPECT_NEAR(motion.velocity.z, 2.5, 1e-6);

    const glm::dvec3 released = pose.position;
    pose = hold(pose, motion, {}, Navigation::fly, 0.1, 0.01);
    EXPECT_FALSE(motion.at_rest());
    pose = hold(pose, motion, {}, Navigation::fly, 1.4, 0.01);
    EXPECT_TRUE(motion.at_rest());
    EXPECT_NEAR(glm::length(pose.position - released), 2.5 * 0.12, 1e-3) << "coasts for speed × time constant";
    const Pose later = step(pose, motion, {}, Navigation::fly, {}, tuning, 0.1);
    EXPECT_EQ(later.position, pose.position);
    EXPECT_EQ(later.angles, pose.angles);
}

TEST(Step, ClampsStallsAndInvalidTimes) {
    MotionInput forward;
    forward.move.z = 1;
    Motion a, b, c;
    const Pose stalled = step({}, a, forward, Navigation::fly, {}, tuning, 5.0);
    const Pose quarter = step({}, b, forward, Navigation::fly, {}, tuning, 0.25);
    EXPECT_EQ(stalled.position, quarter.position);
    for (const double dt : {0.0, -1.0, std::nan("")}) {
        EXPECT_EQ(step({}, c, forward, Navigation::fly, {}, tuning, dt).position, glm::dvec3(0));
    }
    EXPECT_TRUE(c.at_rest());
}

TEST(Step, SlowIsAQuarterAndDiagonalsAreNoFaster) {
    MotionInput input;
    input.move = {1, 0, 1};
    EXPECT_NEAR(glm::length(held_at_once({}, input, Navigation::fly, 1).position), 2.5, 1e-9);
    input.slow = true;
    input.yaw = 1;
    Motion motion;
    hold({}, motion, input, Navigation::fly, 1, 0.01, {}, at_once);
    EXPECT_NEAR(glm::length(motion.velocity), 2.5 / 4, 1e-12);
    EXPECT_NEAR(motion.turn_rate_deg.y, 15, 1e-12);
}

TEST(Step, ChangingTheModeDropsUnsupportedMotion) {
    Motion motion;
    hold({}, motion, everything_held(), Navigation::fly, 1, 0.01);
    const Pose start{{0, 1.7, 0}, {0, -30, 10}, {}};
    const Pose end = hold(start, motion, {}, Navigation::walk, 1.5, 0.01);
    EXPECT_EQ(end.position.y, 1.7);
    EXPECT_EQ(end.angles.roll_deg, 10.0);
    EXPECT_TRUE(motion.at_rest());
}

TEST(NavigationMistakes, WalkSlowsWhenLookingDown) {
    MotionInput forward;
    forward.move.z = 1;
    const MotionSlips slips{.walk_slows = true};
    const Pose end = held_at_once({{0, 1.7, 0}, {0, -60, 0}, {}}, forward, Navigation::walk, 1, slips);
    expect_near(end.position, {0, 1.7, -2.5 * 0.5}, 1e-9);
    const Pose level = held_at_once({{0, 1.7, 0}, {0, 0, 0}, {}}, forward, Navigation::walk, 1, slips);
    expect_near(level.position, {0, 1.7, -2.5}, 1e-9);
}

TEST(NavigationMistakes, RollCreepsIn) {
    MotionInput look;
    look.look_deg = {2, 1};
    for (const Navigation mode : {Navigation::walk, Navigation::orbit}) {
        const Pose start{{0, 1, 5}, {0, -20, 0}, {}};
        Pose right = start, wrong = start;
        Motion motion;
        for (int i = 0; i < 20; ++i) {
            right = step(right, motion, look, mode, {}, tuning, 0.01);
            wrong = step(wrong, motion, look, mode, {.creeping_roll = true}, tuning, 0.01);
        }
        EXPECT_EQ(right.angles.roll_deg, 0.0);
        EXPECT_GT(std::abs(wrong.angles.roll_deg), 1.0);
        EXPECT_NEAR(glm::length(wrong.position), glm::length(start.position), 1e-9);
    }
}

TEST(NavigationMistakes, OrbitFlipsAtThePoleOnceAndContinues) {
    const Pose start{{0, 0, 5}, {}, {0, 0, 0}};
    MotionInput over;
    over.pitch = -1;  // the eye climbs
    Motion motion;
    Pose pose = start;
    int flips = 0;
    for (int frame = 0; frame < 249; ++frame) {  // 149° at 60°/s
        const Pose next = step(pose, motion, over, Navigation::orbit, {.pole_flip = true}, at_once, 0.01);
        flips += glm::dot(axes_of(pose)[0], axes_of(next)[0]) < 0.0;
        pose = next;
    }
    EXPECT_EQ(flips, 1) << "right becomes left at the pole";
    EXPECT_LT(pose.position.z, -4.0) << "past the pole, on the other side";
    EXPECT_NEAR(glm::length(pose.position), 5, 1e-9);
    EXPECT_EQ(pose.angles.roll_deg, 0.0);

    Motion other;
    const Pose limited = hold(start, other, over, Navigation::orbit, 2.49, 0.01);
    EXPECT_GT(limited.position.z, 0.0) << "without the mistake it stops";
}

TEST(Freedoms, AreAvailableByModeAndMoving) {
    EXPECT_EQ(available_freedoms(Navigation::fly), (MovingFreedoms{true, true, true, true, true, true}));
    EXPECT_EQ(
        available_freedoms(Navigation::walk),
        (MovingFreedoms{.forward = true, .strafe = false, .lift = false, .yaw = true, .pitch = false, .roll = false}));
    EXPECT_EQ(available_freedoms(Navigation::orbit), (MovingFreedoms{true, true, true, true, true, false}));

    MotionInput input;
    input.move.z = 1;
    input.roll = 1;
    Motion motion;
    step({}, motion, input, Navigation::fly, {}, tuning, 0.01);
    EXPECT_EQ(
        moving_freedoms(motion, input, Navigation::fly),
        (MovingFreedoms{.forward = true, .strafe = false, .lift = false, .yaw = false, .pitch = false, .roll = true}));
    MotionInput drag;
    drag.look_deg = {1, 1};
    EXPECT_EQ(
        moving_freedoms({}, drag, Navigation::walk),
        (MovingFreedoms{.forward = false, .strafe = false, .lift = false, .yaw = true, .pitch = false, .roll = false}));
    EXPECT_EQ(moving_freedoms({}, {}, Navigation::orbit), MovingFreedoms{});
    EXPECT_TRUE(MotionInput{}.idle());
    EXPECT_FALSE(drag.idle());
}

TEST(Navigation, FlightPansAndDolliesAlongItsOwnAxes) {
    const Pose start{{1, 2, 3}, {90, 0, 0}, {0, 0, 0}};  // looks along −x: right is −z
    MotionInput input;
    input.pan = {1, 2};
    input.dolly = 4.0;
    Motion motion;
    const Pose flown = step(start, motion, input, Navigation::fly, {}, {}, 0.0);
    EXPECT_LT(glm::distance(flown.position, glm::dvec3(1 - 4, 2 + 2, 3 - 1)), 1e-12);
    EXPECT_EQ(flown.target, start.target);
    EXPECT_TRUE(motion.at_rest());
    const MovingFreedoms moving = moving_freedoms(motion, input, Navigation::fly);
    EXPECT_TRUE(moving.forward && moving.strafe && moving.lift);

    const Pose below{{1, 2, 3}, {90, -40, 0}, {0, 0, 0}};
    const Pose walked = step(below, motion, input, Navigation::walk, {}, {}, 0.0);
    EXPECT_LT(glm::distance(walked.position, glm::dvec3(1 - 4, 2, 3)), 1e-12) << "on the ground, and not sideways";
    const MovingFreedoms on_foot = moving_freedoms(motion, input, Navigation::walk);
    EXPECT_TRUE(on_foot.forward && !on_foot.strafe && !on_foot.lift);
}

}  // namespace
}  // namespace viewing
