#include "frame/animation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace viewing {

bool is_animated(const Params& params) {
    const AnimationParams& animation = params.animation;
    return animation.jiggle || (animation.light_orbit && animation.light_speed != 0.0);
}

Moment advanced(Moment moment, const Params& params, double dt_s) {
    moment.time_s += dt_s;
    if (params.animation.light_orbit)
        moment.light_turn_deg = std::fmod(moment.light_turn_deg + params.animation.light_speed * dt_s, 360.0);
    else
        moment.light_turn_deg = 0.0;
    return moment;
}

Params animated(const Params& params, const Moment& moment) {
    Params now = params;
    if (params.animation.jiggle) {
        // Two frequencies that rarely line up, so that the motion does not look like a pendulum's.
        const double tau = 2.0 * std::numbers::pi;
        const double away = 0.5 * (std::sin(0.61 * tau * moment.time_s) + std::sin(0.97 * tau * moment.time_s));
        const glm::dmat3 world_from_view(rotation_from_angles(params.camera.angles()));
        const double distance = std::max(glm::distance(params.camera.position, params.camera.target), 1.0);
        now.camera.position += world_from_view * glm::dvec3(away * 1e-3 * distance, 0.0, 0.4e-3 * away * distance);
    }
    if (params.animation.light_orbit) {
        const double angle = glm::radians(moment.light_turn_deg);
        const double c = std::cos(angle), s = std::sin(angle);
        glm::dvec4& light = now.lights[now.chosen().light].position;
        light = {c * light.x + s * light.z, light.y, c * light.z - s * light.x, light.w};
    }
    return now;
}

}  // namespace viewing
