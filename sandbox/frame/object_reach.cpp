#include "frame/object_reach.h"

#include "text/catalogue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "frame/box_form.h"
#include "frame/box_tree.h"
#include "geometry/convex_part.h"
#include "geometry/ray.h"

namespace viewing {
namespace {

/// Returns the smallest value of a linear form over the scene's bounds. This can save visiting a million vertices.
double smallest_in_bounds(const Bounds& bounds, const glm::dvec4& form) {
    double smallest = form.w;
    for (int axis = 0; axis < 3; ++axis)
        smallest += std::min(form[axis] * bounds.min[axis], form[axis] * bounds.max[axis]);
    return smallest;
}

/// Returns whether is_so(vertex) holds for any vertex of an object, in world space. Visits only the boxes of the mesh
/// that pass `may_hold`.
template <typename MayHold, typename Predicate>
bool any_vertex(const SceneObject& object, MayHold may_hold, Predicate is_so) {
    return vertex_tree(object.mesh)->any(may_hold, [&](std::uint32_t vertex) {
        return is_so(object.world_from_model * glm::dvec4(object.mesh->positions[vertex], 1.0));
    });
}

bool is_at_most(const SceneObject& object, const glm::dvec4& form, double limit) {
    const BoxForm in_box(form, object.world_from_model);
    return any_vertex(
        object, [&](const Bounds& box) { return !(in_box.least(box) > limit); },
        [&](const glm::dvec4& point) { return glm::dot(form, point) <= limit; });
}

bool is_above(const SceneObject& object, const glm::dvec4& form, double limit) {
    const BoxForm in_box(form, object.world_from_model);
    return any_vertex(
        object, [&](const Bounds& box) { return !(in_box.greatest(box) <= limit); },
        [&](const glm::dvec4& point) { return glm::dot(form, point) > limit; });
}

bool reaches_each(const SceneObject& object, std::span<const glm::dvec4> forms) {
    return std::all_of(forms.begin(), forms.end(), [&](const glm::dvec4& form) { return is_above(object, form, 0.0); });
}

/// Returns whether is_so(points) holds for any vertex at which all forms are positive, or for the corners of that part
/// of any triangle where all forms are positive. Points are in the model's space. Handles at most 32 forms. For a mesh
/// of more than 20,000 triangles, returns true unless one of the forms is positive at none of its vertices.
/// `takes_points`: false asks about parts of triangles only.
template <typename Predicate>
bool any_part(const SceneObject& object, std::span<const glm::dvec4> forms, Predicate is_so, bool takes_points = true) {
    constexpr std::size_t most_triangles = 20'000;
    const Mesh& mesh = *object.mesh;
    if (!reaches_each(object, forms)) return false;
    if (mesh.triangle_count() > most_triangles) return true;
    std::vector<glm::dvec4> of_model;
    for (const glm::dvec4& form : forms) of_model.push_back(form * object.world_from_model);
    const auto point = [&mesh](std::uint32_t vertex) { return glm::dvec4(mesh.positions[vertex], 1.0); };
    const auto all = static_cast<std::uint32_t>((std::uint64_t{1} << of_model.size()) - 1U);
    constexpr std::uint32_t unknown = ~0U;
    std::vector<std::uint32_t> known(mesh.positions.size(), unknown);
    const auto positive = [&](std::uint32_t vertex) {  // one bit per form
        if (known[vertex] == unknown) {
            known[vertex] = 0;
            for (std::size_t form = 0; form < of_model.size(); ++form)
                if (glm::dot(of_model[form], point(vertex)) > 0.0) known[vertex] |= 1U << form;
        }
        return known[vertex];
    };
    std::vector<glm::dvec4> part, kept;
    for (std::uint32_t vertex = 0; takes_points && vertex < known.size(); ++vertex) {
        part = {point(vertex)};
        if (positive(vertex) == all && is_so(part)) return true;
    }
    // Neighboring triangles mostly get the same answer, so the order leaps over the mesh: 0.618 is the golden section.
    const std::size_t count = mesh.triangle_count();
    std::size_t leap = static_cast<std::size_t>(0.618 * static_cast<double>(count)) | 1U;
    while (std::gcd(leap, count) > 1) leap += 2;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t* const corners = &mesh.indices[3 * (i * leap % count)];
        const std::uint32_t a = corners[0], b = corners[1], c = corners[2];
        if ((positive(a) | positive(b) | positive(c)) != all) continue;
        const std::uint32_t everywhere = positive(a) & positive(b) & positive(c);
        part = {point(a), point(b), point(c)};
        for (std::size_t form = 0; form < of_model.size() && !part.empty(); ++form)
            if ((everywhere >> form & 1U) == 0)
                keep_part(part, kept, [&](const glm::dvec4& at) { return glm::dot(of_model[form], at); });
        if (part.size() >= 3 && is_so(part)) return true;
    }
    return false;
}

template <typename Predicate>
Message names_of(const Scene& scene, Predicate is_so) {
    std::vector<Message> names;
    for (const SceneObject& object : scene.objects)
        if (is_so(object)) names.push_back(object_message(object.description.name));
    return enumerated(names);
}

bool is_clear_of(const Scene& scene, const glm::dvec4& form, double limit) {
    return !scene.bounds_world.empty() && smallest_in_bounds(scene.bounds_world, form) > limit;
}

/// Returns whether at least one of the forms is negative everywhere within the scene's bounds.
bool is_clear_of_any(const Scene& scene, std::span<const glm::dvec4> forms) {
    return std::any_of(forms.begin(), forms.end(),
                       [&](const glm::dvec4& form) { return is_clear_of(scene, -form, 0.0); });
}

/// Returns forms_of_edges() as forms over boxes in a model's space.
std::vector<BoxForm> ways_to_edges(const glm::dmat4& plane_from_world, const PlanePatch& patch,
                                   const glm::dmat4& world_from_model) {
    const glm::dmat4 rows = glm::transpose(plane_from_world);
    const std::array<glm::dvec4, 4> forms = forms_of_edges(plane_from_world, patch);
    std::vector<BoxForm> ways;
    for (std::size_t edge = 0; edge < forms.size(); ++edge) {
        const glm::dvec3 axis = glm::abs(edge < 2 ? patch.u : patch.v);
        const glm::dvec4 along = axis.x * glm::abs(rows[0]) + axis.y * glm::abs(rows[1]) + axis.z * glm::abs(rows[2]);
        const glm::dvec4 summed = along + (glm::dot(axis, glm::abs(patch.center)) + patch.reach()) * glm::abs(rows[3]);
        ways.emplace_back(forms[edge], world_from_model, 2.0 * summed);
    }
    return ways;
}

bool is_in_frustum(const glm::dvec4& clip) {
    return clip.w > 0.0 && glm::all(glm::lessThanEqual(glm::abs(glm::dvec3(clip)), glm::dvec3(clip.w)));
}

/// Does the same as is_in_frustum(), but ignores near and far.
bool is_in_picture(const glm::dvec4& clip) {
    return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

/// Returns whether a point of the plane is in the patch and, for an image, is not cut off by near. Far needs no test:
/// if it cuts off the point, it also cuts off the image, which is farther.
bool holds(const Landing& landing, const glm::dvec4& sent) {
    if (!(sent.w > 0.0) || !landing.patch.holds(glm::dvec3(sent) / sent.w)) return false;
    if (!landing.is_image) return true;
    const glm::dvec4 clip = landing.clip_from_world * (sent / sent.w);
    return !(clip.w > 0.0) || clip.z >= -clip.w;
}

/// Returns whether any vertex of an object lands inside the patch or, if `inside` is false, whether any lands outside:
/// beside the patch, on a part of it that near cuts off, or nowhere (w ≤ 0). With `in_picture`, the vertex must also
/// land in the picture.
bool lands(const SceneObject& object, const Landing& landing, bool inside, bool in_picture) {
    const auto is_there = [&](const glm::dvec4& point) {
        if (glm::dot(landing.side, point) < -standing) return false;
        const glm::dvec4 sent = landing.plane_from_world * point;
        if (holds(landing, sent) != inside) return false;
        if (!in_picture) return true;
        if (!(sent.w > 0.0)) return false;
        const glm::dvec4 clip = landing.clip_from_world * (sent / sent.w);
        return (landing.is_image ? is_in_picture(clip) : is_in_frustum(clip)) && !landing.hides(sent);
    };
    const BoxForm w(glm::transpose(landing.plane_from_world)[3], object.world_from_model);
    const BoxForm before(landing.side, object.world_from_model);
    const std::vector<BoxForm> ways = ways_to_edges(landing.plane_from_world, landing.patch, object.world_from_model);
    const std::array<glm::dvec3, 4> corners = landing.patch.corners();
    const bool is_cut = !std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
        return holds(landing, glm::dvec4(glm::mix(landing.patch.center, corner, 0.999), 1.0));
    });
    const auto may_hold = [&](const Bounds& box) {
        if (before.greatest(box) < -standing) return false;
        if ((inside || in_picture) && w.greatest(box) <= 0.0) return false;
        if (inside)
            return std::none_of(ways.begin(), ways.end(), [&](const BoxForm& way) { return way.greatest(box) < 0.0; });
        return is_cut || w.least(box) <= 0.0 ||
               !std::all_of(ways.begin(), ways.end(), [&](const BoxForm& way) { return way.least(box) >= 0.0; });
    };
    return any_vertex(object, may_hold, is_there);
}

