// The motion model. Held keys set the requested rates, the actual rates approach these exponentially, and the pose is
// integrated in short substeps.
#include "geometry/navigation.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

using Vec3 = glm::dvec3;

constexpr double max_step_s = 0.25, max_substep_s = 1.0 / 240.0;
constexpr double slow_factor = 0.25;
constexpr double max_level_pitch_deg = 89.9, min_orbit_distance = 0.01;
constexpr double orbit_zoom_length = 2.5;  // moving forward by this length divides the eye's distance by e = 2.718
constexpr double rest_fraction = 1e-3;     // motion at or below this fraction of the full rate counts as rest

double wrapped(double degrees) {
    const double turned = std::remainder(degrees, 360.0);
    return turned <= -180.0 ? 180.0 : turned;
}

glm::dquat quaternion(const Angles& angles) {
    return glm::quat_cast(glm::dmat3(rotation_from_angles(angles)));
}

/// Returns the rotation that turns about the x, y and z axes simultaneously by the given degrees.
glm::dquat turn_about_own_axes(const Vec3& degrees) {
    const double angle = glm::radians(glm::length(degrees));
    return angle == 0.0 ? glm::dquat(1.0, 0.0, 0.0, 0.0) : glm::angleAxis(angle, glm::normalize(degrees));
}

/// Returns `angles` after a rotation about the camera's own axes; a zero rotation leaves them unchanged.
Angles turned_about_own_axes(const Angles& angles, const Vec3& degrees) {
    if (degrees == Vec3(0.0)) {
        return angles;
    }
    return angles_from_rotation(glm::mat3_cast(glm::normalize(quaternion(angles) * turn_about_own_axes(degrees))));
}

Vec3 view_forward(const Angles& angles) {
    return -Vec3(rotation_from_angles(angles)[2]);
}

/// Returns the view direction, projected onto the ground and normalized. It is computed from the yaw, so it exists even
/// for a view straight down. An upside-down camera looks opposite to its yaw.
Vec3 ground_forward(const Angles& angles) {
    const bool upside_down = std::abs(std::remainder(angles.pitch_deg, 360.0)) > 90.0;
    return (upside_down ? -1.0 : 1.0) * view_forward({angles.yaw_deg, 0.0, 0.0});
}

/// Sets to zero every motion that the mode does not allow.
void keep_available(Vec3& move, Vec3& turn, Navigation mode, const MotionSlips& slips) {
    const MovingFreedoms can = available_freedoms(mode);
    const bool local_look = slips.creeping_roll && mode == Navigation::walk;
    move *= Vec3(can.strafe, can.lift, can.forward);
    turn *= Vec3(can.pitch || local_look, can.yaw, can.roll);
    if (mode == Navigation::orbit) {  // in orbit, moving sideways and up are rotations: see wanted_rates
        move.x = move.y = 0.0;
    }
}

/// The rates that the held keys request.
struct WantedRates {
    Vec3 velocity, turn_rate_deg;
};

WantedRates wanted_rates(const MotionInput& input, Navigation mode, const MotionSlips& slips,
                         const MotionTuning& tuning) {
    const double factor = input.slow ? slow_factor : 1.0;
    Vec3 move = input.move / std::max(1.0, glm::length(input.move));
    Vec3 turn(input.pitch, input.yaw, input.roll);
    if (mode == Navigation::orbit) {  // moving right around the target means turning left, moving up means looking down
        turn += Vec3(-move.y, move.x, 0.0);
    }
    turn = glm::clamp(turn, -1.0, 1.0);
    keep_available(move, turn, mode, slips);
    return {move * (tuning.speed * factor), turn * (tuning.turn_deg * factor)};
}

/// Moves `rate` toward `wanted` for dt_s seconds and returns its integral over that time; both are computed exactly.
Vec3 approach(Vec3& rate, const Vec3& wanted, double full_rate, double smoothing_s, double dt_s) {
    const double left_over = smoothing_s > 0.0 ? std::exp(-dt_s / smoothing_s) : 0.0;
    const Vec3 lag = rate - wanted;
    const Vec3 path = wanted * dt_s + lag * (smoothing_s * (1.0 - left_over));
    rate = wanted + lag * left_over;
    if (wanted == Vec3(0.0) && glm::length(rate) <= rest_fraction * full_rate) {
        rate = Vec3(0.0);
    }
    return path;
}

