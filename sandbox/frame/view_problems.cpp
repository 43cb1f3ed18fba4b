// Reports objects that the picture does not show, or shows only in part, and says where they are or what cuts them off.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "frame/box_tree.h"
#include "frame/object_reach.h"
#include "frame/say.h"
#include "text/words.h"
#include "topics/depth/numbers/near_advice.h"

namespace viewing {
namespace {

/// The group of these problems, which are shown only over the picture: in the panel, the sentence would come and go and
/// thereby move the control being dragged.
constexpr std::string_view group = "view";

/// Returns the corners of the objects' bounds, in view space.
std::array<glm::dvec3, 8> corners_view(const Bounds& bounds, const Derived& derived) {
    std::array<glm::dvec3, 8> corners{};
    for (std::size_t corner = 0; corner < 8; ++corner)
        corners[corner] = derived.view_from_world * glm::dvec4(corner & 1U ? bounds.max.x : bounds.min.x,
                                                               corner & 2U ? bounds.max.y : bounds.min.y,
                                                               corner & 4U ? bounds.max.z : bounds.min.z, 1.0);
    return corners;
}

/// Returns a sentence that says on which side of the view the objects are.
Sentence beside_the_view(const Params& params, const Derived& derived, const Scene& scene) {
    const std::array<glm::dvec3, 8> corners = corners_view(scene.bounds_world, derived);
    if (std::all_of(corners.begin(), corners.end(), [](const glm::dvec3& corner) { return corner.z >= 0.0; }))
        return sentence("view.objects_outside",
                        "every object is behind the camera: G frames them all, Home returns to the start");
    Lens lens = params.lens();
    lens.fovy_deg = std::abs(lens.fovy_deg);
    const auto [left, right, bottom, top] = lens.edges_at(1.0, derived.aspect);
    const glm::dvec2 low(left, bottom), high(right, top);
    const auto beyond = [&](int axis, double sign) {
        return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
            const double scale = lens.orthographic ? 1.0 : -corner.z;
            return sign > 0.0 ? corner[axis] > high[axis] * scale : corner[axis] < low[axis] * scale;
        });
    };
    return beyond(0, -1.0)
               ? sentence(
                     "view.objects_outside",
                     "every object is past the left edge of the view: G frames them all, Home returns to the start")
           : beyond(0, 1.0)
               ? sentence(
                     "view.objects_outside",
                     "every object is past the right edge of the view: G frames them all, Home returns to the start")
           : beyond(1, 1.0) ? sentence("view.objects_outside",
                                       "every object is above the view: G frames them all, Home returns to the start")
           : beyond(1, -1.0)
               ? sentence("view.objects_outside",
                          "every object is below the view: G frames them all, Home returns to the start")
               : sentence("view.objects_outside",
                          "every object is outside the view: G frames them all, Home returns to the start");
}

/// Returns the longest side of the box that holds all vertices but a few: along each axis, the lowest and the highest
/// fiftieth of them do not count. In model units; estimated from a few thousand vertices.
double size_of_most(const Mesh& mesh) {
    constexpr std::size_t judged = 4096, left_out = 50;
    const std::size_t step = std::max<std::size_t>(1, mesh.positions.size() / judged);
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> values;
        for (std::size_t i = 0; i < mesh.positions.size(); i += step) values.push_back(mesh.positions[i][axis]);
        const auto few = static_cast<std::ptrdiff_t>((values.size() + left_out - 1) / left_out);
        if (std::ssize(values) <= 2 * few) continue;
        const auto low = values.begin() + few, high = values.end() - 1 - few;
        std::nth_element(values.begin(), low, values.end());
        std::nth_element(low, high, values.end());
        longest = std::max(longest, static_cast<double>(*high - *low));
    }
    return longest;
}

