#include "ui/parts/handles.h"

#include <cmath>
#include <string>

#include "state/fields.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

constexpr double parallel_light_distance = 5.0;  ///< where a parallel light's lamp hangs, from the patch's centre

/// Its lamp would hang too far away to be seen: it is shown by its direction.
bool is_far_away(const glm::dvec4& light) {
    const double length = glm::length(glm::dvec3(light));
    return length > 0.0 && length >= 1e3 * light.w;
}

/// "ℓ", "ℓ₂", …
const char* light_name(std::size_t light) {
    static constexpr const char* names[most_lights] = {"ℓ", "ℓ₂", "ℓ₃", "ℓ₄"};
    return names[light];
}

/// Of the light that has the handle: "ℓ₂ (parallel)".
std::string light_label(const Derived& derived) {
    const glm::dvec4& light = derived.chosen_light();
    const char* const name = light_name(derived.chosen.light);
    if (is_parallel_light(light)) return say("{light} (parallel)", "light"_a = name);
    return is_far_away(light) ? say("{light} (far away)", "light"_a = name) : name;
}

/// A light with its name; a parallel one with its direction.
void draw_lamp(Overlay& overlay, const glm::dvec4& light, const Derived& derived, const char* name, float radius) {
    const ImU32 color = widgets::CurrentContext().palette.light;
    const glm::dvec3 place = lamp_place(light, derived);
    if (is_far_away(light)) overlay.arrow(place, place + 0.25 * (derived.chosen_plane().patch.center - place), color);
    overlay.dot(place, color, radius);
    overlay.label(place, name, color);
}

/// Where a ray meets the plane through `point` that faces the eye.
glm::dvec3 in_picture_plane(const Ray& ray, const glm::dvec3& point, const glm::dvec3& facing) {
    const std::optional<double> t = intersect_plane(ray, glm::dvec4(facing, -glm::dot(facing, point)));
    return t ? ray.at(*t) : point;
}

}  // namespace

glm::dvec3 lamp_place(const glm::dvec4& light_world, const Derived& derived) {
    return is_far_away(light_world)
               ? derived.chosen_plane().patch.center + glm::normalize(glm::dvec3(light_world)) * parallel_light_distance
               : glm::dvec3(light_world) / light_world.w;
}

HandlePlaces handle_places(const Derived& derived) {
    HandlePlaces places{};
    const DerivedPlane& plane = derived.chosen_plane();
    places.plane = plane.patch.center;
    places.normal_tip = plane.patch.center + glm::dvec3(plane.unit_plane) * 1.4;
    places.light = lamp_place(derived.chosen_light(), derived);
    return places;
}

Handle handle_at(const Overlay& overlay, const HandlePlaces& places, ImVec2 place) {
    const float reach = 14.0F * widgets::CurrentContext().scale;
    float nearest = reach;
    Handle found = Handle::none;
    const auto look = [&](const glm::dvec3& point, Handle handle) {
        const std::optional<ImVec2> there = overlay.project(point);
        if (!there) return;
        const float distance = std::hypot(there->x - place.x, there->y - place.y);
        if (distance >= nearest) return;
        nearest = distance;
        found = handle;
    };
    look(places.light, Handle::light);
    look(places.normal_tip, Handle::plane_tilt);
    look(places.plane, Handle::plane_offset);
    return found;
}

Grip take(const Overlay& overlay, const HandlePlaces& places, Handle handle, const Params& params, ImVec2 place) {
    Grip grip;
    grip.handle = handle;
    grip.grabbed_world = handle == Handle::light        ? places.light
                         : handle == Handle::plane_tilt ? places.normal_tip
                                                        : places.plane;
    grip.center_world = places.plane;
    grip.equation = params.planes[params.chosen().plane].equation;
    const Ray ray = overlay.ray_at(place);
    grip.offset_world = grip.grabbed_world - in_picture_plane(ray, grip.grabbed_world, ray.direction);
    return grip;
}

void drag(Params& params, const Overlay& overlay, const Grip& grip, ImVec2 place, bool along_y) {
    const Ray ray = overlay.ray_at(place);
    const glm::dvec3 point = in_picture_plane(ray, grip.grabbed_world, ray.direction) + grip.offset_world;
    const double length = glm::length(glm::dvec3(grip.equation));
    const glm::dvec3 normal = glm::dvec3(grip.equation) / length;
    const Choice chosen = params.chosen();
    glm::dvec4& equation = params.planes[chosen.plane].equation;
    switch (grip.handle) {
        case Handle::none:
            return;
        case Handle::light: {
            glm::dvec4& light = params.lights[chosen.light].position;
            params.animation.light_orbit = false;  // it stays where it is put
            glm::dvec3 target = point;
            if (along_y) target = {grip.grabbed_world.x, point.y, grip.grabbed_world.z};
            if (!is_far_away(light)) {
                light = glm::dvec4(target * light.w, light.w);
            } else if (glm::length(target - grip.center_world) > 1e-3) {
                const double size = glm::length(glm::dvec3(light));
                light = glm::dvec4(glm::normalize(target - grip.center_world) * size, light.w);
            }
            break;
        }
        case Handle::plane_offset: {
            // Measured from where the pointer took hold, so that nothing jumps.
            const glm::dvec3 pressed = grip.grabbed_world - grip.offset_world;
            const auto along = closest_point_parameter_on_line(ray, grip.center_world, normal);
            const auto at_grab =
                closest_point_parameter_on_line({ray.origin, pressed - ray.origin}, grip.center_world, normal);
            if (!along || !at_grab) return;  // looking straight along the normal: no way to tell how far
            const glm::dvec3 center = grip.center_world + normal * (*along - *at_grab);
            equation.w = -glm::dot(glm::dvec3(grip.equation), center);
            break;
        }
        case Handle::plane_tilt: {
            if (glm::length(point - grip.center_world) < 1e-3) return;
            const glm::dvec3 tilted = glm::normalize(point - grip.center_world) * length;
            equation = glm::dvec4(tilted, -glm::dot(tilted, grip.center_world));
            break;
        }
    }
    clamp_to_ranges(params);
}

void draw_handles(Overlay& overlay, const HandlePlaces& places, const Derived& derived, Handle hovered) {
    const widgets::Palette& palette = widgets::CurrentContext().palette;
    const auto radius = [hovered](Handle handle, float usual) { return hovered == handle ? usual + 2.0F : usual; };

    overlay.arrow(places.plane, places.normal_tip, palette.plane);
    overlay.square(places.plane, palette.plane, radius(Handle::plane_offset, 4.0F));
    overlay.label(places.normal_tip, "n", palette.plane);
    if (hovered == Handle::plane_tilt) overlay.ring(places.normal_tip, palette.plane, 9.0F);

    draw_lamp(overlay, derived.chosen_light(), derived, light_label(derived).c_str(), radius(Handle::light, 6.0F));
    overlay.ring(places.light, palette.light, radius(Handle::light, 10.0F));
    for (std::size_t light = 0; light < derived.lights_world.size(); ++light)
        if (light != derived.chosen.light)
            draw_lamp(overlay, derived.lights_world[light], derived, light_name(light), 5.0F);
}

}  // namespace viewing
