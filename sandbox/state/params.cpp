#include "state/params.h"

#include <algorithm>
#include <cmath>

namespace viewing {

LookAt CameraParams::look_at() const {
    constexpr double least_distance = 0.1;
    const glm::dvec3 back(rotation_from_angles(angles())[2]);
    const double depth = glm::dot(position - target, back);
    return look_at_of(position, angles(), depth >= least_distance ? depth : 1.0);
}

LookAtFault CameraParams::look(const LookAt& look_at) {
    const Looking looking = camera_looking_at(look_at);
    position = look_at.eye;
    yaw = looking.angles.yaw_deg;
    pitch = looking.angles.pitch_deg;
    roll = looking.angles.roll_deg;
    if (looking.fault != LookAtFault::center_is_eye) target = look_at.center;
    return looking.fault;
}

void ProjectionParams::set_type(bool orthographic, bool window) {
    if (window)
        type = orthographic ? ProjectionType::orthographic_window : ProjectionType::frustum;
    else
        type = orthographic ? ProjectionType::orthographic : ProjectionType::perspective;
}

void ProjectionParams::set_window(const Edges& edges) {
    left = edges.left;
    right = edges.right;
    bottom = edges.bottom;
    top = edges.top;
}

void ProjectionParams::move_near(double moved) {
    if (type == ProjectionType::frustum && near > 0.0) set_window(window().scaled(moved / near));
    near = moved;
}

void ProjectionParams::scale_picture(double factor) {
    if (has_window())
        set_window(window().scaled(factor));
    else
        height *= factor;
}

ProjectionParams ProjectionParams::centered() const {
    ProjectionParams made = *this;
    if (!has_window()) return made;
    made.set_type(is_orthographic(), false);
    made.height = top - bottom;
    made.fovy = glm::degrees(2.0 * std::atan(0.5 * (top - bottom) / near));
    return made;
}

constexpr double least_fovy_deg = 1e-3;

std::optional<Lens> Params::lens_by_hand() const {
    if (!camera_overrides.clip_from_view) return std::nullopt;
    const bool reversed = depth.mapping == DepthMapping::reversed;
    const double low = reversed && depth.reversed_zero_to_one ? 0.0 : -1.0;
    std::optional<Lens> lens =
        lens_of(*camera_overrides.clip_from_view, reversed ? 1.0 : low, reversed ? low : 1.0, 1e-9);
    if (lens && !(lens->near < lens->far && (lens->near > 0.0 || lens->orthographic))) lens.reset();
    return lens;
}

Params Params::with_projection_by_hand() const {
    Params made = *this;
    const std::optional<Lens> lens = lens_by_hand();
    if (!lens) return made;
    made.camera_overrides.clip_from_view.reset();
    made.projection.set_type(lens->orthographic, true);
    made.projection.set_window(*lens->window);
    made.projection.near = lens->near;
    made.projection.far = lens->far;
    return made;
}

Lens Params::lens() const {
    double fovy_deg = projection.fovy;
    if (slips.degrees_as_radians) {
        const double turned_deg = std::remainder(glm::degrees(fovy_deg), 360.0);
        fovy_deg = std::copysign(std::clamp(std::abs(turned_deg), least_fovy_deg, 180.0 - least_fovy_deg), turned_deg);
    }
    Lens lens{projection.is_orthographic(), fovy_deg, projection.height, projection.near, projection.far};
    if (projection.has_window()) lens.window = projection.window();
    if (const std::optional<Lens> by_hand = lens_by_hand()) lens = *by_hand;
    if (lens.is_infinite()) lens.reach = 4.0 * std::max(lens.near, glm::distance(camera.position, camera.target));
    return lens;
}

double Params::mirror_picture_scale() const {
    if (projection.type != ProjectionType::perspective || reflection.fovy == 0.0) return 1.0;
    const auto slope = [](double fovy_deg) { return std::tan(glm::radians(0.5 * fovy_deg)); };
    return slope(lens().fovy_deg) / slope(reflection.fovy);
}

}  // namespace viewing