/// Returns `angles` after a rotation of yaw about the world's y axis and of pitch about the camera's level right axis;
/// roll stays. The pitch stops at ±89.9°; a camera already beyond that is not forced back, but cannot go farther.
Angles turned_level(Angles angles, const Vec3& turn) {
    if (turn.y != 0.0) angles.yaw_deg = wrapped(angles.yaw_deg + turn.y);
    const double limit = std::max(max_level_pitch_deg, std::abs(angles.pitch_deg));
    angles.pitch_deg = std::clamp(angles.pitch_deg + turn.x, -limit, limit);
    return angles;
}

Pose fly(Pose pose, const Vec3& path, const Vec3& turn) {
    const Angles halfway = turned_about_own_axes(pose.angles, turn * 0.5);
    pose.position += glm::dmat3(rotation_from_angles(halfway)) * Vec3(path.x, path.y, -path.z);
    pose.angles = turned_about_own_axes(pose.angles, turn);
    return pose;
}

Pose walk(Pose pose, const Vec3& path, const Vec3& turn, const MotionSlips& slips) {
    const double height = pose.position.y;
    const Angles halfway{pose.angles.yaw_deg + turn.y * 0.5, pose.angles.pitch_deg, pose.angles.roll_deg};
    pose.position += path.z * (slips.walk_slows ? view_forward(halfway) : ground_forward(halfway));
    pose.position.y = height;
    if (slips.creeping_roll) {
        pose.angles = turned_about_own_axes(pose.angles, turn);
    } else if (turn.y != 0.0) {
        pose.angles.yaw_deg = wrapped(pose.angles.yaw_deg + turn.y);
    }
    return pose;
}

/// Rotates the whole camera about a center so that it ends up at `angles`.
void carry_about(const Vec3& center, Pose& pose, const Angles& angles) {
    const glm::dmat3 before(rotation_from_angles(pose.angles)), after(rotation_from_angles(angles));
    pose.position = center + after * (glm::transpose(before) * (pose.position - center));
    pose.angles = angles;
}

/// Demonstrates a mistake: orbits over the pole while up stays the world's y axis, so the picture flips there.
void orbit_without_limit(Pose& pose, Motion& motion, const Vec3& turn) {
    const double distance = glm::length(pose.position - pose.target);
    const Angles aim = angles_looking_at(pose.position, pose.target);
    const double yaw = aim.yaw_deg + turn.y;
    const double pitch = aim.pitch_deg + (motion.past_pole ? -turn.x : turn.x);
    motion.past_pole ^= std::abs(pitch) > 90.0;
    pose.position = pose.target - distance * view_forward({yaw, pitch, 0.0});
    pose.angles = angles_looking_at(pose.position, pose.target);
}

void orbit_turn(Pose& pose, Motion& motion, const Vec3& turn, const MotionSlips& slips) {
    if (turn == Vec3(0.0)) {
        return;
    }
    if (slips.pole_flip) {
        orbit_without_limit(pose, motion, turn);
    } else if (slips.creeping_roll) {
        carry_about(pose.target, pose, turned_about_own_axes(pose.angles, turn));
    } else {
        carry_about(pose.target, pose, turned_level(pose.angles, turn));
    }
}

/// Multiplies the distance to the target by `factor`, but does not bring the eye nearer than min_orbit_distance.
void zoom(Pose& pose, double factor) {
    const Vec3 offset = pose.position - pose.target;
    const double distance = glm::length(offset);
    if (factor == 1.0 || distance == 0.0) {
        return;
    }
    const double nearest = std::min(distance, min_orbit_distance);
    pose.position = pose.target + offset * (std::max(distance * factor, nearest) / distance);
}

void pan(Pose& pose, const glm::dvec2& shift) {
    const glm::dmat3 axes(rotation_from_angles(pose.angles));
    const Vec3 moved = axes[0] * shift.x + axes[1] * shift.y;
    pose.position += moved;
    pose.target += moved;
}

Pose moved(Pose pose, Motion& motion, const Vec3& path, const Vec3& turn, Navigation mode, const MotionSlips& slips) {
    switch (mode) {
        case Navigation::fly:
            return fly(pose, path, turn);
        case Navigation::walk:
            return walk(pose, path, turn, slips);
        case Navigation::orbit:
            break;
    }
    orbit_turn(pose, motion, turn, slips);
    zoom(pose, std::exp(-path.z / orbit_zoom_length));
    return pose;
}

}  // namespace

