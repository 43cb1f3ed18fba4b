#include "frame/problems.h"

#include <algorithm>
#include <cmath>

#include "frame/depth/depth_switches.h"
#include "frame/effect.h"
#include "frame/hidden/hidden_drawing.h"
#include "frame/matrix_facts.h"
#include "frame/say.h"

namespace viewing {
namespace {

/// Reports a badly placed light: in a plane, or behind it. Planes with the same problem share a sentence.
void say_light(Sayer& tell, const Params& params, const Derived& derived, const Scene& scene, std::size_t index) {
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
    const std::size_t lights = derived.lights_world.size();
    const std::string light = light_name(index, lights);
    if (!holding.empty()) {
        const std::string where = planes_name(holding, planes.size());
        const std::string parallel =
            lights == 1 ? tr("the parallel light") : say("parallel light {light}", "light"_a = index + 1);
        const bool is_parallel = is_parallel_light(derived.lights_world[index]);
        tell(is_parallel,
             say("the rays of {light} run along {planes}: S sends every point to infinity, so no shadow is drawn",
                 "light"_a = parallel, "planes"_a = where));
        tell(!is_parallel, say("{light} lies in {planes}: S sends every point to the light, so no shadow is drawn",
                               "light"_a = light, "planes"_a = where));
    }
    if (turned_away.empty()) return;
    const glm::dvec4& at = derived.lights_world[index];
    const std::string negated =
        "[" + plain_number(0.0 - at.x) + "," + plain_number(0.0 - at.y) + "," + plain_number(0.0 - at.z) + ",0]";
    // A light that was entered correctly is on the objects' side of the planes.
    const glm::dvec4 center(0.5 * (scene.bounds_world.min + scene.bounds_world.max), 1.0);
    const bool is_beyond = std::all_of(turned_away.begin(), turned_away.end(), [&](std::size_t plane) {
        return planes[plane].shadows[index].plane_dot_light * glm::dot(planes[plane].unit_plane, center) < 0.0;
    });
    tell.broken(lights == 1 && is_parallel_light(at) && turned_away.size() == planes.size() && is_beyond,
                say("(x, y, z) of a parallel light points toward the light: if {direction} is the direction in which "
                    "the light travels, enter its negative",
                    "direction"_a = "(" + figures(at.x, 3) + ", " + figures(at.y, 3) + ", " + figures(at.z, 3) + ")"),
                "light.position=" + negated);
    const std::string behind = planes_name(turned_away, planes.size());
    tell(lights == 1, say("{light} and the eye are on opposite sides of {planes}: this side of the patch is unlit and "
                          "receives no shadow",
                          "light"_a = light, "planes"_a = behind));
    tell(lights > 1, say("{light} and the eye are on opposite sides of {planes}: the light neither lights this side of "
                         "the patch nor casts a shadow on it",
                         "light"_a = light, "planes"_a = behind));
}

/// Reports a light whose w is between 0 (a parallel light) and 1 (a point light), however small: S shows each w > 0.
void say_weight(Sayer& tell, const Derived& derived, std::size_t index) {
    const glm::dvec4& light = derived.lights_world[index];
    if (light.w <= 0.0 || light.w >= 1.0) return;
    const auto coordinate = [&light](int axis) { return figures(light[axis] / light.w, 3); };
    const std::string sentence =
        derived.lights_world.size() == 1
            ? say("w = {w} makes this a point light at ({x}, {y}, {z}): its shadows spread; only w = 0 gives parallel "
                  "light",
                  "w"_a = figures(light.w, 3), "x"_a = coordinate(0), "y"_a = coordinate(1), "z"_a = coordinate(2))
            : say("w = {w} makes light {light} a point light at ({x}, {y}, {z}): its shadows spread; only w = 0 gives "
                  "parallel light",
                  "w"_a = figures(light.w, 3), "light"_a = index + 1, "x"_a = coordinate(0), "y"_a = coordinate(1),
                  "z"_a = coordinate(2));
    const bool passes_for_parallel = light.w <= 0.25, is_first = index == 0;
    const std::string parallel = is_first ? fmt::format("light.position=[{},{},{},0]", format_number(light.x),
                                                        format_number(light.y), format_number(light.z))
                                          : "";
    tell.broken(passes_for_parallel, sentence, parallel);
    tell(!passes_for_parallel, sentence, parallel);
}

void find_light_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                         const Scene& scene) {
    Sayer tell(problems, "light");
    for (std::size_t light = 0; light < derived.lights_world.size(); ++light) {
        say_light(tell, params, derived, scene, light);
        say_weight(tell, derived, light);
    }
}

void find_plane_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    Sayer tell(problems, "plane");
    const std::span<const DerivedPlane> planes = drawn_planes(params, derived);
    std::vector<std::size_t> edge_on;
    for (std::size_t plane = 0; plane < planes.size(); ++plane)
        if (params.reflection.enabled && planes[plane].mirrors && planes[plane].eye_side == 0.0)
            edge_on.push_back(plane);
    if (!edge_on.empty()) {
        const std::string where = planes_name(edge_on, planes.size());
        const bool is_parallel = derived.eye_world.w == 0.0;
        tell(is_parallel, say("the lines of sight are parallel to {planes}: seen edge-on, the patch mirrors nothing",
                              "planes"_a = where));
        tell(!is_parallel,
             say("the eye lies in {planes}: seen edge-on, the patch mirrors nothing", "planes"_a = where));
    }
    tell.broken(planes.size() < derived.planes.size(),
                tr("this hidden-surface method draws only one plane: the others are left out of its picture"));
}