/// Returns the area of a polygon in normalized device coordinates.
double area_in_picture(const glm::dmat4& clip_from_world, const std::vector<glm::dvec3>& corners) {
    std::vector<glm::dvec2> at;
    for (const glm::dvec3& corner : corners) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(corner, 1.0);
        at.push_back(glm::dvec2(clip) / clip.w);
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const glm::dvec2 &here = at[i], &next = at[(i + 1) % at.size()];
        twice += here.x * next.y - next.x * here.y;
    }
    return 0.5 * std::abs(twice);
}

/// Finds what hides points of the scene. An object that its scale flattens hides nothing.
class Hiding {
public:
    explicit Hiding(const Scene& scene) {
        for (const SceneObject& object : scene.objects)
            if (glm::determinant(object.world_from_model) != 0.0)
                all_.push_back({object.mesh.get(), triangle_tree(object.mesh), glm::inverse(object.world_from_model)});
    }

    /// Returns whether an object is on the view ray to a point, between near and the point.
    bool hides(const glm::dvec3& point_world, const Params& params, const Derived& derived) const {
        constexpr double least = 1e-4;  // surfaces that touch the point do not hide it
        const glm::dvec3 way = -line_of_sight(derived.eye_world, point_world);
        const glm::dvec4 distance = -glm::transpose(derived.view_from_world)[2];
        const double limit = (glm::dot(distance, glm::dvec4(point_world, 1.0)) - params.projection.near) /
                             -glm::dot(distance, glm::dvec4(way, 0.0));
        return std::any_of(all_.begin(), all_.end(), [&](const Object& object) {
            const Ray ray{glm::dvec3(object.model_from_world * glm::dvec4(point_world, 1.0)),
                          glm::dmat3(object.model_from_world) * way};
            const Mesh& mesh = *object.mesh;
            return object.tree->any([&](const Bounds& box) { return meets_box(ray, box, limit); },
                                    [&](std::uint32_t triangle) {
                                        std::array<glm::dvec3, 3> corners;
                                        for (std::size_t k = 0; k < 3; ++k)
                                            corners[k] = mesh.positions[mesh.indices[3 * std::size_t{triangle} + k]];
                                        const std::optional<TriangleHit> hit = intersect_triangle(ray, corners);
                                        return hit && hit->t > least && hit->t < limit;
                                    });
        });
    }

private:
    struct Object {
        const Mesh* mesh;
        std::shared_ptr<const BoxTree> tree;
        glm::dmat4 model_from_world;
    };
    std::vector<Object> all_;
};

