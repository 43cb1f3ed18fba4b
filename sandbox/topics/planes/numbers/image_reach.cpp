#include "topics/planes/numbers/image_reach.h"

#include <algorithm>
#include <limits>
#include <set>

#include "frame/object_reach.h"

namespace viewing {
namespace {

WayThroughMirrors way_of(const Params& params, const Derived& derived, const FramePlan& frame, const Pass& pass) {
    WayThroughMirrors way;
    const std::vector<std::size_t>& mirrors = pass.mirrors_met;
    way.mirrors = mirrors;
    // For each mirror on the way, the eye, reflected in the mirrors before that mirror.
    std::vector<glm::dvec4> eyes = {derived.eye_world};
    for (const std::size_t mirror : mirrors)
        eyes.push_back(mirror_matrix(derived.planes[mirror].unit_plane) * eyes.back());
    glm::dmat4 world_from_scene(1.0);  // the product of R for this mirror and those after it
    for (std::size_t i = mirrors.size(); i-- > 0;) {
        const DerivedPlane& plane = derived.planes[mirrors[i]];
        if (i + 1 == mirrors.size()) {
            way.side = plane_facing(plane.unit_plane, eyes[i]);
            way.is_from_behind = glm::dot(plane.unit_plane, eyes[i]) < 0.0;
        }
        world_from_scene = plane.mirrored_world_from_world * world_from_scene;
        const glm::dmat4 on_mirror = seen_on_plane(plane.unit_plane, eyes[i]) * world_from_scene;
        if (!params.reflection.stencil) continue;
        way.inside.push_back(glm::transpose(on_mirror)[3]);
        for (const glm::dvec4& edge : forms_of_edges(on_mirror, plane.patch)) way.inside.push_back(edge);
    }
    for (const glm::dvec4& side : forms_of_sides(derived.clip_from_world * world_from_scene))
        way.inside.push_back(side);
    way.distance = -glm::transpose(derived.view_from_world * world_from_scene)[2];
    way.inside.push_back(way.distance - glm::dvec4(0.0, 0.0, 0.0, params.projection.near));
    const glm::dmat4 drawn = glm::transpose(pass.clip_from_world * pass.world_from_scene);
    way.before_far = frame.depth_mapping != DepthMapping::reversed ? drawn[3] - drawn[2]
                     : frame.clip_zero_to_one                      ? drawn[2]
                                                                   : drawn[3] + drawn[2];
    return way;
}

/// Adds an object's sampled vertices to its images.
void add(SeenImage& image, const SceneObject& object, const WayThroughMirrors& way, std::size_t tried) {
    const std::vector<glm::vec3>& positions = object.mesh->positions;
    const std::size_t step = std::max<std::size_t>(1, positions.size() / tried);
    for (std::size_t i = 0; i < positions.size(); i += step) {
        const glm::dvec4 point = object.world_from_model * glm::dvec4(positions[i], 1.0);
        if (!(glm::dot(way.side, point) > 0.0) ||
            !std::all_of(way.inside.begin(), way.inside.end(),
                         [&](const glm::dvec4& form) { return glm::dot(form, point) > 0.0; }))
            continue;
        const double distance = glm::dot(way.distance, point);
        image.nearest = std::min(image.nearest, distance);
        image.farthest = std::max(image.farthest, distance);
        (glm::dot(way.before_far, point) < 0.0 ? image.is_cut_off : image.is_shown) = true;
    }
}

}  // namespace

std::vector<glm::dvec4> WayThroughMirrors::forms_behind(double tolerance) const {
    std::vector<glm::dvec4> forms = inside;
    forms.push_back(-side);
    forms.back().w -= tolerance;
    return forms;
}

std::vector<WayThroughMirrors> ways_through_mirrors(const Params& params, const Derived& derived,
                                                    const FramePlan& frame) {
    std::vector<WayThroughMirrors> ways;
    std::set<std::vector<std::size_t>> taken;
    for (const Pass& pass : frame.passes) {
        const bool is_shadow = pass.shading == Shading::flat;
        if (pass.subject == Subject::objects && !pass.mirrors_met.empty() && !is_shadow &&
            taken.insert(pass.mirrors_met).second)
            ways.push_back(way_of(params, derived, frame, pass));
    }
    return ways;
}

std::vector<SeenImage> seen_images(const Params& params, const Derived& derived, const Scene& scene,
                                   const FramePlan& frame) {
    const std::vector<WayThroughMirrors> ways = ways_through_mirrors(params, derived, frame);
    if (ways.empty()) return {};
    constexpr std::size_t most_vertices = 20'000, least_tried = 8, most_tried = 64;
    const std::size_t tried = std::clamp(most_vertices / (ways.size() * std::max<std::size_t>(1, scene.objects.size())),
                                         least_tried, most_tried);
    std::vector<SeenImage> images;
    for (const SceneObject& object : scene.objects) {
        SeenImage image{object.description.name, std::numeric_limits<double>::infinity()};
        for (const WayThroughMirrors& way : ways) add(image, object, way, tried);
        if (image.is_shown || image.is_cut_off) images.push_back(image);
    }
    return images;
}

}  // namespace viewing
