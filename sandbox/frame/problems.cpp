#include "frame/problems.h"

#include <algorithm>
#include <cmath>

#include "frame/cleared_code.h"
#include "frame/depth_switches.h"
#include "frame/effect.h"
#include "frame/matrix_facts.h"
#include "frame/say.h"
#include "topics/planes/numbers/drawn_mirrors.h"

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
    const Message light = light_name(index, lights);
    if (!holding.empty()) {
        const Message where = planes_name(holding, planes.size());
        const Message parallel =
            lights == 1 ? message("the parallel light") : message("parallel light {light}", "light"_a = index + 1);
        const bool is_parallel = is_parallel_light(derived.lights_world[index]);
        tell(is_parallel,
             sentence("light.along_plane",
                      "the rays of {light} run along {planes}: S sends every point to infinity, so no shadow is drawn",
                      "light"_a = parallel, "planes"_a = where));
        tell(!is_parallel, sentence("light.in_plane",
                                    "{light} lies in {planes}: S sends every point to the light, so no shadow is drawn",
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
    tell.broken(
        lights == 1 && is_parallel_light(at) && turned_away.size() == planes.size() && is_beyond,
        sentence("light.travel_direction",
                 "(x, y, z) of a parallel light points toward the light: if {direction} is the direction in which "
                 "the light travels, enter its negative",
                 "direction"_a = figures_of({&at.x, 3}, 3)),
        "light.position=" + negated);
    const Message behind = planes_name(turned_away, planes.size());
    tell(lights == 1,
         sentence("light.behind_plane",
                  "{light} and the eye are on opposite sides of {planes}: this side of the patch is unlit and "
                  "receives no shadow",
                  "light"_a = light, "planes"_a = behind));
    tell(lights > 1,
         sentence("light.behind_plane",
                  "{light} and the eye are on opposite sides of {planes}: the light neither lights this side of "
                  "the patch nor casts a shadow on it",
                  "light"_a = light, "planes"_a = behind));
}

/// Reports a light whose w is between 0 (a parallel light) and 1 (a point light), even a tiny w: any w > 0 changes S.
void say_weight(Sayer& tell, const Params& params, const Derived& derived, std::size_t index) {
    const glm::dvec4& light = derived.lights_world[index];
    if (light.w <= 0.0 || light.w >= 1.0) return;
    const auto coordinate = [&light](int axis) { return figures(light[axis] / light.w, 3); };
    const bool casts = params.shadow.enabled && params.shadow.opacity > 0.0 &&
                       std::any_of(derived.planes.begin(), derived.planes.end(), [index](const DerivedPlane& plane) {
                           return plane.receives_shadow && plane.shadows[index].reaches(plane.eye_side);
                       });
    const bool is_only = derived.lights_world.size() == 1;
    if (!casts)
        return tell(true,
                    sentence("light.small_w",
                             "w = {w} makes {light} a point light at ({x}, {y}, {z}); only w = 0 gives parallel "
                             "light",
                             "w"_a = figures(light.w, 3), "light"_a = light_name(index, derived.lights_world.size()),
                             "x"_a = coordinate(0), "y"_a = coordinate(1), "z"_a = coordinate(2)));
    const Sentence point_light =
        is_only
            ? sentence(
                  "light.small_w",
                  "w = {w} makes this a point light at ({x}, {y}, {z}): its shadows spread; only w = 0 gives parallel "
                  "light",
                  "w"_a = figures(light.w, 3), "x"_a = coordinate(0), "y"_a = coordinate(1), "z"_a = coordinate(2))
            : sentence(
                  "light.small_w",
                  "w = {w} makes light {light} a point light at ({x}, {y}, {z}): its shadows spread; only w = 0 gives "
                  "parallel light",
                  "w"_a = figures(light.w, 3), "light"_a = index + 1, "x"_a = coordinate(0), "y"_a = coordinate(1),
                  "z"_a = coordinate(2));
    const bool passes_for_parallel = light.w <= 0.25;
    const bool has_direction = index == 0 && glm::dvec3(light) != glm::dvec3(0.0);  // other lights have no path
    const std::string parallel = has_direction ? fmt::format("light.position=[{},{},{},0]", format_number(light.x),
                                                             format_number(light.y), format_number(light.z))
                                               : "";
    tell.broken(passes_for_parallel, point_light, parallel);
    tell(!passes_for_parallel, point_light, parallel);
}

void find_light_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                         const Scene& scene) {
    Sayer tell(problems, "light");
    for (std::size_t light = 0; light < derived.lights_world.size(); ++light) {
        say_light(tell, params, derived, scene, light);
        say_weight(tell, params, derived, light);
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
        const Message where = planes_name(edge_on, planes.size());
        const bool is_parallel = derived.eye_world.w == 0.0;
        tell(is_parallel,
             sentence("plane.edge_on",
                      "the lines of sight are parallel to {planes}: seen edge-on, the patch mirrors nothing",
                      "planes"_a = where));
        tell(!is_parallel,
             sentence("plane.edge_on", "the eye lies in {planes}: seen edge-on, the patch mirrors nothing",
                      "planes"_a = where));
    }
    tell.broken(planes.size() < derived.planes.size(),
                sentence("plane.one_drawn",
                         "this hidden-surface method draws only one plane: the others are left out of its picture"));
}

/// Says how the picture is stretched if the window's aspect ratio differs from the view's, and offers a left and right
/// that fit.
void tell_stretched_window(Sayer& tell, const Edges& window, double view_aspect) {
    const double middle = window.center().x, half = 0.5 * window.height() * view_aspect;
    tell(std::abs(view_aspect / window.aspect() - 1.0) > 1e-3,
         sentence(
             "projection.window_stretched",
             "the projection window is {aspect} times as wide as it is high, but the view's aspect ratio is {view}: "
             "everything is stretched to {stretch} times its width",
             "aspect"_a = figures(window.aspect(), 3), "view"_a = figures(view_aspect, 3),
             "stretch"_a = figures(view_aspect / window.aspect(), 3)),
         "projection={\"left\": " + plain_number(middle - half) + ", \"right\": " + plain_number(middle + half) + "}");
}

/// Reports the effects of mistakes on P and its picture.
void find_projection_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                              const Scene& scene, bool is_by_hand) {
    Sayer tell(problems, "projection");
    const Lens lens = params.lens();
    Params right = params;
    right.slips.degrees_as_radians = false;
    const glm::dmat4 right_clip = clip_from_view(right.lens(), derived.aspect) * derived.view_from_world;
    const bool shows =
        shows_anything(derived.clip_from_world, derived, scene) || shows_anything(right_clip, derived, scene);
    if (shows && params.slips.degrees_as_radians && !lens.orthographic && !lens.window) {
        const std::string fovy = figures(params.projection.fovy, 4);
        const double c = derived.clip_from_view[1][1];
        tell.broken(
            c > 0.0,
            sentence("projection.degrees_as_radians",
                     "mistake: P takes radians but gets {fovy}°: {fovy} radians look like {degrees}°, and c = cot(½ "
                     "fovy) is {c}",
                     "fovy"_a = fovy, "degrees"_a = figures(lens.fovy_deg, 3), "c"_a = figures(c, 3)),
            "slips.degrees_as_radians");
        tell.broken(c < 0.0,
                    sentence("projection.degrees_as_radians",
                             "mistake: P takes radians but gets {fovy}°: c = cot(½ fovy) is {c}, less than 0, so the "
                             "picture is flipped top to bottom and left to right",
                             "fovy"_a = fovy, "c"_a = figures(c, 3)),
                    "slips.degrees_as_radians");
    }
    const double stretch = derived.view_aspect / derived.aspect;
    if (lens.window && !is_by_hand) return tell_stretched_window(tell, *lens.window, derived.view_aspect);
    tell.broken(
        std::abs(stretch - 1.0) > 1e-3 && stretch > 0.0,
        sentence("projection.other_aspect",
                 "P expects a picture {aspect} times as wide as it is high, but the view's aspect ratio is {view}: "
                 "everything is stretched to {stretch} times its width",
                 "aspect"_a = figures(derived.aspect, 3), "view"_a = figures(derived.view_aspect, 3),
                 "stretch"_a = figures(stretch, 3)),
        "projection.aspect");
}