/// The size of a mesh in the picture. Lengths are fractions of the picture's height.
struct Drawn {
    double area = 0.0;    ///< of all its triangles, whether or not they hide each other
    double length = 0.0;  ///< the diagonal of its bounds

    double thickness() const { return length > 0.0 ? area / length : 0.0; }
};

/// Returns nothing if part of the mesh is behind the eye: the mesh is not small then.
std::optional<Drawn> drawn_size(const Mesh& mesh, const glm::dmat4& clip_from_model, double aspect) {
    Drawn drawn;
    std::vector<glm::dvec2> points;
    glm::dvec2 min(std::numeric_limits<double>::infinity()), max(-min);
    for (const glm::vec3& position : mesh.positions) {
        const glm::dvec4 clip = clip_from_model * glm::dvec4(position, 1.0);
        if (!(clip.w > 0.0)) return std::nullopt;
        points.push_back(0.5 * glm::dvec2(aspect * clip.x, clip.y) / clip.w);
        min = glm::min(min, points.back());
        max = glm::max(max, points.back());
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec2 at = points[mesh.indices[i]], u = points[mesh.indices[i + 1]] - at,
                         v = points[mesh.indices[i + 2]] - at;
        drawn.area += 0.5 * std::abs(u.x * v.y - u.y * v.x);
    }
    drawn.length = glm::length(max - min);
    return drawn;
}

}  // namespace

double picture_height(const Lens& lens, double distance) {
    return std::abs(lens.edges_at(distance, 1.0).height());
}

bool is_in_view(const SceneObject& object, const Params& params, const Derived& derived) {
    constexpr std::size_t tried = 64;
    const glm::dmat4 clip_from_model =
        clip_from_view(params.lens(), derived.aspect) * derived.view_from_world * object.world_from_model;
    const std::size_t count = object.mesh->positions.size(), step = std::max<std::size_t>(1, count / tried);
    for (std::size_t i = 0; i < count; i += step) {
        if (is_in_frustum(clip_from_model * glm::dvec4(object.mesh->positions[i], 1.0))) return true;
    }
    return false;
}

