#include "frame/problems.h"

#include <algorithm>

namespace viewing {
namespace {

/// Names of the objects of which some vertex lies at least as far from the plane as the light.
std::string casters_beyond_light(const Derived& derived, const Scene& scene) {
    const glm::dvec4 w_of_shadow = derived.shadow_sign * glm::transpose(derived.shadow_from_world)[3];
    // w is linear, so where it is positive at the corners of the scene's bounds it is so everywhere inside: no need to
    // look at a million vertices.
    const Bounds& bounds = scene.bounds_world;
    double smallest_w = w_of_shadow.w;
    for (int axis = 0; axis < 3; ++axis)
        smallest_w += std::min(w_of_shadow[axis] * bounds.min[axis], w_of_shadow[axis] * bounds.max[axis]);
    if (!bounds.empty() && smallest_w > 0.0) return "";

    std::string names;
    for (const SceneObject& object : scene.objects) {
        const glm::dvec4 w_of_model = w_of_shadow * object.world_from_model;
        const auto is_beyond = [&](const glm::vec3& vertex) { return glm::dot(w_of_model, {vertex, 1.0}) <= 0.0; };
        if (std::ranges::any_of(object.mesh->positions, is_beyond))
            names += (names.empty() ? "" : ", ") + object.description.name;
    }
    return names;
}

void find_plane_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                         const Scene& scene) {
    const auto say = [&](std::string_view group, std::string sentence) {
        problems.push_back({std::move(sentence), group});
    };
    if (derived.light_in_plane && params.light.position.w == 0.0) {
        say("light", "the parallel light runs along the plane: S sends every point to infinity, so no shadow is drawn");
    } else if (derived.light_in_plane) {
        say("light", "the light lies in the plane: S sends every point to the light, so no shadow is drawn");
    } else if (!light_reaches(derived, derived.eye_side) && derived.eye_side != 0.0) {
        say("light",
            "the light is on the other side of the plane than the eye: this side of the patch is unlit and no shadow "
            "falls on it");
    } else if (params.shadow.enabled && params.light.position.w > 0.0) {
        const std::string names = casters_beyond_light(derived, scene);
        if (!names.empty())
            say("shadow", "part of " + names +
                              " is not between the light and the plane (w ≤ 0 there): that part casts no shadow");
    }
    if (derived.eye_side == 0.0)
        say("plane", derived.eye_world.w == 0.0
                         ? "the lines of sight run along the plane: its patch is seen edge-on and mirrors nothing"
                         : "the eye lies in the plane: its patch is seen edge-on and mirrors nothing");
    if (params.overrides.shadow_from_world)
        say("shadow", "S is overridden by hand: plane and light no longer change it");
    if (params.overrides.mirror_from_world)
        say("reflection", "R is overridden by hand: the plane no longer changes it");
}

void find_slips(std::vector<Problem>& problems, const SlipParams& slips) {
    const auto say = [&](bool is_on, const char* sentence) {
        if (is_on) problems.push_back({sentence, "camera"});
    };
    say(slips.walk_slows, "slip: walking follows the view direction, so it slows when looking up or down");
    say(slips.creeping_roll, "slip: yaw and pitch both turn about the camera's own axes, so roll creeps in");
    say(slips.pole_flip, "slip: orbiting over the pole flips the picture");
    say(slips.swapped_order, "slip: C = R·T in place of T·R, so the camera turns about the world's origin");
    say(slips.camera_as_view, "slip: C is uploaded where V belongs, so V C is not I");
}

/// What the state asks for and this version reads, keeps and does not draw yet: said, never silent.
void find_unsupported(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    const auto say = [&](bool asked, std::string_view group, const char* sentence) {
        if (asked) problems.push_back({sentence, group});
    };
    say(!params.lights.empty(), "light", "further lights are kept but not drawn yet: only \"light\" shines");
    say(!params.planes.empty(), "plane", "further planes are kept but not drawn yet: only \"plane\" is there");
    say(params.reflection.bounces > 1, "reflection",
        "one plane mirrors once: reflection.bounces above 1 changes nothing yet");
    say(params.reflection.clip == MirrorClip::oblique && params.depth.mapping == DepthMapping::reversed, "reflection",
        "the oblique near plane is made for depth that grows with distance: with reversed depth the clip distance is "
        "used");
    say(params.follow && !derived.followed, "follow", "the followed vertex does not exist in this scene");
}

}  // namespace

std::vector<Problem> find_problems(const Params& params, const Derived& derived, const Scene& scene) {
    std::vector<Problem> problems;
    find_slips(problems, params.slips);
    find_plane_problems(problems, params, derived, scene);
    find_depth_problems(problems, params, derived, scene);
    find_unsupported(problems, params, derived);
    return problems;
}

}  // namespace viewing
