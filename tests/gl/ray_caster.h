// An oracle that shares nothing with the code under test: what each pixel shows, found by rays alone. A pixel is an
// object, or patch in shadow ⇔ the segment from it to the light meets a caster, or a mirror that shows what the
// reflected ray meets. Spheres and boxes are met by formula; no mesh, no matrix of the program, no buffer is involved.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <vector>

namespace viewing::testing {

/// A sphere or a box of half-size 1, then scaled, turned and moved.
struct Solid {
    bool is_sphere = true;
    glm::dvec3 position{0.0};
    glm::dmat3 rotation{1.0};
    glm::dvec3 scale{1.0};  ///< a sphere's three are equal

    /// Where the line origin + t · direction meets the surface first with t in (from, to).
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

struct OracleScene {
    std::vector<Solid> solids;
    glm::dvec4 plane{0, 1, 0, 0};  ///< any length and sign
    double extent = 4.0;
    glm::dvec4 light{0, 1, 0, 0};
    bool casts = true, mirrors = false;
};

struct OracleCamera {
    glm::dvec3 position{0.0};
    double yaw_deg = 0, pitch_deg = 0, roll_deg = 0;
    bool orthographic = false;
    double fovy_deg = 40, height = 6, near = 0.1, far = 100;
};

/// What a pixel shows: 0, 1, 2 … a solid; or one of these.
constexpr int shows_background = -1, shows_patch = -2, shows_shadow = -3;

class RayCaster {
public:
    RayCaster(const OracleScene& scene, const OracleCamera& camera) : scene_(scene), camera_(camera) {
        const glm::dmat4 one(1.0);
        axes_ = glm::dmat3(glm::rotate(one, glm::radians(camera.yaw_deg), {0, 1, 0}) *
                           glm::rotate(one, glm::radians(camera.pitch_deg), {1, 0, 0}) *
                           glm::rotate(one, glm::radians(camera.roll_deg), {0, 0, 1}));
        const double length = glm::length(glm::dvec3(scene.plane));
        normal_ = glm::dvec3(scene.plane) / length;
        offset_ = scene.plane.w / length;
    }

    /// The pixel (x, y) of width × height from the top left, at its centre.
    int at(int x, int y, int width, int height) const {
        const double across = ((x + 0.5) / width * 2.0 - 1.0) * width / height;
        const double up = 1.0 - (y + 0.5) / height * 2.0;
        // Parameters of the ray are distances along the line of sight in both projections.
        glm::dvec3 origin = camera_.position, direction = -axes_[2];
        if (camera_.orthographic) {
            origin += (axes_[0] * across + axes_[1] * up) * camera_.height * 0.5;
        } else {
            direction += (axes_[0] * across + axes_[1] * up) * std::tan(glm::radians(camera_.fovy_deg) * 0.5);
        }
        return seen(origin, direction);
    }

private:
    double side(const glm::dvec3& point) const { return glm::dot(normal_, point) + offset_; }

    /// The solid met first, and where; −1 for none.
    int nearest(const glm::dvec3& origin, const glm::dvec3& direction, double from, double& to) const {
        int found = shows_background;
        for (std::size_t i = 0; i < scene_.solids.size(); ++i) {
            if (const auto t = scene_.solids[i].first_hit(origin, direction, from, to)) {
                to = *t;
                found = static_cast<int>(i);
            }
        }
        return found;
    }

    bool is_on_patch(const glm::dvec3& point) const {
        // The contract's axes: n′ with its largest component positive, e the axis of the smallest (the last on a tie).
        const glm::dvec3 size = glm::abs(normal_);
        const int largest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const int smallest = size.z <= size.x && size.z <= size.y ? 2 : size.y <= size.x ? 1 : 0;
        const glm::dvec3 n = normal_[largest] < 0.0 ? -normal_ : normal_;
        glm::dvec3 e(0.0);
        e[smallest] = 1.0;
        const glm::dvec3 u = glm::normalize(glm::cross(n, e)), v = glm::cross(u, n);
        const glm::dvec3 from_center = point + normal_ * offset_;
        return std::abs(glm::dot(from_center, u)) <= scene_.extent &&
               std::abs(glm::dot(from_center, v)) <= scene_.extent;
    }

    bool is_in_shadow(const glm::dvec3& point) const {
        const glm::dvec3 to_light = glm::dvec3(scene_.light) - scene_.light.w * point;
        const double reach = scene_.light.w == 0.0 ? 1e9 : 1.0 / scene_.light.w;
        double to = reach;
        return nearest(point, to_light, 0.0, to) >= 0;
    }

    int seen(const glm::dvec3& origin, const glm::dvec3& direction) const {
        double t_object = camera_.far;
        const int object = nearest(origin, direction, camera_.near, t_object);
        const double approach = glm::dot(normal_, direction);
        const double t_plane = approach != 0.0 ? -side(origin) / approach : -1.0;
        const glm::dvec3 on_plane = origin + t_plane * direction;
        if (t_plane <= camera_.near || t_plane >= t_object || !is_on_patch(on_plane)) return object;

        // The side that is seen is the one the line of sight comes from.
        const double seen_side = approach < 0.0 ? 1.0 : -1.0;
        const double light_side = glm::dot(normal_, glm::dvec3(scene_.light)) + offset_ * scene_.light.w;
        if (scene_.casts && light_side * seen_side > 0.0 && is_in_shadow(on_plane)) return shows_shadow;
        if (!scene_.mirrors) return shows_patch;
        double t_mirrored = camera_.far - t_plane;
        return nearest(on_plane, direction - 2.0 * approach * normal_, 0.0, t_mirrored);
    }

    OracleScene scene_;
    OracleCamera camera_;
    glm::dmat3 axes_{1.0};
    glm::dvec3 normal_{0.0};
    double offset_ = 0.0;
};

}  // namespace viewing::testing