/// Returns the w that the uploaded matrix gives a point between the light and the plane.
double uploaded_w(const DerivedPlane& plane, const CastShadow& cast) {
    const glm::dvec4 towards_light = plane_facing(plane.unit_plane, cast.light_world);
    const double height = is_parallel_light(cast.light_world)
                              ? 1.0
                              : 0.5 * std::abs(cast.plane_dot_light) / std::max(cast.light_world.w, 1e-12);
    const glm::dvec4 between(plane.patch.center + height * glm::dvec3(towards_light), 1.0);
    return cast.sign * (cast.shadowed_world_from_world * between).w;
}

/// A relative tolerance, since entries may be typed with only five digits.
constexpr double by_hand_tolerance = 1e-4;

double largest_component(const glm::dvec4& v) {
    const glm::dvec4 size = glm::abs(v);
    return std::max({size.x, size.y, size.z, size.w});
}

/// Returns whether R leaves three points of the plane where they are, and therefore all of its points.
bool keeps_plane(const DerivedPlane& plane) {
    const PlanePatch& patch = plane.patch;
    const glm::dvec3 points[] = {patch.center, patch.center + patch.extent * patch.u,
                                 patch.center + patch.extent * patch.v};
    return std::all_of(std::begin(points), std::end(points), [&](const glm::dvec3& point) {
        const glm::dvec4 image = plane.mirrored_world_from_world * glm::dvec4(point, 1.0);
        return glm::length(glm::dvec3(image) / image.w - point) <= by_hand_tolerance * patch.extent;
    });
}

/// Returns "S" for the first plane and light, otherwise "S of plane 2, light 1".
std::string shadow_name(std::size_t plane, std::size_t light) {
    return plane == 0 && light == 0
               ? "S"
               : say("S of plane {plane}, light {light}", "plane"_a = plane + 1, "light"_a = light + 1);
}

/// Returns "R" for the first plane, otherwise "R of plane 2".
std::string mirror_name(std::size_t plane) {
    return plane == 0 ? "R" : say("R of plane {plane}", "plane"_a = plane + 1);
}

void find_overrides(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    Sayer tell_shadow(problems, "shadow"), tell_mirror(problems, "reflection");
    for (std::size_t plane = 0; plane < derived.planes.size(); ++plane) {
        const DerivedPlane& of = derived.planes[plane];
        for (std::size_t light = 0; light < of.shadows.size(); ++light) {
            const CastShadow& cast = of.shadows[light];
            if (!cast.by_hand) continue;
            const std::string matrix = shadow_name(plane, light);
            tell_shadow(true, say("{matrix} is entered by hand: the plane and the light no longer change it",
                                  "matrix"_a = matrix));
            // Here, Πᵀ S is a row vector times a matrix; if it is 0, every image lies in the plane.
            const glm::dmat4& s = cast.shadowed_world_from_world;
            const double size = largest_entry(s);
            const bool lands = largest_component(of.unit_plane * s) <= by_hand_tolerance * size;
            const bool transposed_lands =
                largest_component(of.unit_plane * glm::transpose(s)) <= by_hand_tolerance * size;
            tell_shadow.broken(params.shadow.enabled && !lands && transposed_lands,
                               say("{matrix} entered by hand does not land in the plane (Π·S p ≠ 0), but its transpose "
                                   "does: OpenGL reads columns",
                                   "matrix"_a = matrix));
            tell_shadow.broken(
                params.shadow.enabled && !lands && !transposed_lands,
                say("{matrix} entered by hand does not land in the plane: Π·S p ≠ 0", "matrix"_a = matrix));
            tell_shadow.broken(params.shadow.enabled && !cast.light_in_plane && uploaded_w(of, cast) < 0.0,
                               say("{matrix} entered by hand gives a negative w to points between the light and the "
                                   "plane: clipping removes the shadow; −S is the same projection with a positive w",
                                   "matrix"_a = matrix));
        }
    }
    for (std::size_t plane = 0; plane < derived.planes.size(); ++plane) {
        const DerivedPlane& of = derived.planes[plane];
        if (!of.mirror_by_hand) continue;
        tell_mirror(
            true, say("{matrix} is entered by hand: the plane no longer changes it", "matrix"_a = mirror_name(plane)));
        tell_mirror.broken(
            params.reflection.enabled && of.mirrors && !keeps_plane(of),
            say("{matrix} entered by hand moves the points of the plane itself, so the image does not fit "
                "its mirror",
                "matrix"_a = mirror_name(plane)));
    }
}

