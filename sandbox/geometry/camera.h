// The camera's pose as angles and as matrices. Angles are in degrees, as in the state file. Source: lecture, Camera
// Movement; with pitch and roll added, V = (T Ry Rx Rz)⁻¹.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace viewing {

/// Yaw about y, then pitch about x, then roll about z, each in the frame that results from the previous one (degrees).
struct Angles {
    double yaw_deg = 0.0;
    double pitch_deg = 0.0;
    double roll_deg = 0.0;
    bool operator==(const Angles&) const = default;
};

/// Returns R = Ry(yaw) Rx(pitch) Rz(roll).
glm::dmat4 rotation_from_angles(const Angles& angles);

/// Returns the angles of a rotation: yaw and roll in (−180, 180], pitch in [−90, 90]. At the poles (|pitch| = 90), roll
/// and yaw rotate about the same axis; there, roll is 0 and yaw is the whole rotation.
Angles angles_from_rotation(const glm::dmat3& rotation);

/// Returns C = T(position) R, whose columns are right, up, back and the eye. With all angles 0, the camera looks along
/// −z.
glm::dmat4 world_from_view(const glm::dvec3& position, const Angles& angles);

/// Returns V = C⁻¹ for a rigid C, built from Rᵀ and −Rᵀ·eye without a general matrix inverse.
glm::dmat4 view_from_world(const glm::dmat4& world_from_view);

/// Returns whether the last row is (0, 0, 0, 1), up to 1e-9: w stays 1.
bool is_affine(const glm::dmat4& matrix);

/// Returns whether the matrix is affine and its axes are perpendicular unit vectors, up to 1e-12: a V or C, perhaps
/// mirrored.
bool is_rigid(const glm::dmat4& matrix);

/// Returns T(position) R(rotation) S(scale), the matrix that places an object.
glm::dmat4 world_from_model(const glm::dvec3& position, const Angles& rotation, const glm::dvec3& scale);

/// Returns the angles (roll 0) of a camera at `eye` that looks at `target`. If the two points coincide, the camera
/// looks along −z.
Angles angles_looking_at(const glm::dvec3& eye, const glm::dvec3& target);

}  // namespace viewing
