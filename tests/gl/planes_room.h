// Random rooms of planes, lights and solids for the tests of shadows and mirrors. Each room has three forms:
// parameters, meshes, and the input of the oracle in ray_caster.h. Read planes_rays_test.cpp next.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "geometry/shapes.h"
#include "gl_test.h"
#include "ray_caster.h"
#include "unit/geometry/random.h"

namespace viewing::testing {

struct Room {
    OracleScene oracle;
    OracleCamera camera;
    Params params;
    Scene scene;
};

/// Returns the number of rooms that a test draws.
inline unsigned rooms(int usual) {
    return static_cast<unsigned>(trials(usual));
}

/// Makes one room; its number decides its contents and seeds their placement.
class RoomMaker {
public:
    explicit RoomMaker(unsigned number) : number_(number), random_(number) {}

    Room make() {
        add_solids();
        add_planes();
        place_camera();
        add_lights();
        set_params();
        return std::move(room_);
    }

private:
    bool chance(double probability) { return random_.number(0, 1) < probability; }
    template <typename Enum>
    Enum one_of(std::initializer_list<Enum> choices) {
        return *(choices.begin() + static_cast<std::ptrdiff_t>(random_.number(0, static_cast<double>(choices.size()))));
    }

    /// Adds a red, a green and a yellow solid; none of the colors contains blue.
    void add_solids() {
        const Color colors[] = {{255, 0, 0}, {0, 255, 0}, {255, 255, 0}};
        std::vector<SceneObject> objects;
        for (std::size_t i = 0; i < 3; ++i) {
            Solid solid;
            solid.is_sphere = chance(0.4);
            solid.position = random_.vec3(1.4);
            const Angles angles = random_.angles();
            solid.rotation = rotation_of(angles.yaw_deg, angles.pitch_deg, angles.roll_deg);
            const double size = random_.number(0.25, 0.7);
            solid.scale = solid.is_sphere ? glm::dvec3(size)
                                          : glm::dvec3(size, random_.number(0.25, 0.7), random_.number(0.25, 0.7));
            room_.oracle.solids.push_back(solid);
            // The mesh is so fine that its facets deviate from the sphere by well under a pixel.
            SceneObject placed =
                object(std::to_string(i), solid.is_sphere ? sphere_mesh(64, 32) : box_mesh(), solid.position);
            placed.world_from_model = world_from_model(solid.position, angles, solid.scale);
            placed.description.color = colors[i];
            objects.push_back(std::move(placed));
        }
        room_.scene = scene_of(std::move(objects));
    }

    /// Adds one to four planes, usually tilted, of a rotated room: a floor, a ceiling facing it, and two walls.
    void add_planes() {
        const glm::dvec3 inwards[] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
        const Angles turn = random_.angles();
        const glm::dmat3 turned = rotation_of(turn.yaw_deg, turn.pitch_deg, turn.roll_deg);
        const double tilt = number_ % 5 == 0 ? 0.0 : random_.number(0.0, 0.5);
        const bool in_a_row = chance(0.5);  // otherwise, the walls come first
        for (unsigned i = 0; i < 1 + number_ % 4; ++i) {
            const glm::dvec3 normal = turned * glm::normalize(inwards[in_a_row ? i : (i + 2) % 4] + random_.vec3(tilt));
            room_.oracle.planes.push_back({.equation = {normal, random_.number(0.8, 2.4)},
                                           .extent = random_.number(1.5, 4.0),
                                           .receives = chance(0.75),
                                           .mirrors = chance(0.75)});
        }
    }

    double unit_dot(const OraclePlane& plane, const glm::dvec4& point) const { return glm::dot(plane.equation, point); }

    bool is_inside(const glm::dvec4& point) const {
        return std::ranges::all_of(room_.oracle.planes,
                                   [&](const OraclePlane& plane) { return unit_dot(plane, point) > 0.0; });
    }
    bool is_near_plane(const glm::dvec4& point, double distance) const {
        return std::ranges::any_of(
            room_.oracle.planes, [&](const OraclePlane& plane) { return std::abs(unit_dot(plane, point)) < distance; });
    }
    bool is_near_solid(const glm::dvec3& point, double distance) const {
        return std::ranges::any_of(room_.oracle.solids, [&](const Solid& solid) {
            return glm::distance(point, solid.position) < glm::length(solid.scale) + distance;
        });
    }

