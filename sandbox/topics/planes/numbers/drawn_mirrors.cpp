#include "topics/planes/numbers/drawn_mirrors.h"

#include <algorithm>

#include "frame/cleared_code.h"
#include "frame/object_reach.h"

namespace viewing {

std::vector<Mirror> drawn_mirrors(const Params& params, const Derived& derived, const FramePlan* frame) {
    std::vector<Mirror> mirrors;
    for (const DerivedPlane& plane : drawn_planes(params, derived))
        if (const double side = plane.eye_side; plane.mirrors && side != 0.0)
            mirrors.push_back({plane, side,
                               params.reflection.stencil ? may_show(plane.patch, params, derived)
                                                         : is_in_view(plane.patch, derived.clip_from_world)});
    for (Mirror& mirror : mirrors) {
        mirror.clip_from_scene = derived.clip_from_world * mirror.plane.mirrored_world_from_world;
        if (!frame) continue;
        const auto index = static_cast<std::size_t>(&mirror.plane - derived.planes.data());
        for (const Pass& pass : frame->passes)
            if (pass.subject == Subject::objects && pass.shading != Shading::flat &&
                pass.mirrors_met == std::vector{index})
                mirror.clip_from_scene = pass.clip_from_world * pass.world_from_scene;
    }
    const bool sees_any =
        std::any_of(mirrors.begin(), mirrors.end(), [](const Mirror& mirror) { return mirror.is_in_view; });
    return sees_any ? mirrors : std::vector<Mirror>{};
}

glm::dmat4 on_mirror_from_scene(const Derived& derived, const Mirror& mirror, const glm::dmat4& clip_from_scene) {
    return seen_on_plane(mirror.plane.unit_plane, derived.eye_world) * glm::inverse(derived.clip_from_world) *
           clip_from_scene;
}

std::vector<glm::dvec4> forms_of_image(const Params& params, const Derived& derived, const Mirror& mirror,
                                       const glm::dmat4& clip_from_scene) {
    std::vector<glm::dvec4> forms;
    for (const glm::dvec4& side : forms_of_sides(clip_from_scene)) forms.push_back(side);
    if (!params.reflection.stencil) return forms;
    const glm::dmat4 on_mirror = on_mirror_from_scene(derived, mirror, clip_from_scene);
    forms.push_back(glm::transpose(on_mirror)[3]);
    for (const glm::dvec4& edge : forms_of_edges(on_mirror, mirror.plane.patch)) forms.push_back(edge);
    return forms;
}

std::vector<glm::dvec4> forms_of_drawn_image(const Params& params, const Derived& derived, const Mirror& mirror,
                                             const glm::dmat4& clip_from_scene) {
    std::vector<glm::dvec4> forms = forms_of_image(params, derived, mirror, clip_from_scene);
    const glm::dmat4 clip = glm::transpose(clip_from_scene);
    forms.insert(forms.end(), {mirror.kept_side(params.reflection), clip[3] + clip[2], clip[3] - clip[2]});
    return forms;
}

bool may_draw_image(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene,
                    const glm::dmat4& clip_from_scene) {
    if (culls_all(params)) return false;
    const std::vector<glm::dvec4> forms = forms_of_drawn_image(params, derived, mirror, clip_from_scene);
    if (!params.reflection.stencil) return may_reach(scene, forms);
    return may_see(params, derived, scene, forms, on_mirror_from_scene(derived, mirror, clip_from_scene));
}

bool may_show_image(const Params& params, const Derived& derived, const Mirror& mirror, const Scene& scene) {
    return drawn_planes(params, derived).size() > 1 ||
           may_draw_image(params, derived, mirror, scene, mirror.clip_from_scene) ||
           may_draw_image(params, derived, mirror, scene,
                          derived.clip_from_world * mirror_matrix(mirror.plane.unit_plane));
}

}  // namespace viewing
