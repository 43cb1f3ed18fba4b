#include "frame/planes/object_reach.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

/// The smallest value of a linear form in the scene's bounds, so that there is no need to look at a million vertices.
double smallest_in_bounds(const Bounds& bounds, const glm::dvec4& form) {
    double smallest = form.w;
    for (int axis = 0; axis < 3; ++axis)
        smallest += std::min(form[axis] * bounds.min[axis], form[axis] * bounds.max[axis]);
    return smallest;
}

template <typename Predicate>
bool any_vertex(const SceneObject& object, Predicate is_so) {
    return std::any_of(object.mesh->positions.begin(), object.mesh->positions.end(), [&](const glm::vec3& vertex) {
        return is_so(object.world_from_model * glm::dvec4(vertex, 1.0));
    });
}

template <typename Predicate>
std::string names_of(const Scene& scene, Predicate is_so) {
    std::string names;
    for (const SceneObject& object : scene.objects)
        if (is_so(object)) names += (names.empty() ? "" : ", ") + object.description.name;
    return names;
}

bool is_clear_of(const Scene& scene, const glm::dvec4& form, double limit) {
    return !scene.bounds_world.empty() && smallest_in_bounds(scene.bounds_world, form) > limit;
}

bool is_inside(const PlanePatch& patch, const glm::dvec3& point) {
    const glm::dvec3 offset = point - patch.center;
    const double reach = patch.extent * (1.0 + 1e-9);
    return std::abs(glm::dot(offset, patch.u)) <= reach && std::abs(glm::dot(offset, patch.v)) <= reach;
}

bool lands(const Scene& scene, const glm::dmat4& plane_from_world, const glm::dvec4& side, const PlanePatch& patch,
           bool inside) {
    const auto is_there = [&](const glm::dvec4& point) {
        const glm::dvec4 sent = plane_from_world * point;
        return sent.w > 0.0 && glm::dot(side, point) >= -standing &&
               is_inside(patch, glm::dvec3(sent) / sent.w) == inside;
    };
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](const SceneObject& object) { return any_vertex(object, is_there); });
}

}  // namespace

std::string objects_at_most(const Scene& scene, const glm::dvec4& form, double limit) {
    if (is_clear_of(scene, form, limit)) return "";
    return names_of(scene, [&](const SceneObject& object) {
        return any_vertex(object, [&](const glm::dvec4& point) { return glm::dot(form, point) <= limit; });
    });
}

std::string objects_across(const Scene& scene, const glm::dvec4& form, double limit) {
    if (is_clear_of(scene, form, limit)) return "";
    return names_of(scene, [&](const SceneObject& object) {
        return any_vertex(object, [&](const glm::dvec4& point) { return glm::dot(form, point) <= limit; }) &&
               any_vertex(object, [&](const glm::dvec4& point) { return glm::dot(form, point) > limit; });
    });
}

bool lands_beyond(const Scene& scene, const glm::dmat4& plane_from_world, const glm::dvec4& side,
                  const PlanePatch& patch) {
    return lands(scene, plane_from_world, side, patch, false);
}

bool lands_inside(const Scene& scene, const glm::dmat4& plane_from_world, const glm::dvec4& side,
                  const PlanePatch& patch) {
    return lands(scene, plane_from_world, side, patch, true);
}

}  // namespace viewing
