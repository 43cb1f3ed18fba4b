#include "state/mesh/coplanar.h"

#include <cmath>
#include <string>

#include "text/numbers.h"
#include "text/words.h"

namespace viewing {

namespace {

const glm::dvec3 viewpoint{0.0, 1.5, 4.0};
constexpr double half_side = 0.068;                    // half a quad's side, as a fraction of its eye distance
const glm::dvec3 front_shift_model{0.45, 0.0, -0.35};  // in half sides; keeps the back quad partly visible
constexpr double turned_deg = 6.0;                     // rotation away from the viewpoint, about the vertical axis
constexpr Color back_color{0x5a, 0x9e, 0xf0}, front_color{0xe0, 0x81, 0x2f};

/// The direction of a pair's back quad from the viewpoint, and the quad's distance if the nearest pair is at a distance
/// of 4.
struct Place {
    double eye_distance, right_deg, up_deg;
};
constexpr Place places[] = {{4, -24, -8}, {8, -15, -4.5}, {14, -5.5, -1.5}, {24, 4.5, 1}, {44, 14, 2.8}, {84, 23.5, 4}};

ObjectDescription quad(const std::string& name, const Color& color, const glm::dvec3& position, const Angles& rotation,
                       double scale) {
    ObjectDescription quad;
    quad.name = name;
    quad.shape = ShapeKind::quad;
    quad.position = position;
    quad.rotation = rotation;
    quad.scale = {scale, 1.0, scale};
    quad.color = color;
    return quad;
}

}  // namespace

SceneDescription coplanar_scene(const CoplanarParams& params) {
    SceneDescription scene;
    for (const Place& place : places) {
        const double distance = place.eye_distance * params.distance / places[0].eye_distance;
        const double scale = half_side * distance;
        const glm::dvec3 from_viewpoint{std::tan(glm::radians(place.right_deg)), std::tan(glm::radians(place.up_deg)),
                                        -1.0};
        const Angles rotation{turned_deg - place.right_deg, 90.0 + params.tilt, 0.0};
        const glm::dvec3 back = viewpoint + distance * from_viewpoint;
        const glm::dvec3 front = back + glm::dmat3(rotation_from_angles(rotation)) *
                                            (scale * front_shift_model + glm::dvec3(0.0, params.gap, 0.0));
        const std::string at = " at " + format_number(std::round(distance * 1e3) / 1e3);
        scene.objects.push_back(quad("back quad" + at, back_color, back, rotation, scale));
        scene.objects.push_back(quad("front quad" + at, front_color, front, rotation, scale));
        scene.objects.back().decal = true;  // lets the decal method keep the pair from fighting
    }
    return scene;
}

}  // namespace viewing
