#include "topics/planes/numbers/oblique_depth.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

constexpr std::size_t most_samples = 600;

/// Window depth along a view ray: its rate of change, and the distance between its codes.
class DepthAlong {
public:
    DepthAlong(const glm::dmat4& clip_from_world, const DepthPrecision& precision, bool zero_to_one)
        : clip_from_world_(clip_from_world), precision_(precision), zero_to_one_(zero_to_one) {}

    glm::dvec4 clip(const glm::dvec3& at_world) const { return clip_from_world_ * glm::dvec4(at_world, 1.0); }

    /// Returns the width of a code along the direction, in world units.
    double width_of_code(const glm::dvec3& at_world, const glm::dvec3& direction) const {
        const glm::dvec4 here = clip(at_world), change = clip_from_world_ * glm::dvec4(direction, 0.0);
        const double share = zero_to_one_ ? 1.0 : 0.5;
        const double slope = share * (change.z * here.w - here.z * change.w) / (here.w * here.w);
        const double depth = zero_to_one_ ? here.z / here.w : 0.5 * here.z / here.w + 0.5;
        return code_width(precision_, depth) / std::abs(slope);
    }

private:
    glm::dmat4 clip_from_world_;
    DepthPrecision precision_;
    bool zero_to_one_;
};

bool is_in_view(const glm::dvec4& clip, bool zero_to_one) {
    return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && clip.z <= clip.w &&
           clip.z >= (zero_to_one ? 0.0 : -clip.w);
}

/// Returns whether the view ray to a point passes through the patch.
bool is_seen_in(const PlanePatch& patch, const glm::dvec3& at_world, const glm::dvec3& direction) {
    const double way = glm::dot(patch.normal, patch.center - at_world) / glm::dot(patch.normal, direction);
    return way < 0.0 && patch.holds(at_world + way * direction);
}

}  // namespace

std::optional<ObliqueDepth> oblique_depth(const Params& params, const Derived& derived, const Scene& scene,
                                          const FramePlan& frame) {
    if (params.depth.mapping == DepthMapping::logarithmic) return std::nullopt;
    const auto image = std::find_if(frame.passes.begin(), frame.passes.end(), [](const Pass& pass) {
        return pass.is_mirror_image && pass.subject == Subject::objects;
    });
    if (image == frame.passes.end()) return std::nullopt;
    const DerivedPlane& mirror = derived.planes[image->plane];
    const DepthPrecision precision = precision_of(params.depth.format);
    const bool zero_to_one = frame.clip_zero_to_one;
    const glm::dmat4& image_from_scene = mirror.mirrored_world_from_world;
    // The mirrored camera sees the scene itself as the camera sees the scene's image.
    const bool by_camera = params.reflection.mirrored == MirroredThing::camera;
    const glm::dmat4 scene_from_image = glm::inverse(image_from_scene);
    const DepthAlong oblique(by_camera ? image->clip_from_world * scene_from_image : image->clip_from_world, precision,
                             zero_to_one);
    const DepthAlong plain(derived.clip_from_view * derived.view_from_world, precision, zero_to_one);

    std::size_t vertices = 0;
    for (const SceneObject& object : scene.objects) vertices += object.mesh->positions.size();
    const std::size_t stride = vertices / most_samples + 1;
    std::optional<ObliqueDepth> found;
    std::size_t next = 0, before = 0;  // the next sample and this object's first vertex, both numbered over all objects
    for (const SceneObject& object : scene.objects) {
        const std::size_t count = object.mesh->positions.size();
        const glm::dmat4 image_from_model = image_from_scene * object.world_from_model;
        for (; next < before + count; next += stride) {
            const glm::dvec3 at(image_from_model * glm::dvec4(object.mesh->positions[next - before], 1.0));
            const glm::dvec3 direction = line_of_sight(derived.eye_world, at);
            if (!is_in_view(oblique.clip(at), zero_to_one) || !is_seen_in(mirror.patch, at, direction)) continue;
            const double ratio = oblique.width_of_code(at, direction) / plain.width_of_code(at, direction);
            if (std::isnan(ratio)) continue;
            if (!found) found = ObliqueDepth{ratio, 0.0, 0.0};
            found->least = std::min(found->least, ratio);
            if (ratio > found->greatest) {
                found->greatest = ratio;
                found->coarsest_distance = -(derived.view_from_world * glm::dvec4(at, 1.0)).z;
            }
        }
        before += count;
    }
    return found;
}

}  // namespace viewing