void find_slips(std::vector<Problem>& problems, const Params& params, const Derived& derived, const Scene& scene) {
    Sayer tell(problems, "camera");
    const SlipParams& slips = params.slips;
    const auto shows = [&](const char* path) { return why_without_effect(params, &scene, path).empty(); };
    tell(slips.walk_slows && shows("slips.walk_slows"),
         sentence("camera.walk_slows",
                  "mistake: walking follows the view direction, so it is slower when the camera looks up or down"));
    tell(slips.creeping_roll && shows("slips.creeping_roll"),
         sentence("camera.creeping_roll",
                  "mistake: yaw and pitch both turn about the camera's own axes, so roll creeps in"));
    tell(slips.pole_flip && shows("slips.pole_flip"),
         sentence("camera.pole_flip", "mistake: orbiting over the pole flips the picture"));
    const bool computes_view = !params.camera_overrides.view_from_world;
    // R·T is T·R at the origin, or without a turn.
    const glm::dmat4 right = view_from_world(world_from_view(params.camera.position, params.camera.angles()));
    const bool is_wrong = largest_entry(derived.view_from_world - right) > 1e-9;
    const auto say_slip = [&](bool is_so, const Sentence& said, const char* fix) {
        is_wrong ? tell.broken(is_so, said, fix) : tell(is_so, said);
    };
    say_slip(slips.swapped_order && computes_view,
             sentence("camera.swapped_order",
                      "mistake: C = R·T instead of T·R, so the camera turns about the world's origin"),
             "slips.swapped_order");
    say_slip(slips.camera_as_view && computes_view,
             sentence("camera.camera_as_view", "mistake: C is uploaded where V belongs, so V C is not I"),
             "slips.camera_as_view");
}

