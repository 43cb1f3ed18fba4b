#include "ui/views/observer_parts.h"

#include <algorithm>

#include "frame/matrix_facts.h"
#include "geometry/plane.h"
#include "text/catalogue.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

constexpr std::size_t most_objects = 8, most_rays = 12;  ///< few enough that individual rays stay visible

/// Draws the edges of the near and far planes, and the side edges. The side edges run to the far plane from the eye or,
/// in an orthographic projection, from the near plane.
void draw_pyramid(Overlay& overlay, const std::array<glm::dvec3, 8>& corners, const glm::dvec3& eye, bool perspective,
                  ImU32 color) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
        overlay.line(corners[corner], corners[(corner + 1) % 4], color, 1.0F);
        overlay.line(corners[corner + 4], corners[(corner + 1) % 4 + 4], color, 1.0F);
        overlay.line(perspective ? eye : corners[corner], corners[corner + 4], color, 1.0F);
    }
}

}  // namespace

const std::vector<OutlineVertex>& LightRays::of(const Session& session, const Derived& derived) {
    const glm::dvec4 &plane = derived.chosen_plane().unit_plane, &light = derived.chosen_light();
    if (scene_version_ == session.scene_version() && plane_ == plane && light_ == light) return found_;
    scene_version_ = session.scene_version();
    plane_ = plane;
    light_ = light;
    found_.clear();
    std::size_t count = 0;
    for (const SceneObject& object : session.scene().objects) {
        const std::vector<OutlineVertex> rays = thinned(shadow_outline(object, plane_, light_), most_rays);
        found_.insert(found_.end(), rays.begin(), rays.end());
        count += rays.empty() ? 0 : 1;
        if (count == most_objects) break;
    }
    return found_;
}

void draw_light_rays(Overlay& overlay, const std::vector<OutlineVertex>& rays, const glm::dvec4& light_world) {
    const ImU32 faint = with_alpha(palette().light, 120);
    const bool parallel = is_parallel_light(light_world);
    constexpr double way_before = 3.0;  ///< visible length of a parallel ray before it reaches its vertex
    for (const OutlineVertex& ray : rays) {
        const glm::dvec3 from = parallel ? ray.vertex_world + glm::normalize(glm::dvec3(light_world)) * way_before
                                         : glm::dvec3(light_world) / light_world.w;
        overlay.line(from, ray.shadow_world, faint, 1.0F);
    }
}

void draw_patches(Overlay& overlay, const Derived& derived) {
    for (const DerivedPlane& plane : derived.planes) {
        const std::array<glm::dvec3, 4> corners = plane.patch.corners();
        for (std::size_t corner = 0; corner < 4; ++corner)
            overlay.line(corners[corner], corners[(corner + 1) % 4], palette().plane, 1.5F);
    }
}

void draw_frustum(Overlay& overlay, const Params& params, const Derived& derived, const glm::dmat4& world_from_view) {
    const std::array<glm::dvec3, 8> corners = frustum_corners(params, derived, world_from_view);
    const bool is_infinite = params.lens().is_infinite();
    for (std::size_t corner = 0; corner < 4; ++corner) {
        overlay.line(corners[corner], corners[(corner + 1) % 4], palette().camera);
        if (!is_infinite) overlay.line(corners[corner + 4], corners[(corner + 1) % 4 + 4], palette().camera, 1.5F);
        overlay.line(corners[corner], corners[corner + 4], palette().camera, 1.5F);
    }
    const ImU32 faint = with_alpha(palette().camera, 28);
    overlay.fill({corners[0], corners[1], corners[2], corners[3]}, faint);
    if (!is_infinite) overlay.fill({corners[4], corners[5], corners[6], corners[7]}, faint);
    const glm::dvec3 eye(world_from_view[3]);
    if (!params.lens().orthographic)
        for (std::size_t corner = 0; corner < 4; ++corner) overlay.line(eye, corners[corner], palette().camera);
    overlay.dot(eye, palette().camera, 5.0F);
    overlay.label(eye, tr("camera"), palette().camera);
    overlay.label((corners[0] + corners[1]) * 0.5, tr("near"), palette().camera);
    overlay.label((corners[4] + corners[5]) * 0.5, is_infinite ? tr("far: ∞") : tr("far"), palette().camera);
}

void draw_effective_eye(Overlay& overlay, const Params& params, const Derived& derived) {
    // Without one of these mistakes or an override of V, only an animation moves the effective camera away.
    if (!params.slips.swapped_order && !params.slips.camera_as_view && !params.camera_overrides.view_from_world) return;
    const glm::dmat4 effective = effective_camera(derived);
    if (largest_entry(effective - placed_camera(params)) < 1e-9) return;
    const glm::dvec3 eye(effective[3]);
    draw_pyramid(overlay, frustum_corners(params, derived, effective), eye, !params.lens().orthographic,
                 with_alpha(palette().trouble, 200));
    overlay.ring(eye, palette().trouble, 7.0F);
    overlay.dot(eye, palette().trouble, 4.0F);
    overlay.label(eye, tr("V puts the eye here"), palette().trouble);
}

void draw_mirrored_eye(Overlay& overlay, const Params& params, const Derived& derived) {
    // Compute R from the plane: the R in use may have been entered by hand or filled row by row.
    const glm::dmat4 mirrored_world_from_world = mirror_matrix(derived.chosen_plane().unit_plane);
    const auto mirrored = [&](const glm::dvec3& point) {
        return glm::dvec3(mirrored_world_from_world * glm::dvec4(point, 1.0));
    };
    const glm::dmat4 effective = effective_camera(derived);
    std::array<glm::dvec3, 8> corners = frustum_corners(params, derived, effective);
    std::transform(corners.begin(), corners.end(), corners.begin(), mirrored);
    const glm::dvec3 eye = mirrored(glm::dvec3(effective[3]));
    draw_pyramid(overlay, corners, eye, !params.lens().orthographic, with_alpha(palette().mirror, 170));
    overlay.dot(eye, palette().mirror, 5.0F);
    overlay.label(eye, tr("mirrored eye"), palette().mirror);
}

void label_image_space(Overlay& overlay, const Derived& derived) {
    const DerivedPlane& plane = derived.chosen_plane();
    const double behind = plane.eye_side < 0.0 ? 1.0 : -1.0;
    const glm::dvec3 normal(plane.unit_plane);
    overlay.label(plane.patch.center + behind * 0.4 * plane.patch.extent * normal, tr("image space"), palette().mirror);
}

}  // namespace viewing
