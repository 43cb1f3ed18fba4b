// An oracle that shares nothing with the code under test: it finds the content of each pixel by rays alone. A pixel
// shows an object, a patch without the lights whose shadow rays hit a caster, or a mirror that shows what the reflected
// ray hits, and so on from mirror to mirror. Formulas intersect spheres and boxes, without meshes, buffers, or the
// program's matrices. Read ray_caster_test.cpp next, then planes_rays_test.cpp.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <vector>

namespace viewing::testing {

/// Rotates about y, then about the rotated x, then about the rotated z.
inline glm::dmat3 rotation_of(double yaw_deg, double pitch_deg, double roll_deg) {
    const glm::dmat4 one(1.0);
    return glm::dmat3(glm::rotate(one, glm::radians(yaw_deg), {0, 1, 0}) *
                      glm::rotate(one, glm::radians(pitch_deg), {1, 0, 0}) *
                      glm::rotate(one, glm::radians(roll_deg), {0, 0, 1}));
}

/// A sphere or a box of half-size 1 that is then scaled, rotated and translated.
struct Solid {
    bool is_sphere = true;
    glm::dvec3 position{0.0};
    glm::dmat3 rotation{1.0};
    glm::dvec3 scale{1.0};  ///< all equal for a sphere

    /// Returns the smallest t in (from, to) at which the line origin + t · direction hits the surface; empty if none.
    std::optional<double> first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double from,
                                    double to) const {
        const glm::dvec3 o = glm::transpose(rotation) * (origin - position) / scale;
        const glm::dvec3 d = glm::transpose(rotation) * direction / scale;
        double enter = -1e300, leave = 1e300;
        if (is_sphere) {
            const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1.0, root = b * b - a * c;
            if (root < 0.0) return std::nullopt;
            enter = (-b - std::sqrt(root)) / a;
            leave = (-b + std::sqrt(root)) / a;
        } else {
            for (int axis = 0; axis < 3; ++axis) {
                if (d[axis] == 0.0) {
                    if (std::abs(o[axis]) > 1.0) return std::nullopt;
                    continue;
                }
                const double one = (-1.0 - o[axis]) / d[axis], other = (1.0 - o[axis]) / d[axis];
                enter = std::max(enter, std::min(one, other));
                leave = std::min(leave, std::max(one, other));
            }
            if (enter > leave) return std::nullopt;
        }
        for (const double t : {enter, leave})
            if (t > from && t < to) return t;
        return std::nullopt;
    }
};

struct OraclePlane {
    glm::dvec4 equation{0, 1, 0, 0};  ///< with a unit normal, of either sign
    double extent = 4.0;
    bool receives = true, mirrors = false;
};

struct OracleScene {
    std::vector<Solid> solids;
    std::vector<OraclePlane> planes;
    std::vector<glm::dvec4> lights;  ///< w is from 0 (a direction) to 1
    bool casts = true;
    int bounces = 1;  ///< after this many mirrors, the next one acts as a plain patch
};

struct OracleCamera {
    glm::dvec3 position{0.0};
    double yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
    bool orthographic = false;
    double fovy_deg = 40, height = 6, near = 0.1, far = 100;
    std::optional<glm::dvec4> window;  ///< left, right, bottom, top at the near plane
};

/// The first hit of a view ray: a solid, or a patch with some lights missing.
struct Met {
    int solid = -1, patch = -1;
    unsigned missing = 0;  ///< bit i is set if a caster hides light i from the visible side
    bool operator==(const Met&) const = default;
};

/// All hits of a view ray in order: mirrors, and finally the surface visible in the last mirror. If all hits are
/// mirrors, the last one shows the background; if there are no hits, the pixel does.
struct Sight {
    std::vector<Met> met;
    std::size_t mirrors = 0;  ///< number of mirrors at the start of `met`
    bool operator==(const Sight&) const = default;

    bool ends_in_background() const { return met.size() == mirrors; }
};

class RayCaster {
public:
    RayCaster(const OracleScene& scene, const OracleCamera& camera) : scene_(scene), camera_(camera) {
        axes_ = rotation_of(camera.yaw_deg, camera.pitch_deg, camera.roll_deg);
        for (OraclePlane& plane : scene_.planes) plane.equation /= glm::length(glm::dvec3(plane.equation));
    }

    /// Traces the point (x, y), measured from the top left of a picture of width × height pixels; pixel centers are at
    /// ½.
    Sight at(double x, double y, int width, int height) const {
        const Ray ray = line_of_sight(x, y, width, height);
        return seen(ray.origin, ray.direction);
    }

    /// Returns the patch that would be visible if there were no solids, and which lights are missing at that point.
    Met patch_at(double x, double y, int width, int height) const {
        const Ray ray = line_of_sight(x, y, width, height);
        double t = camera_.far;
        return nearest_patch(ray.origin, ray.direction, camera_.near, t, -1);
    }

private:
    struct Ray {
        glm::dvec3 origin, direction;
    };