/// Returns whether the depth test rejects every object: always, or because the depths of the previous frame stay, or
/// because every depth has the code of the cleared buffer.
bool hides_objects(const Params& params, const Derived& derived, const Scene& scene) {
    const DepthParams& depth = params.depth;
    const bool is_less = depth.tests() && depth.func == CompareFunc::less && is_cleared_to_farthest(depth);
    return uses_gl_depth_test(params.visibility.method) &&
           (rejects_all(depth) || hides_next_frame(depth) ||
            (is_less && derived.has_distances && has_only_cleared_code(params, derived, scene)));
}

/// Drops what is broken but cannot be seen while the depth test rejects the objects. Without the receiver's mask, a
/// shadow beyond its patch is still drawn where it is nearer than the depths of the previous frame. A mirror that is
/// drawn last is not tested, so it shows a wrong P and an S filled by rows. Such a mirror clears depth for its
/// image, so nearer fragments of the image pass.
void drop_unseen(std::vector<Problem>& problems, const Params& params, const Derived& derived) {
    const DepthParams& depth = params.depth;
    const ReflectionParams& reflection = params.reflection;
    const bool rejects = rejects_all(depth),
               shows_last = reflection.enabled && reflection.after_objects && !drawn_mirrors(params, derived).empty(),
               is_untested = params.shadow.offset == ShadowOffset::no_depth_test,
               shows_shadows = params.shadow.enabled && !params.shadow.clip_to_receiver &&
                               (is_untested || (hides_next_frame(depth) && !rejects)),
               shows_images = reflection.after_objects && wants_nearer(depth);
    std::erase_if(problems, [&](const Problem& problem) {
        if (problem.kind == ProblemKind::worth_knowing) return false;
        if (shows_last && (problem.group == "projection" || problem.id == "shadow.by_rows")) return false;
        if (problem.group == "reflection")
            return !shows_images && !(reflection.after_objects && problem.id == "reflection.covers_objects");
        if (reflection.enabled && !rejects && (problem.id == "shadow.shared_stencil" || problem.id == "shadow.by_rows"))
            return false;
        return !shows_shadows;
    });
}

bool has_problem(const std::vector<Problem>& problems, std::string_view id) {
    return std::any_of(problems.begin(), problems.end(), [id](const Problem& problem) { return problem.id == id; });
}

