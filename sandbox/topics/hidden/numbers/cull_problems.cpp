// Reports culling that removes the sides facing the eye, and a BSP tree that cuts too little. Part of problems.h.
#include "frame/object_reach.h"
#include "frame/say.h"
#include "text/numbers.h"
#include "text/words.h"
#include "topics/hidden/numbers/hidden_method.h"

namespace viewing {
namespace {

/// Returns whether an object's scale mirrors it, which reverses the winding of its polygons.
bool is_mirrored(const SceneObject& object) {
    return glm::determinant(glm::dmat3(object.world_from_model)) < 0.0;
}

/// Reports an epsilon of the BSP tree that is wide enough to cause visible errors.
void say_epsilon(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene) {
    if (!hidden_method(params.visibility.method).has_tree || scene.objects.empty()) return;
    const double epsilon =
        params.visibility.epsilon * glm::length(scene.bounds_world.max - scene.bounds_world.min);  // world units
    const glm::dvec4 center(0.5 * (scene.bounds_world.min + scene.bounds_world.max), 1.0);
    const double z = std::max(-(derived.view_from_world * center).z, params.lens().near);
    const double share = epsilon / picture_height(params.lens(), z);
    tell.broken(
        share > visible_share / 5.0,
        sentence("visibility.epsilon",
                 "epsilon = {epsilon} is {percent} of the picture's height: polygons that cross a plane by less "
                 "are not cut and may be drawn in the wrong order",
                 "epsilon"_a = figures(params.visibility.epsilon, 2), "percent"_a = percent(share)),
        "visibility.epsilon");
}

}  // namespace

void find_cull_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                        const Scene& scene, const std::vector<SeenImage>& images) {
    const CullParams& cull = params.cull;
    Sayer tell(problems, "visibility");
    say_epsilon(tell, params, derived, scene);
    if (!cull.enabled) return;
    std::vector<Message> usual, mirrored;
    for (const SceneObject& object : scene.objects)
        if (is_in_view(object, params, derived))
            (is_mirrored(object) ? mirrored : usual).push_back(object_message(object.description.name));
    if (cull.face == CullFace::front_and_back)
        return tell.broken(
            !usual.empty() || !mirrored.empty() || !images.empty(),
            sentence("cull.front_and_back",
                     "GL_FRONT_AND_BACK: both sides of every polygon are culled, so no polygon is drawn"),
            "cull.face");
    const bool removes_fronts = (cull.face == CullFace::front) != (cull.front_face == FrontFace::cw);
    const bool removes_usual = removes_fronts && !usual.empty();
    tell.broken(removes_usual && cull.front_face == FrontFace::ccw,
                sentence("cull.front",
                         "GL_FRONT culls the sides that face the eye: the picture shows the inside of the far sides"),
                "cull.face");
    tell.broken(
        removes_usual && cull.front_face == FrontFace::cw,
        sentence("cull.clockwise",
                 "GL_CW declares clockwise polygons front-facing, but fronts are counterclockwise here: GL_BACK culls "
                 "the sides that face the eye"),
        "cull.front_face");
    tell.broken(
        !removes_fronts && !mirrored.empty(),
        sentence("cull.negative_scale",
                 "the scale of {objects} is negative, which reverses the winding: front faces are clockwise and are "
                 "culled as back faces",
                 "objects"_a = enumerated(mirrored)),
        "cull.enabled");
}

}  // namespace viewing