    /// Returns the view ray. Ray parameters are distances along the view direction in both projections.
    Ray line_of_sight(double x, double y, int width, int height) const {
        const double across = (x / width * 2.0 - 1.0) * width / height;
        const double up = 1.0 - y / height * 2.0;
        if (const auto& window = camera_.window) {
            const double u = x / width, v = 1.0 - y / height;
            const glm::dvec3 edge =
                axes_[0] * ((1.0 - u) * window->x + u * window->y) + axes_[1] * ((1.0 - v) * window->z + v * window->w);
            if (camera_.orthographic) return {camera_.position + edge, -axes_[2]};
            return {camera_.position, -axes_[2] + edge / camera_.near};
        }
        const glm::dvec3 aside = axes_[0] * across + axes_[1] * up;
        if (camera_.orthographic) return {camera_.position + aside * camera_.height * 0.5, -axes_[2]};
        return {camera_.position, -axes_[2] + aside * std::tan(glm::radians(camera_.fovy_deg) * 0.5)};
    }

    /// Returns the solid that the ray hits first and sets `to` to that hit's parameter; returns −1 if it hits none.
    int nearest_solid(const glm::dvec3& origin, const glm::dvec3& direction, double from, double& to) const {
        int found = -1;
        for (std::size_t i = 0; i < scene_.solids.size(); ++i) {
            if (const auto t = scene_.solids[i].first_hit(origin, direction, from, to)) {
                to = *t;
                found = static_cast<int>(i);
            }
        }
        return found;
    }

    static bool is_on_patch(const OraclePlane& plane, const glm::dvec3& point) {
        // The patch's axes: n′ is the normal with its largest component positive, and e is the axis of the smallest
        // component (of several equally small ones, the last).
        const glm::dvec3 normal(plane.equation), size = glm::abs(normal);
        const int largest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const int smallest = size.z <= size.x && size.z <= size.y ? 2 : size.y <= size.x ? 1 : 0;
        const glm::dvec3 n = normal[largest] < 0.0 ? -normal : normal;
        glm::dvec3 e(0.0);
        e[smallest] = 1.0;
        const glm::dvec3 u = glm::normalize(glm::cross(n, e)), v = glm::cross(u, n);
        const glm::dvec3 from_center = point + normal * plane.equation.w;
        return std::abs(glm::dot(from_center, u)) <= plane.extent && std::abs(glm::dot(from_center, v)) <= plane.extent;
    }

    bool is_in_shadow(const glm::dvec3& point, const glm::dvec4& light) const {
        const glm::dvec3 to_light = glm::dvec3(light) - light.w * point;
        double to = light.w == 0.0 ? 1e9 : 1.0 / light.w;
        return nearest_solid(point, to_light, 0.0, to) >= 0;
    }

    /// Returns the set of lights that casters block at a point of a patch, on the side that the view ray hits.
    unsigned missing_at(const OraclePlane& plane, const glm::dvec3& point, const glm::dvec3& direction) const {
        if (!scene_.casts || !plane.receives) return 0;
        const double seen_side = glm::dot(glm::dvec3(plane.equation), direction) < 0.0 ? 1.0 : -1.0;
        unsigned missing = 0;
        for (std::size_t i = 0; i < scene_.lights.size(); ++i)
            if (glm::dot(plane.equation, scene_.lights[i]) * seen_side > 0.0 && is_in_shadow(point, scene_.lights[i]))
                missing |= 1U << i;
        return missing;
    }

    /// Returns the patch that the ray hits first and sets `to` to that hit's parameter. Ignores the patch `start`, on
    /// which the ray begins.
    Met nearest_patch(const glm::dvec3& origin, const glm::dvec3& direction, double from, double& to, int start) const {
        Met found;
        for (std::size_t i = 0; i < scene_.planes.size(); ++i) {
            const glm::dvec4& plane = scene_.planes[i].equation;
            const double approach = glm::dot(glm::dvec3(plane), direction);
            if (static_cast<int>(i) == start || approach == 0.0) continue;
            const double t = -glm::dot(plane, glm::dvec4(origin, 1.0)) / approach;
            if (t <= from || t >= to || !is_on_patch(scene_.planes[i], origin + t * direction)) continue;
            to = t;
            found.patch = static_cast<int>(i);
        }
        if (found.patch >= 0)
            found.missing =
                missing_at(scene_.planes[static_cast<std::size_t>(found.patch)], origin + to * direction, direction);
        return found;
    }

    Sight seen(glm::dvec3 origin, glm::dvec3 direction) const {
        Sight sight;
        double from = camera_.near, left = camera_.far;
        for (int start = -1;;) {
            double t = left;
            Met met{.solid = nearest_solid(origin, direction, from, t)};
            double t_patch = t;
            if (const Met patch = nearest_patch(origin, direction, from, t_patch, start); patch.patch >= 0) {
                met = patch;
                t = t_patch;
            }
            if (met == Met{}) return sight;
            sight.met.push_back(met);
            if (met.patch < 0 || static_cast<int>(sight.mirrors) >= scene_.bounces) return sight;
            const OraclePlane& plane = scene_.planes[static_cast<std::size_t>(met.patch)];
            if (!plane.mirrors) return sight;
            ++sight.mirrors;
            const glm::dvec3 normal(plane.equation);
            origin += t * direction;
            direction -= 2.0 * glm::dot(normal, direction) * normal;
            from = 0.0;
            left -= t;
            start = met.patch;
        }
    }

    OracleScene scene_;
    OracleCamera camera_;
    glm::dmat3 axes_{1.0};
};

}  // namespace viewing::testing