/// Removes the fixes that may change nothing until another problem is fixed:
/// - of images, while planes that share a stencil value are drawn over each other, while the mirror's own depth of this
///   or the previous frame hides the images, or while far cuts them off;
/// - of clipping at a mirror, while the last fragment drawn wins, so that the mirror covers whatever is in front of it;
/// - of shadows, while an offset pushes them behind their planes, or a wrong R or S misplaces them;
/// - of everything else, while the depth test rejects what was drawn in the previous frame. The sentence about clearing
///   then keeps its fix or, with GL_NOTEQUAL, the sentence about GL_NOTEQUAL does.
void drop_waiting_fixes(std::vector<Problem>& problems, const Params& params) {
    const DepthParams& depth = params.depth;
    const bool tests = uses_gl_depth_test(params.visibility.method),
               is_overdrawn = has_problem(problems, "reflection.shared_stencil"),
               is_pushed =
                   has_problem(problems, "shadow.pushed_away") || has_problem(problems, "depth.reversed_offset"),
               is_misplaced = has_problem(problems, "reflection.by_rows") ||
                              has_problem(problems, "reflection.plus_2ab") ||
                              has_problem(problems, "reflection.normal_not_unit"),
               is_by_rows = has_problem(problems, "shadow.by_rows"),
               is_masked = has_problem(problems, "reflection.hides_image"),
               is_beyond_far = has_problem(problems, "view.image_beyond_far"),
               is_hidden =
                   lets_nearer_win(params) && depth.write && !clears_depth(depth) && !params.reflection.after_objects,
               is_painted = tests && count_of_last_wins(depth) > 0,
               is_rejected = tests && (rejects_previous_frame(depth) || hides_next_frame(depth));
    const auto waits = [&](const Problem& problem) {
        const bool is_about_clearing = problem.id == "depth.not_cleared" || problem.id == "depth.cleared_with_mask_off";
        if (is_about_clearing) return tests && depth.func == CompareFunc::notequal;
        if (is_rejected && problem.id != "depth.notequal") return true;
        if (tests && rejects_all(depth) && (problem.id == "shadow.by_rows" || problem.id == "shadow.shared_stencil"))
            return true;
        if (is_pushed && problem.id != "shadow.pushed_away" && problem.id != "shadow.beyond_edge" &&
            (problem.group == "shadow" || problem.id == "reflection.no_shadows_inside"))
            return true;
        if (is_painted && problem.fixed_by.starts_with("reflection.clip=")) return true;
        if (is_by_rows && problem.id != "shadow.by_rows" &&
            (problem.group == "shadow" || problem.id == "reflection.no_shadows_inside"))
            return true;
        if (is_beyond_far && problem.group == "reflection") return true;
        if (is_misplaced && problem.id == "reflection.wrong_side") return true;
        if (is_masked && problem.group == "reflection" && problem.id != "reflection.hides_image") return true;
        if ((is_misplaced || has_problem(problems, "shadow.fights")) && problem.id == "reflection.no_shadows_inside")
            return true;
        if (is_pushed && problem.fixed_by.starts_with("depth.offset=")) return true;
        return (is_overdrawn || is_hidden) && problem.group == "reflection" &&
               problem.id != "reflection.shared_stencil";
    };
    for (Problem& problem : problems)
        if (waits(problem)) problem.fixed_by.clear();
}

/// Removes the fixes that have no effect while V or P is entered by hand: the sentence about that matrix has the fix.
void drop_idle_fixes(std::vector<Problem>& problems, const CameraOverrides& by_hand) {
    for (Problem& problem : problems)
        if ((by_hand.view_from_world && problem.fixed_by.starts_with("camera")) ||
            (by_hand.clip_from_view && problem.fixed_by.starts_with("projection")))
            problem.fixed_by.clear();
}

}  // namespace

std::vector<Problem> find_problems(const Params& entered, const Derived& derived, const Scene& scene,
                                   const FramePlan& frame) {
    std::vector<Problem> problems;
    const CameraOverrides& by_hand = entered.camera_overrides;
    std::optional<Params> seen;
    if (by_hand.clip_from_view) seen = entered.with_projection_by_hand();
    const Params& params = seen ? *seen : entered;
    const std::vector<SeenImage> images =
        derived.has_distances ? seen_images(params, derived, scene, frame) : std::vector<SeenImage>();
    if (derived.has_distances) find_view_problems(problems, params, derived, scene, images);
    find_camera_by_hand_problems(problems, entered, derived);
    find_slips(problems, params, derived, scene);
    if (derived.has_distances)
        find_projection_problems(problems, params, derived, scene, by_hand.clip_from_view.has_value());
    find_light_problems(problems, params, derived, scene);
    find_plane_problems(problems, params, derived);
    find_shadow_problems(problems, params, derived, scene, frame);
    find_mirror_problems(problems, params, derived, scene, frame, images);
    find_by_hand_problems(problems, params, derived);
    if (hides_objects(params, derived, scene))
        drop_unseen(problems, params, derived);
    else if (derived.has_distances)
        find_cull_problems(problems, params, derived, scene, images);
    find_depth_problems(problems, params, derived, scene, frame, images);
    drop_idle_fixes(problems, by_hand);
    drop_waiting_fixes(problems, params);
    Sayer(problems, "follow")(params.follow && !derived.followed,
                              sentence("follow.no_vertex", "the followed vertex does not exist in this scene"));
    return problems;
}

}  // namespace viewing