/// Reports the effects of mistakes on P and its picture.
void find_projection_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    Sayer tell(problems, "projection");
    const Lens lens = params.lens();
    if (params.slips.degrees_as_radians && !lens.orthographic) {
        const std::string fovy = figures(params.projection.fovy, 4);
        const double c = derived.clip_from_view[1][1];
        tell.broken(c > 0.0,
                    say("mistake: P takes radians but gets {fovy}°: {fovy} radians look like {degrees}°, and c = cot(½ "
                        "fovy) is {c}",
                        "fovy"_a = fovy, "degrees"_a = figures(lens.fovy_deg, 3), "c"_a = figures(c, 3)),
                    "slips.degrees_as_radians");
        tell.broken(c < 0.0,
                    say("mistake: P takes radians but gets {fovy}°: c = cot(½ fovy) is {c}, less than 0, so the "
                        "picture is flipped top to bottom and left to right",
                        "fovy"_a = fovy, "c"_a = figures(c, 3)),
                    "slips.degrees_as_radians");
    }
    const double stretch = derived.view_aspect / derived.aspect;
    tell.broken(std::abs(stretch - 1.0) > 1e-3,
                say("P expects a picture {aspect} times as wide as it is high, but the view's aspect ratio is {view}: "
                    "everything is stretched to {stretch} times its width",
                    "aspect"_a = figures(derived.aspect, 3), "view"_a = figures(derived.view_aspect, 3),
                    "stretch"_a = figures(stretch, 3)),
                "projection.aspect");
}

void find_slips(std::vector<Problem>& problems, const Params& params, const Scene& scene) {
    Sayer tell(problems, "camera");
    const SlipParams& slips = params.slips;
    const auto shows = [&](const char* path) { return why_without_effect(params, &scene, path).empty(); };
    tell(slips.walk_slows && shows("slips.walk_slows"),
         tr("mistake: walking follows the view direction, so it is slower when the camera looks up or down"));
    tell(slips.creeping_roll && shows("slips.creeping_roll"),
         tr("mistake: yaw and pitch both turn about the camera's own axes, so roll creeps in"));
    tell(slips.pole_flip && shows("slips.pole_flip"), tr("mistake: orbiting over the pole flips the picture"));
    tell(slips.swapped_order, tr("mistake: C = R·T instead of T·R, so the camera turns about the world's origin"));
    tell(slips.camera_as_view, tr("mistake: C is uploaded where V belongs, so V C is not I"));
}

}  // namespace

std::vector<Problem> find_problems(const Params& params, const Derived& derived, const Scene& scene,
                                   const FramePlan& frame) {
    std::vector<Problem> problems;
    const std::vector<SeenImage> images = seen_images(derived, scene, frame);
    find_view_problems(problems, params, derived, scene, images);
    find_slips(problems, params, scene);
    find_projection_problems(problems, params, derived);
    find_light_problems(problems, params, derived, scene);
    find_plane_problems(problems, params, derived);
    find_shadow_problems(problems, params, derived, scene);
    find_mirror_problems(problems, params, derived, scene, frame);
    find_overrides(problems, params, derived);
    // While the depth test rejects every fragment, no other effect on the picture can be seen.
    if (params.visibility.method == VisibilityMethod::depth_buffer && rejects_all(params.depth) &&
        !params.reflection.after_objects)
        std::erase_if(problems, [](const Problem& problem) { return problem.kind != ProblemKind::worth_knowing; });
    else
        find_cull_problems(problems, params, derived, scene);
    find_depth_problems(problems, params, derived, scene, images);
    if (params.follow && !derived.followed)
        problems.push_back({tr("the followed vertex does not exist in this scene"), "follow"});
    return problems;
}

}  // namespace viewing