/// If the box that holds most of a mesh's vertices is only a dot in the picture, returns how many times as large the
/// whole mesh is; otherwise 0.
double times_of_most(const SceneObject& object, const Params& params, const Derived& derived) {
    constexpr std::size_t most_vertices = 200'000;
    constexpr double dot = 1.0 / 100.0, apart = 100.0;
    const Mesh& mesh = *object.mesh;
    if (mesh.positions.size() > most_vertices) return 0.0;
    const Bounds bounds = vertex_tree(object.mesh)->bounds();
    const glm::dvec3 extent(bounds.size());
    const double whole = std::max({extent.x, extent.y, extent.z}), most = size_of_most(mesh);
    if (!(apart * most < whole)) return 0.0;
    double scale = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        scale = std::max(scale, glm::length(glm::dvec3(object.world_from_model[axis])));
    const glm::dvec4 center =
        derived.view_from_world * object.world_from_model * glm::dvec4(glm::dvec3(bounds.center()), 1.0);
    const Lens lens = params.lens();
    const bool is_dot = most * scale < dot * picture_height(lens, std::max(-center.z, lens.near));
    return is_dot ? whole / std::max(most, 1e-6 * whole) : 0.0;
}

/// Reports meshes from files that are in the view but invisible, or visible only as a dot.
void say_too_small(std::vector<Problem>& problems, const Params& params, const Derived& derived, const Scene& scene) {
    Sayer tell(problems, group);
    for (const SceneObject& object : scene.objects) {
        const Mesh& mesh = *object.mesh;
        if (object.description.shape != ShapeKind::mesh || mesh.positions.empty() ||
            !is_in_view(object, params, derived))
            continue;
        const Message name = object_message(object.description.name);
        if (const double times = times_of_most(object, params, derived); times > 1.0) {
            tell(true,
                 sentence("view.stray_vertices",
                          "{object} is {times} times as large as the box that holds nearly all of its vertices: a few "
                          "stray vertices shrink the rest to a dot",
                          "object"_a = name, "times"_a = figures(times, 2)));
            continue;
        }
        tell(is_too_thin(object, derived),
             sentence("view.too_thin",
                      "{object} spans less than 1/2000 of the picture's height: it is thinner than a pixel, so little "
                      "or nothing of it is drawn",
                      "object"_a = name));
    }
}

/// Reports the objects that near and far cut off, and the plane if it is cut off too: a plane alone may end anywhere.
/// `seen`: what is in view, regardless of near and far.
void say_cut(std::vector<Problem>& problems, const Params& params, const std::vector<SeenThing>& seen) {
    constexpr double rounding = 1e-6;
    const double near = params.projection.near, far = params.projection.far;
    std::vector<Message> before, beyond;
    double nearest = near, farthest = far;
    bool cuts_before = false, cuts_beyond = false;  // objects
    for (const SeenThing& thing : seen) {
        const Message name = thing.is_plane ? message("the plane") : object_message(thing.name);
        const bool is_before = thing.nearest - near < -rounding * std::abs(near);
        const bool is_beyond = thing.farthest > far * (1.0 + rounding);
        if (is_before) before.push_back(name);
        if (is_beyond) beyond.push_back(name);
        cuts_before |= is_before && !thing.is_plane;
        cuts_beyond |= is_beyond && !thing.is_plane;
        nearest = std::min(nearest, thing.nearest);
        farthest = std::max(farthest, thing.farthest);
    }
    Sayer tell(problems, group);
    const std::optional<double> nearer = largest_near(seen);
    tell.broken(
        cuts_before && nearer,
        sentence("view.near_cuts", "near = {near} cuts into {objects}: the nearest point is at eye distance {z}",
                 "near"_a = figures(near, 3), "objects"_a = enumerated(before), "z"_a = figures(nearest, 3)),
        nearer ? near_setting(params.projection, *nearer) : "");
    tell(cuts_before && !nearer,
         sentence("view.near_cuts", "near = {near} cuts into {objects}: no gap is left in front of the eye",
                  "near"_a = figures(near, 3), "objects"_a = enumerated(before)));
    tell.broken(cuts_beyond,
                sentence("view.far_cuts", "far = {far} cuts off {objects}: the farthest point is at eye distance {z}",
                         "far"_a = figures(far, 3), "objects"_a = enumerated(beyond), "z"_a = figures(farthest, 3)),
                "projection.far=" + plain_number(2.0 * rounded_down(farthest)));
}