    /// Usually places the camera inside the room, but sometimes anywhere around it.
    void place_camera() {
        OracleCamera& camera = room_.camera;
        camera.orthographic = number_ % 5 == 3;
        const bool wants_inside = chance(0.75);
        Angles angles;
        bool is_edge_on = false, is_well_placed = false;
        for (int trial = 0; !is_well_placed || is_edge_on; ++trial) {
            camera.position = random_.direction() * random_.number(3.0, 7.0);
            angles = angles_looking_at(camera.position, random_.vec3(1.0));
            const glm::dvec4 eye(camera.position, 1.0),
                backwards(rotation_of(angles.yaw_deg, angles.pitch_deg, angles.roll_deg)[2], 0.0);
            is_edge_on = camera.orthographic && is_near_plane(backwards, 0.1);
            is_well_placed = !is_near_plane(eye, 0.4) && !is_near_solid(camera.position, 0.5) &&
                             (is_inside(eye) || !wants_inside || trial > 300);
        }
        camera.yaw_deg = angles.yaw_deg;
        camera.pitch_deg = angles.pitch_deg;
        camera.roll_deg = random_.number(-180, 180);
        camera.fovy_deg = random_.number(35, 80);
        camera.height = random_.number(3, 7);
        if (number_ % 7 != 2) return;
        // An off-axis window, as in glFrustum or glOrtho, in every seventh room.
        const double half =
            camera.orthographic ? 0.5 * camera.height : camera.near * std::tan(glm::radians(0.5 * camera.fovy_deg));
        camera.window = half * glm::dvec4(-1.1, 2.2, -1.3, 0.6);
    }

    /// Adds point lights (w = 1), directions (w = 0) and lights with w = 0.5.
    void add_lights() {
        for (unsigned i = 0; i < 1 + number_ / 4 % 4; ++i) {
            glm::dvec4 light(0.0);
            const double w = one_of({1.0, 0.0, 0.5});
            const bool wants_inside = chance(0.8);
            for (int trial = 0; trial == 0 || is_near_plane(light, 0.3) ||
                                (w > 0.0 && is_near_solid(glm::dvec3(light) / light.w, 0.1)) ||
                                (wants_inside && trial < 300 && !is_inside(light));
                 ++trial)
                light = {random_.vec3(4.0), w == 0.5 ? random_.number(0.2, 0.9) : w};
            room_.oracle.lights.push_back(light);
        }
    }

    void set_params() {
        Params& params = room_.params;
        const OracleCamera& camera = room_.camera;
        params.camera.position = camera.position;
        params.camera.yaw = camera.yaw_deg;
        params.camera.pitch = camera.pitch_deg;
        params.camera.roll = camera.roll_deg;
        params.projection = {camera.orthographic ? ProjectionType::orthographic : ProjectionType::perspective,
                             camera.fovy_deg, camera.height, camera.near, camera.far};
        if (const auto& window = camera.window) {
            params.projection.set_type(camera.orthographic, true);
            params.projection.set_window({window->x, window->y, window->z, window->w});
        }
        if (!camera.orthographic && number_ % 3 == 1) params.projection.far = std::numeric_limits<double>::infinity();
        params.planes.resize(room_.oracle.planes.size());
        for (std::size_t i = 0; i < params.planes.size(); ++i) {
            const OraclePlane& plane = room_.oracle.planes[i];
            params.planes[i] = {plane.equation * (chance(0.5) ? -1.0 : 1.0) * random_.number(0.3, 3.0), plane.extent,
                                plane.receives, plane.mirrors, chance(0.3)};
        }
        params.lights.front().position = room_.oracle.lights.front();
        for (std::size_t i = 1; i < room_.oracle.lights.size(); ++i) params.lights.push_back({room_.oracle.lights[i]});
        set_techniques(params);
    }

    void set_techniques(Params& params) {
        params.shadow.enabled = room_.oracle.casts = !chance(0.1);
        params.shadow.opacity = 1.0;
        params.shadow.style = one_of({ShadowStyle::blend, ShadowStyle::missing_light});
        params.shadow.stencil_once = chance(0.7);
        params.shadow.offset = chance(0.3) ? ShadowOffset::no_depth_test : ShadowOffset::polygon_offset;
        params.reflection.enabled = !chance(0.1);
        params.reflection.reflectance = 1.0;
        params.reflection.bounces = 1 + static_cast<int>(number_ / 16 % 4);
        params.reflection.clip = one_of({MirrorClip::clip_distance, MirrorClip::oblique});
        params.reflection.mirrored = one_of({MirroredThing::scene, MirroredThing::camera});
        params.depth.mapping = one_of({DepthMapping::standard, DepthMapping::reversed});
        params.depth.format = one_of({DepthFormat::d24, DepthFormat::d32f});
        params.cull.enabled = chance(0.5);
        params.view.samples = 0;
    }

    unsigned number_;
    Random random_;
    Room room_;
};

inline Room room(unsigned number) {
    return RoomMaker(number).make();
}

}  // namespace viewing::testing
