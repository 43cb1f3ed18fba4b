#include "report/matrices_report.h"

#include "frame/matrix_facts.h"
#include "report/as_json.h"

namespace viewing {
namespace {

/// `mirror` and `cast` belong to the first plane and light.
Json facts_as_json(const Facts& facts, const glm::dmat4& mirror, const CastShadow& cast) {
    const glm::dmat4& shadow = cast.shadowed_world_from_world;
    return {{"plane_dot_light", cast.plane_dot_light + 0.0},
            {"det_mirror", glm::determinant(mirror)},
            {"rank_shadow", rank_of(shadow)},
            {"depth_step_at_target", facts.depth_step_at_target},
            {"resolvable_step_at_target", facts.resolvable_step_at_target},
            {"target_distance", facts.target_distance},
            {"det_shadow", glm::determinant(shadow) + 0.0},
            {"shadow_residual", shadow_residual(shadow, cast.plane_dot_light)},
            {"mirror_residual", mirror_residual(mirror)},
            {"view_residual", facts.view_residual}};
}

Json followed_as_json(const FollowedPoint& followed) {
    return {{"point", as_json(followed.point_world)},
            {"shadow_homogeneous", as_json(followed.shadow_homogeneous)},
            {"shadow", followed.shadow_world ? as_json(*followed.shadow_world) : Json()},
            {"plane_distance", followed.plane_distance + 0.0},
            {"foot", as_json(followed.foot_world)},
            {"mirrored", as_json(followed.mirrored_world)}};
}

/// Returns R for each plane and S for each of its lights; the first R and S are the same as those reported separately.
Json planes_as_json(const Derived& derived) {
    Json planes = Json::array();
    for (const DerivedPlane& plane : derived.planes) {
        Json shadows = Json::array();
        for (const CastShadow& cast : plane.shadows)
            shadows.push_back({{"light", as_json(cast.light_world)},
                               {"shadow_from_world", as_json(cast.shadowed_world_from_world)},
                               {"shadow_sign", static_cast<int>(cast.sign)}});
        planes.push_back({{"equation", as_json(plane.unit_plane)},
                          {"mirror_from_world", as_json(plane.mirrored_world_from_world)},
                          {"shadows", std::move(shadows)}});
    }
    return planes;
}

}  // namespace

Json matrices_as_json(const Derived& derived, const std::vector<Problem>& problems) {
    const glm::dmat4& mirror = derived.planes.front().mirrored_world_from_world;
    const CastShadow& cast = derived.planes.front().shadows.front();
    Json all{{"world_from_view", as_json(derived.world_from_view)},
             {"view_from_world", as_json(derived.view_from_world)},
             {"look_at",
              {{"eye", as_json(derived.look_at.eye)},
               {"center", as_json(derived.look_at.center)},
               {"up", as_json(derived.look_at.up)}}},
             {"clip_from_view", as_json(derived.clip_from_view)},
             {"clip_from_world", as_json(derived.clip_from_world)},
             {"shadow_from_world", as_json(cast.shadowed_world_from_world)},
             {"shadow_sign", static_cast<int>(cast.sign)},
             {"mirror_from_world", as_json(mirror)},
             {"facts", facts_as_json(derived.facts, mirror, cast)},
             {"planes", planes_as_json(derived)},
             {"problems", as_json(problems)},
             {"problem_details", details_of(problems)}};
    if (derived.followed) all["followed"] = followed_as_json(*derived.followed);
    return all;
}

}  // namespace viewing