bool is_in_view(const PlanePatch& patch, const glm::dmat4& clip_from_world) {
    constexpr int most = 24;
    for (int row = -most; row <= most; ++row)
        for (int column = -most; column <= most; ++column) {
            const glm::dvec3 at =
                patch.center +
                patch.extent / most * (static_cast<double>(column) * patch.u + static_cast<double>(row) * patch.v);
            if (is_in_frustum(clip_from_world * glm::dvec4(at, 1.0))) return true;
        }
    return false;
}

Message objects_at_most(const Scene& scene, const glm::dvec4& form, double limit) {
    if (is_clear_of(scene, form, limit)) return {};
    return names_of(scene, [&](const SceneObject& object) { return is_at_most(object, form, limit); });
}

Message objects_across(const Scene& scene, const glm::dvec4& form, double limit) {
    if (is_clear_of(scene, form, limit)) return {};
    return names_of(scene, [&](const SceneObject& object) {
        return is_at_most(object, form, limit) && is_above(object, form, limit);
    });
}

bool lands_beyond(const Scene& scene, const Landing& landing) {
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
        if (lands(object, landing, false, true)) return true;
        // The vertices that land beyond the patch's edge may be outside the picture while a triangle crosses that edge
        // inside the picture.
        const glm::dmat4 clip = landing.clip_from_world * landing.plane_from_world;
        std::vector<glm::dvec4> forms = {glm::transpose(landing.plane_from_world)[3], landing.side};
        forms.back().w += standing;
        for (const glm::dvec4& side : forms_of_sides(clip)) forms.push_back(side);
        const std::array<glm::dvec4, 4> edges = forms_of_edges(landing.plane_from_world, landing.patch);
        std::vector<glm::dvec4> ends(edges.begin(), edges.end());
        const glm::dmat4 rows = glm::transpose(clip);
        if (landing.is_image)
            ends.push_back(rows[3] + rows[2]);
        else
            forms.insert(forms.end(), {rows[3] + rows[2], rows[3] - rows[2]});
        for (const glm::dvec4& end : ends) {
            forms.push_back(-end);
            const auto is_seen = [&](const std::vector<glm::dvec4>& part) {
                const glm::dvec4 middle = std::accumulate(part.begin(), part.end(), glm::dvec4(0.0));
                return !landing.hides(landing.plane_from_world * (object.world_from_model * middle));
            };
            if (any_part(object, forms, is_seen)) return true;
            forms.pop_back();
        }
        return false;
    });
}

glm::dmat4 seen_on_plane(const glm::dvec4& unit_plane, const glm::dvec4& eye_world) {
    return shadow_sign(unit_plane, eye_world) * shadow_matrix(unit_plane, eye_world);
}

std::array<glm::dvec4, 4> forms_of_edges(const glm::dmat4& plane_from_world, const PlanePatch& patch) {
    const glm::dmat4 rows = glm::transpose(plane_from_world);
    const auto offset = [&](const glm::dvec3& axis) {
        return axis.x * rows[0] + axis.y * rows[1] + axis.z * rows[2] - glm::dot(axis, patch.center) * rows[3];
    };
    const glm::dvec4 reach = patch.reach() * rows[3], along_u = offset(patch.u), along_v = offset(patch.v);
    return {reach + along_u, reach - along_u, reach + along_v, reach - along_v};
}

std::array<glm::dvec4, 4> forms_of_sides(const glm::dmat4& clip_from_world) {
    const glm::dmat4 rows = glm::transpose(clip_from_world);
    return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]};
}

std::vector<glm::dvec4> forms_of_frustum(const glm::dmat4& clip_from_world) {
    const glm::dmat4 rows = glm::transpose(clip_from_world);
    const std::array<glm::dvec4, 4> sides = forms_of_sides(clip_from_world);
    std::vector<glm::dvec4> forms(sides.begin(), sides.end());
    forms.insert(forms.end(), {rows[3] + rows[2], rows[3] - rows[2]});
    return forms;
}

bool may_reach(const SceneObject& object, std::span<const glm::dvec4> forms) {
    return any_part(object, forms, [](const std::vector<glm::dvec4>&) { return true; });
}

bool may_reach(const Scene& scene, std::span<const glm::dvec4> forms) {
    return !is_clear_of_any(scene, forms) &&
           std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](const SceneObject& object) { return may_reach(object, forms); });
}

