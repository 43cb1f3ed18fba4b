// Reports that the picture shows none of the scene's objects, and says where they are or what cuts them off.
#include <algorithm>
#include <array>
#include <cmath>

#include "frame/depth/near_advice.h"
#include "frame/object_reach.h"
#include "frame/say.h"

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
std::string beside_the_view(const Params& params, const Derived& derived, const Scene& scene) {
    const std::array<glm::dvec3, 8> corners = corners_view(scene.bounds_world, derived);
    if (std::all_of(corners.begin(), corners.end(), [](const glm::dvec3& corner) { return corner.z >= 0.0; }))
        return tr("every object is behind the camera: G frames them all, Home returns to the start");
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
    const char* const sentence =
        beyond(0, -1.0)
            ? marked("every object is past the left edge of the view: G frames them all, Home returns to the start")
        : beyond(0, 1.0)
            ? marked("every object is past the right edge of the view: G frames them all, Home returns to the start")
        : beyond(1, 1.0)  ? marked("every object is above the view: G frames them all, Home returns to the start")
        : beyond(1, -1.0) ? marked("every object is below the view: G frames them all, Home returns to the start")
                          : marked("every object is outside the view: G frames them all, Home returns to the start");
    return tr(sentence);
}

}  // namespace

void find_view_problems(std::vector<Problem>& problems, const Params& params, const Derived& derived,
                        const Scene& scene) {
    const auto is_there = [&](const SceneObject& object) { return is_in_view(object, params, derived); };
    if (scene.objects.empty() || std::any_of(scene.objects.begin(), scene.objects.end(), is_there)) return;
    Params unlimited = params;
    unlimited.projection.far = 1e12;
    std::vector<SeenThing> seen = seen_things(unlimited, derived, scene);
    std::erase_if(seen, [](const SeenThing& thing) { return thing.is_plane; });
    if (seen.empty()) return Sayer(problems, group).window(true, beside_the_view(params, derived, scene));

    const double near = params.projection.near, far = params.projection.far;
    const auto is_before = [near](const SeenThing& thing) { return thing.farthest < near; };
    const auto is_beyond = [far](const SeenThing& thing) { return thing.nearest > far; };
    const auto before = static_cast<std::size_t>(std::count_if(seen.begin(), seen.end(), is_before));
    const auto beyond = static_cast<std::size_t>(std::count_if(seen.begin(), seen.end(), is_beyond));
    if (before + beyond < seen.size()) return;
    double nearest = seen.front().nearest, farthest = seen.front().farthest;
    for (const SeenThing& thing : seen) {
        nearest = std::min(nearest, thing.nearest);
        farthest = std::max(farthest, thing.farthest);
    }
    constexpr double least_near = 1e-6;  // the field's minimum
    const double nearer =
        rounded_down(std::max(least_near, nearest > 0.01 * farthest ? 0.9 * nearest : 0.01 * farthest));
    const double farther = 2.0 * rounded_down(farthest);
    const std::string near_now = figures(near, 3), far_now = figures(far, 3);
    Sayer tell(problems, group);
    tell.broken(beyond == 0,
                say("every object in the view is closer than near = {near}: the farthest ends at z = {z}",
                    "near"_a = near_now, "z"_a = figures(farthest, 3)),
                "projection.near=" + plain_number(nearer));
    tell.broken(before == 0,
                say("every object in the view is beyond far = {far}: the nearest starts at z = {z}", "far"_a = far_now,
                    "z"_a = figures(nearest, 3)),
                "projection.far=" + plain_number(farther));
    tell.broken(before > 0 && beyond > 0,
                say("every object in the view is closer than near = {near} or beyond far = {far}", "near"_a = near_now,
                    "far"_a = far_now));
}

}  // namespace viewing
