#include "frame/problems.h"

#include <algorithm>
#include <cmath>

#include "frame/hidden/hidden_drawing.h"
#include "frame/say.h"

namespace viewing {
namespace {

/// Where a light lies badly: in a plane, or behind it. Planes with the same trouble share a sentence.
void say_light(Sayer& say, const Params& params, const Derived& derived, std::size_t index) {
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    std::vector<std::size_t> holding, turned_away;
    for (std::size_t plane = 0; plane < planes.size(); ++plane) {
        const double eye_side = planes[plane].eye_side;
        const CastShadow& cast = planes[plane].shadows[index];
        if (cast.light_in_plane)
            holding.push_back(plane);
        else if (!cast.reaches(eye_side) && eye_side != 0.0)
            turned_away.push_back(plane);
    }
    const bool is_alone = derived.lights_world.size() == 1;
    const bool is_parallel = is_parallel_light(derived.lights_world[index]);
    const std::string light = name_of("light", {index}, derived.lights_world.size());
    if (!holding.empty()) {
        const std::string where = name_of("plane", holding, planes.size());
        const std::string parallel_light = name_of("parallel light", {index}, derived.lights_world.size());
        say(is_parallel,
            parallel_light + " runs along " + where + ": S sends every point to infinity, so no shadow is drawn");
        say(!is_parallel, light + " lies in " + where + ": S sends every point to the light, so no shadow is drawn");
    }
    if (turned_away.empty()) return;
    say(true, light + " is on the other side of " + name_of("plane", turned_away, planes.size()) + " than the eye: " +
                  (is_alone ? "this side of the patch is unlit and no shadow falls on it"
                            : "it neither lights this side of the patch nor throws a shadow on it"));
}

/// Between point and parallel.
void say_weight(Sayer& say, const Derived& derived, std::size_t index) {
    const glm::dvec4& light = derived.lights_world[index];
    if (is_parallel_light(light) || light.w >= 1.0) return;
    const std::string of = derived.lights_world.size() > 1 ? " of light " + std::to_string(index + 1) : "";
    const std::string place = signed_figures(light.x / light.w) + ", " + signed_figures(light.y / light.w) + ", " +
                              signed_figures(light.z / light.w);
    const std::string sentence = "w = " + signed_figures(light.w) + of + " is a point light at (" + place +
                                 "): its shadows spread; only w = 0 gives parallel ones";
    const bool passes_for_parallel = light.w <= 0.25;
    say.broken(passes_for_parallel, sentence);
    say(!passes_for_parallel, sentence);
}

void find_light_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    Sayer say(problems, "light");
    for (std::size_t light = 0; light < derived.lights_world.size(); ++light) {
        say_light(say, params, derived, light);
        say_weight(say, derived, light);
    }
}

void find_plane_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    Sayer say(problems, "plane");
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    std::vector<std::size_t> edge_on;
    for (std::size_t plane = 0; plane < planes.size(); ++plane)
        if (planes[plane].eye_side == 0.0) edge_on.push_back(plane);
    if (!edge_on.empty()) {
        const std::string where = name_of("plane", edge_on, planes.size());
        const char* const means = ": its patch is seen edge-on and mirrors nothing";
        say(derived.eye_world.w == 0.0, "the lines of sight run along " + where + means);
        say(derived.eye_world.w != 0.0, "the eye lies in " + where + means);
    }
    say.broken(planes.size() < derived.planes.size(),
               "the method of hidden surfaces draws one plane: further ones are left out of its picture");
}

/// The w of a point between light and plane, as it is uploaded.
double uploaded_w(const DerivedPlane& plane, const CastShadow& cast) {
    const glm::dvec4 towards_light = plane_facing(plane.unit_plane, cast.light_world);
    const double height = is_parallel_light(cast.light_world)
                              ? 1.0
                              : 0.5 * std::abs(cast.plane_dot_light) / std::max(cast.light_world.w, 1e-12);
    const glm::dvec4 between(plane.patch.center + height * glm::dvec3(towards_light), 1.0);
    return cast.sign * (cast.shadowed_world_from_world * between).w;
}

/// "S" of the first plane and light, "S of plane 2, light 1".
std::string shadow_name(std::size_t plane, std::size_t light) {
    return plane == 0 && light == 0
               ? "S"
               : "S of plane " + std::to_string(plane + 1) + ", light " + std::to_string(light + 1);
}

void find_overrides(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    for (std::size_t plane = 0; plane < derived.planes.size(); ++plane) {
        const DerivedPlane& of = derived.planes[plane];
        for (std::size_t light = 0; light < of.shadows.size(); ++light) {
            const CastShadow& cast = of.shadows[light];
            if (!cast.by_hand) continue;
            problems.push_back(
                {shadow_name(plane, light) + " is overridden by hand: plane and light no longer change it", "shadow"});
            if (params.shadow.enabled && !cast.light_in_plane && uploaded_w(of, cast) < 0.0)
                problems.push_back({shadow_name(plane, light) +
                                        " by hand has a negative w between light and plane: the clipper removes the "
                                        "shadow; −S is the same map",
                                    "shadow", true});
        }
    }
    for (std::size_t plane = 0; plane < derived.planes.size(); ++plane)
        if (derived.planes[plane].mirror_by_hand)
            problems.push_back({(plane == 0 ? "R" : "R of plane " + std::to_string(plane + 1)) +
                                    std::string(" is overridden by hand: the plane no longer changes it"),
                                "reflection"});
}

void find_slips(std::vector<Problem>& problems, const SlipParams& slips) {
    Sayer say(problems, "camera");
    say(slips.walk_slows, "slip: walking follows the view direction, so it slows when looking up or down");
    say(slips.creeping_roll, "slip: yaw and pitch both turn about the camera's own axes, so roll creeps in");
    say(slips.pole_flip, "slip: orbiting over the pole flips the picture");
    say(slips.swapped_order, "slip: C = R·T in place of T·R, so the camera turns about the world's origin");
    say(slips.camera_as_view, "slip: C is uploaded where V belongs, so V C is not I");
}

}  // namespace

std::vector<Problem> find_problems(const Params& params, const Derived& derived, const Scene& scene,
                                   const FramePlan& frame) {
    std::vector<Problem> problems;
    find_slips(problems, params.slips);
    find_light_problems(problems, params, derived);
    find_plane_problems(problems, params, derived);
    find_shadow_problems(problems, params, derived, scene);
    find_mirror_problems(problems, params, derived, scene, frame.reflection_depth);
    find_overrides(problems, params, derived);
    find_depth_problems(problems, params, derived, scene);
    if (params.follow && !derived.followed)
        problems.push_back({"the followed vertex does not exist in this scene", "follow"});
    return problems;
}

}  // namespace viewing