bool MotionInput::idle() const {
    return move == Vec3(0.0) && yaw == 0.0 && pitch == 0.0 && roll == 0.0 && look_deg == glm::dvec2(0.0) &&
           orbit_deg == glm::dvec2(0.0) && pan == glm::dvec2(0.0) && dolly == 0.0 && zoom == 1.0;
}

bool Motion::at_rest() const {
    return velocity == Vec3(0.0) && turn_rate_deg == Vec3(0.0);
}

Pose step(const Pose& pose, Motion& motion, const MotionInput& input, Navigation mode, const MotionSlips& slips,
          const MotionTuning& tuning, double dt_s) {
    keep_available(motion.velocity, motion.turn_rate_deg, mode, slips);
    motion.past_pole = motion.past_pole && mode == Navigation::orbit && slips.pole_flip;

    const bool flies = mode == Navigation::fly;
    const glm::dvec2 look_deg = flies ? input.look_deg : input.look_deg + input.orbit_deg;
    Vec3 dragged(0.0), look(look_deg.y, look_deg.x, 0.0);
    if (mode != Navigation::orbit) dragged = Vec3(input.pan, input.dolly);
    keep_available(dragged, look, mode, slips);
    const bool is_level = flies && input.keeps_horizon;
    Pose result = moved(pose, motion, dragged, is_level ? Vec3(0.0) : look, mode, slips);
    if (is_level) result.angles = turned_level(result.angles, look);
    if (flies && input.orbit_deg != glm::dvec2(0.0))
        carry_about(input.orbit_center, result,
                    turned_level(result.angles, Vec3(input.orbit_deg.y, input.orbit_deg.x, 0.0)));
    if (mode == Navigation::orbit) {
        zoom(result, input.zoom);
        pan(result, input.pan);
    }

    const WantedRates wanted = wanted_rates(input, mode, slips, tuning);
    const double step_s = dt_s > 0.0 ? std::min(dt_s, max_step_s) : 0.0;
    const double substeps = std::ceil(step_s / max_substep_s);
    for (int i = 0; i < static_cast<int>(substeps); ++i) {
        const double substep_s = step_s / substeps;
        const Vec3 path = approach(motion.velocity, wanted.velocity, tuning.speed, tuning.smoothing_s, substep_s);
        const Vec3 turn =
            approach(motion.turn_rate_deg, wanted.turn_rate_deg, tuning.turn_deg, tuning.smoothing_s, substep_s);
        result = moved(result, motion, path, turn, mode, slips);
    }
    return result;
}

MovingFreedoms available_freedoms(Navigation mode) {
    const bool walks = mode == Navigation::walk;
    return {.forward = true,
            .strafe = !walks,
            .lift = !walks,
            .yaw = true,
            .pitch = !walks,
            .roll = mode == Navigation::fly};
}

MovingFreedoms asked_freedoms(const MotionInput& input) {
    return {.forward = input.move.z != 0.0,
            .strafe = input.move.x != 0.0,
            .lift = input.move.y != 0.0,
            .yaw = input.yaw != 0.0,
            .pitch = input.pitch != 0.0,
            .roll = input.roll != 0.0};
}

MovingFreedoms moving_freedoms(const Motion& motion, const MotionInput& input, Navigation mode) {
    const MovingFreedoms can = available_freedoms(mode);
    const bool is_moved_forward = mode == Navigation::orbit ? input.zoom != 1.0 : input.dolly != 0.0;
    const glm::dvec2 orbit_deg = input.orbit_deg, carried_deg = mode == Navigation::fly ? orbit_deg : glm::dvec2(0.0);
    return {.forward = can.forward && (motion.velocity.z != 0.0 || is_moved_forward),
            .strafe = can.strafe && (motion.velocity.x != 0.0 || input.pan.x != 0.0 || carried_deg.x != 0.0),
            .lift = can.lift && (motion.velocity.y != 0.0 || input.pan.y != 0.0 || carried_deg.y != 0.0),
            .yaw = can.yaw && (motion.turn_rate_deg.y != 0.0 || input.look_deg.x != 0.0 || orbit_deg.x != 0.0),
            .pitch = can.pitch && (motion.turn_rate_deg.x != 0.0 || input.look_deg.y != 0.0 || orbit_deg.y != 0.0),
            .roll = can.roll && motion.turn_rate_deg.z != 0.0};
}

}  // namespace viewing