bool may_reach_each(const Scene& scene, std::span<const glm::dvec4> forms) {
    return !is_clear_of_any(scene, forms) &&
           std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](const SceneObject& object) { return reaches_each(object, forms); });
}

bool may_reach(const PlanePatch& patch, std::span<const glm::dvec4> forms) {
    std::vector<glm::dvec4> part, kept;
    for (const glm::dvec3& corner : patch.corners()) part.emplace_back(corner, 1.0);
    for (const glm::dvec4& form : forms)
        keep_part(part, kept, [&form](const glm::dvec4& point) { return glm::dot(form, point); });
    return part.size() >= 3;
}

bool may_see(const Params& params, const Derived& derived, const Scene& scene, std::span<const glm::dvec4> forms,
             const glm::dmat4& place_from_world) {
    constexpr double least_area = 0.5 * 4.0 / (400.0 * 240.0);  // in normalized device coordinates
    const bool covers_nothing = culls_all(params) || (params.reflection.enabled && params.reflection.after_objects);
    std::optional<Hiding> hiding;
    double area = 0.0;
    const auto take = [&](const SceneObject& object, const std::vector<glm::dvec4>& part) {
        std::vector<glm::dvec3> places;
        for (const glm::dvec4& corner : part) {
            const glm::dvec4 place = place_from_world * object.world_from_model * corner;
            places.push_back(glm::dvec3(place) / place.w);
        }
        const glm::dvec3 middle =
            std::accumulate(places.begin(), places.end(), glm::dvec3(0.0)) / static_cast<double>(places.size());
        if (!hiding && !covers_nothing) hiding.emplace(scene);
        const bool is_seen = covers_nothing || std::any_of(places.begin(), places.end(), [&](const glm::dvec3& corner) {
                                 return !hiding->hides(glm::mix(middle, corner, 0.9), params, derived);
                             });
        if (is_seen) area += area_in_picture(derived.clip_from_world, places);
        return area > least_area;
    };
    return !is_clear_of_any(scene, forms) &&
           std::any_of(scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
               constexpr bool takes_points = false;  // they have no area
               return any_part(
                   object, forms, [&](const std::vector<glm::dvec4>& part) { return take(object, part); },
                   takes_points);
           });
}

bool is_too_thin(const SceneObject& object, const Derived& derived) {
    constexpr std::size_t most_vertices = 20'000;
    constexpr double thinnest = 1.0 / 2000.0;
    const Mesh& mesh = *object.mesh;
    if (object.description.shape != ShapeKind::mesh || mesh.positions.size() > most_vertices) return false;
    const std::optional<Drawn> drawn =
        drawn_size(mesh, derived.clip_from_world * object.world_from_model, derived.view_aspect);
    return drawn && drawn->thickness() < thinnest;
}

bool lies_in(const SceneObject& object, const glm::dvec4& unit_plane, double tolerance) {
    return !is_above(object, unit_plane, tolerance) && !is_above(object, -unit_plane, tolerance);
}

bool has_seen_face_in(const SceneObject& object, const glm::dvec4& unit_plane, double tolerance, const Params& params,
                      const Derived& derived) {
    constexpr std::size_t most_triangles = 10'000;
    const Mesh& mesh = *object.mesh;
    if (mesh.triangle_count() > most_triangles) return false;
    const auto stands_on = [&](const glm::dvec4& plane) {
        return is_at_most(object, plane, tolerance) && !is_above(object, -plane, tolerance);
    };
    if (!stands_on(unit_plane) && !stands_on(-unit_plane)) return false;
    // Seen from outside, triangles are counterclockwise.
    const auto culls = [&](bool is_outside) { return is_culled(params.cull, is_front(params.cull, is_outside)); };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        glm::dvec3 corners[3];
        bool is_in_plane = true;
        for (std::size_t corner = 0; corner < 3 && is_in_plane; ++corner) {
            const glm::dvec4 world =
                object.world_from_model * glm::dvec4(mesh.positions[mesh.indices[i + corner]], 1.0);
            corners[corner] = glm::dvec3(world);
            is_in_plane = std::abs(glm::dot(unit_plane, world)) <= tolerance;
        }
        if (!is_in_plane) continue;
        const glm::dvec3 towards_eye = glm::dvec3(derived.eye_world) - derived.eye_world.w * corners[0];
        const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const bool is_outside = glm::dot(normal, towards_eye) > 0.0;
        if (!culls(is_outside) && (is_outside || culls(true))) return true;
    }
    return false;
}

bool lands_inside(const Scene& scene, const Landing& landing) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](const SceneObject& object) { return lands(object, landing, true, true); });
}

}  // namespace viewing