/// Reports images that far cuts off: they are as far behind the mirror as their objects are in front of it.
void say_far(std::vector<Problem>& problems, const Params& params, const std::vector<SeenImage>& images) {
    std::vector<Message> names;
    double farthest = 0.0;
    for (const SeenImage& image : images) {
        if (!image.is_cut_off) continue;
        names.push_back(object_message(image.name));
        farthest = std::max(farthest, image.farthest);
    }
    // An R filled by rows changes w, so that far may cut off what is nearer.
    if (names.empty() || farthest <= params.projection.far || !shows_effects(params)) return;
    Sayer(problems, group)
        .broken(true,
                sentence("view.image_beyond_far",
                         "far = {far} cuts off the mirror image of {objects}, which reaches to eye distance {z}",
                         "far"_a = figures(params.projection.far, 3), "objects"_a = enumerated(names),
                         "z"_a = figures(farthest, 3)),
                "projection.far=" + plain_number(2.0 * rounded_down(farthest)));
}

}  // namespace

void find_view_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                        const Scene& scene, const std::vector<SeenImage>& images) {
    say_too_small(problems, params, derived, scene);
    if (scene.objects.empty()) return;
    Params unlimited = params;
    unlimited.projection.far = 1e12;
    std::vector<SeenThing> all = seen_things(unlimited, derived, scene), seen;  // seen: objects only
    std::copy_if(all.begin(), all.end(), std::back_inserter(seen), [](const SeenThing& one) { return !one.is_plane; });
    // A near plane that keeps a floor below the eye whole would cost precision.
    const double least_near_of_all = 0.1 * largest_near(seen).value_or(0.0);
    if (!(largest_near(all).value_or(0.0) > least_near_of_all)) all = seen;
    const auto is_there = [&](const SceneObject& object) { return is_in_view(object, params, derived); };
    if (std::any_of(scene.objects.begin(), scene.objects.end(), is_there)) {
        say_cut(problems, params, all);
        return say_far(problems, params, images);
    }
    if (seen.empty()) {
        Sayer(problems, group).window(images.empty(), beside_the_view(params, derived, scene));
        return say_far(problems, params, images);
    }

    const double near = params.projection.near, far = params.projection.far;
    const auto is_before = [near](const SeenThing& thing) { return thing.farthest < near; };
    const auto is_beyond = [far](const SeenThing& thing) { return thing.nearest > far; };
    const auto before = static_cast<std::size_t>(std::count_if(seen.begin(), seen.end(), is_before));
    const auto beyond = static_cast<std::size_t>(std::count_if(seen.begin(), seen.end(), is_beyond));
    if (before + beyond < seen.size()) {
        say_cut(problems, params, all);
        return say_far(problems, params, images);
    }
    double nearest = seen.front().nearest, farthest = seen.front().farthest;
    for (const SeenThing& thing : seen) {
        nearest = std::min(nearest, thing.nearest);
        farthest = std::max(farthest, thing.farthest);
    }
    constexpr double least_near = 1e-6;  // the field's minimum
    double gap = nearest;                // in front of the eye, up to an object or the plane
    for (const SeenThing& thing : all) gap = std::min(gap, thing.nearest);
    const double nearer = rounded_down(std::max(least_near, gap > 0.01 * farthest ? 0.9 * gap : 0.01 * farthest));
    const double farther = 2.0 * rounded_down(farthest);
    const std::string near_now = figures(near, 3), far_now = figures(far, 3);
    Sayer tell(problems, group);
    tell.broken(beyond == 0,
                sentence("view.before_near",
                         "every object in the view is closer than near = {near}: the farthest ends at eye distance {z}",
                         "near"_a = near_now, "z"_a = figures(farthest, 3)),
                near_setting(params.projection, nearer));
    tell.broken(before == 0,
                sentence("view.beyond_far",
                         "every object in the view is beyond far = {far}: the nearest starts at eye distance {z}",
                         "far"_a = far_now, "z"_a = figures(nearest, 3)),
                "projection.far=" + plain_number(farther));
    tell.broken(before > 0 && beyond > 0,
                sentence("view.before_near_or_beyond_far",
                         "every object in the view is closer than near = {near} or beyond far = {far}",
                         "near"_a = near_now, "far"_a = far_now));
}

}  // namespace viewing
