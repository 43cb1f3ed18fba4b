// Converts angles to matrices and back. Read plane.cpp next.
#include "geometry/camera.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace viewing {
namespace {

/// The cosine and sine of an angle given in degrees; exact at multiples of 90°.
struct Turn {
    double cos, sin;
};

Turn turn_of(double degrees) {
    const double wrapped = std::remainder(degrees, 360.0);
    if (wrapped == 0.0) {
        return {1.0, 0.0};
    }
    if (std::abs(wrapped) == 180.0) {
        return {-1.0, 0.0};
    }
    if (std::abs(wrapped) == 90.0) {
        return {0.0, std::copysign(1.0, wrapped)};
    }
    const double radians = glm::radians(wrapped);
    return {std::cos(radians), std::sin(radians)};
}

double degrees_of(double y, double x) {
    const double degrees = glm::degrees(std::atan2(y, x));
    return degrees <= -180.0 ? 180.0 : degrees + 0.0;  // + 0 turns a negative zero into zero
}

/// If the cosine of the pitch is below this, double precision cannot distinguish yaw from roll.
constexpr double pole_cosine = 1e-9;

}  // namespace

glm::dmat4 rotation_from_angles(const Angles& angles) {
    const Turn yaw = turn_of(angles.yaw_deg), pitch = turn_of(angles.pitch_deg), roll = turn_of(angles.roll_deg);
    // The columns of Ry · Rx are the right, up and back axes before the roll.
    const glm::dvec3 level_right(yaw.cos, 0.0, -yaw.sin);
    const glm::dvec3 level_up(yaw.sin * pitch.sin, pitch.cos, yaw.cos * pitch.sin);
    const glm::dvec3 back(yaw.sin * pitch.cos, -pitch.sin, yaw.cos * pitch.cos);
    const glm::dvec3 right = roll.cos * level_right + roll.sin * level_up;
    const glm::dvec3 up = roll.cos * level_up - roll.sin * level_right;
    return {{right, 0.0}, {up, 0.0}, {back, 0.0}, {0.0, 0.0, 0.0, 1.0}};
}

Angles angles_from_rotation(const glm::dmat3& rotation) {
    const glm::dvec3 &right = rotation[0], &up = rotation[1], &back = rotation[2];
    const double pitch_cosine = std::hypot(back.x, back.z);
    Angles angles;
    angles.pitch_deg = glm::degrees(std::atan2(-back.y, pitch_cosine)) + 0.0;
    if (pitch_cosine < pole_cosine) {
        angles.pitch_deg = std::copysign(90.0, -back.y);
        angles.yaw_deg = degrees_of(-right.z, right.x);
        return angles;
    }
    angles.yaw_deg = degrees_of(back.x, back.z);
    angles.roll_deg = degrees_of(right.y, up.y);
    return angles;
}

glm::dmat4 world_from_view(const glm::dvec3& position, const Angles& angles) {
    glm::dmat4 camera = rotation_from_angles(angles);
    camera[3] = {position, 1.0};
    return camera;
}

glm::dmat4 view_from_world(const glm::dmat4& world_from_view) {
    const glm::dmat3 view_axes = glm::transpose(glm::dmat3(world_from_view));
    glm::dmat4 view(view_axes);
    view[3] = {-(view_axes * glm::dvec3(world_from_view[3])) + 0.0, 1.0};
    return view;
}

bool is_affine(const glm::dmat4& matrix) {
    const glm::dvec4 off = glm::abs(glm::transpose(matrix)[3] - glm::dvec4(0.0, 0.0, 0.0, 1.0));
    return off.x <= 1e-9 && off.y <= 1e-9 && off.z <= 1e-9 && off.w <= 1e-9;
}

bool is_rigid(const glm::dmat4& matrix) {
    const glm::dmat3 axes(matrix), off = glm::transpose(axes) * axes - glm::dmat3(1.0);
    for (int i = 0; i < 9; ++i)
        if (!(std::abs(off[i / 3][i % 3]) <= 1e-12)) return false;
    return is_affine(matrix);
}

glm::dmat4 world_from_model(const glm::dvec3& position, const Angles& rotation, const glm::dvec3& scale) {
    return glm::scale(world_from_view(position, rotation), scale);
}

Angles angles_looking_at(const glm::dvec3& eye, const glm::dvec3& target) {
    const glm::dvec3 back = eye - target;
    const double ground_distance = std::hypot(back.x, back.z);
    if (ground_distance == 0.0 && back.y == 0.0) {
        return {};
    }
    return {degrees_of(back.x, back.z), glm::degrees(std::atan2(-back.y, ground_distance)) + 0.0, 0.0};
}

}  // namespace viewing
