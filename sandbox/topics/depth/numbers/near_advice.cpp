#include "topics/depth/numbers/near_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "frame/box_form.h"
#include "frame/box_tree.h"
#include "geometry/convex_part.h"
#include "text/message.h"
#include "topics/depth/numbers/depth_precision.h"

namespace viewing {
namespace {

constexpr double least_gain = 4.0;   // near is fine if a better one gains less than this factor
constexpr double margin = 0.9;       // fraction of the nearest distance, so that a small camera move clips nothing
constexpr double least_near = 1e-3;  // anything nearer counts as reaching the eye

/// A range of eye distances; empty until something is added.
struct Reach {
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -std::numeric_limits<double>::infinity();

    bool empty() const { return nearest > farthest; }
    void add(double distance) {
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
};

/// Returns, in view space, the sides of the view, the plane through the eye (or the near plane if near is negative),
/// and the far plane: p·(x, y, z, 1) ≥ 0 inside.
std::array<glm::dvec4, 6> sides_of(const Lens& lens, double aspect) {
    // A negative near, which only an orthographic view has, also shows what is behind the eye.
    const glm::dvec4 front(0.0, 0.0, -1.0, -std::min(lens.near, 0.0)), far(0.0, 0.0, 1.0, lens.far);
    Lens upright = lens;
    upright.fovy_deg = std::abs(lens.fovy_deg);
    const auto [left, right, bottom, top] = upright.edges_at(1.0, aspect);
    if (lens.orthographic)
        return {{{1, 0, 0, -left}, {-1, 0, 0, right}, {0, 1, 0, -bottom}, {0, -1, 0, top}, front, far}};
    return {{{1, 0, left, 0}, {-1, 0, -right, 0}, {0, 1, bottom, 0}, {0, -1, -top, 0}, front, far}};
}

/// Finds the range of eye distances of convex polygons inside the view.
class View {
public:
    View(const Params& params, const Derived& derived) : sides_(sides_of(params.lens(), derived.aspect)) {}

    /// Adds the eye distances of the part of a polygon, given in view space, that is inside the view.
    void add(std::span<const glm::dvec3> polygon_view, Reach& reach) {
        polygon_.assign(polygon_view.begin(), polygon_view.end());
        for (const glm::dvec4& side : sides_) {
            keep_part(polygon_, kept_,
                      [&side](const glm::dvec3& corner) { return glm::dot(side, glm::dvec4(corner, 1.0)); });
            if (polygon_.empty()) return;
        }
        for (const glm::dvec3& corner : polygon_) reach.add(-corner.z);
    }

    /// Returns the view's sides as forms over boxes in a model's space: a form is negative outside its side.
    std::vector<BoxForm> inwards(const glm::dmat4& view_from_model) const {
        std::vector<BoxForm> forms;
        for (const glm::dvec4& side : sides_) forms.emplace_back(side, view_from_model);
        return forms;
    }

private:
    std::array<glm::dvec4, 6> sides_;
    std::vector<glm::dvec3> polygon_, kept_;
};

/// Returns the range of an object. Clips only triangles that may extend it: the nearest first, then the farthest.
Reach reach_of(const SceneObject& object, const glm::dmat4& view_from_world, View& view) {
    const Mesh& mesh = *object.mesh;
    const glm::dmat4 view_from_model = view_from_world * object.world_from_model;
    const BoxForm distance({0.0, 0.0, -1.0, 0.0}, view_from_model);
    const std::vector<BoxForm> inwards = view.inwards(view_from_model);
    constexpr double out_of_view = std::numeric_limits<double>::infinity();
    const auto is_seen = [&](const Bounds& box) {
        return !(distance.greatest(box) <= 0.0) &&
               std::none_of(inwards.begin(), inwards.end(),
                            [&](const BoxForm& side) { return side.greatest(box) < 0.0; });
    };
    const auto triangle_view = [&](std::uint32_t number) {
        std::array<glm::dvec3, 3> corners;
        for (std::size_t corner = 0; corner < 3; ++corner)
            corners[corner] =
                view_from_model * glm::dvec4(mesh.positions[mesh.indices[3 * std::size_t{number} + corner]], 1.0);
        return corners;
    };
    Reach reach;
    const std::shared_ptr<const BoxTree> triangles = triangle_tree(object.mesh);
    triangles->least_first([&](const Bounds& box) { return is_seen(box) ? distance.least(box) : out_of_view; },
                           [&] { return reach.nearest; },
                           [&](std::uint32_t number) {
                               const std::array<glm::dvec3, 3> corners = triangle_view(number);
                               const double nearest = -std::max({corners[0].z, corners[1].z, corners[2].z});
                               if (nearest < reach.nearest) view.add(corners, reach);
                           });
    triangles->least_first([&](const Bounds& box) { return is_seen(box) ? -distance.greatest(box) : out_of_view; },
                           [&] { return -reach.farthest; },
                           [&](std::uint32_t number) {
                               const std::array<glm::dvec3, 3> corners = triangle_view(number);
                               const double farthest = -std::min({corners[0].z, corners[1].z, corners[2].z});
                               if (farthest > reach.farthest) view.add(corners, reach);
                           });
    return reach;
}

Reach reach_of(const PlanePatch& patch, const glm::dmat4& view_from_world, View& view) {
    std::vector<glm::dvec3> corners_view;
    for (const glm::dvec3& corner : patch.corners())
        corners_view.emplace_back(view_from_world * glm::dvec4(corner, 1.0));
    Reach reach;
    view.add(corners_view, reach);
    return reach;
}

struct Change {
    /// The smallest gap that depth reliably resolves at `z`, with the current and with the proposed near.
    double now = 0.0, then = 0.0;
    double z = 0.0;
};

Change change_of(const Params& params, const Derived& derived, double near, double z) {
    DepthCoding coding = depth_coding(params, derived);
    Change change{.now = fighting_onset(coding, z).gap(), .z = z};
    coding.lens.near = near;
    change.then = fighting_onset(coding, z).gap();
    return change;
}

NearAdvice advice_where_cut(const Params& params, const Derived& derived, const SeenThing& nearest, double z,
                            std::optional<double> better) {
    const std::string near_now = figures(params.projection.near, 3);
    if (!better)
        return {
            true, std::nullopt,
            message(
                "near = {near} cuts into {object}, which reaches the eye or goes past it: no near plane would keep it "
                "whole.",
                "near"_a = near_now, "object"_a = object_message(nearest.name))};
    const double near = *better;
    const Change change = change_of(params, derived, near, z);
    const bool is_finer = change.then < change.now;
    const double factor = is_finer ? change.now / change.then : change.then / change.now;
    const char* const sentence =
        is_finer
            ? marked(
                  "near = {near} cuts into {object}, whose nearest point is at {nearest}: near = {better} would keep "
                  "it whole, and the safe gap at z = {z} would be {then} instead of {now}, {factor} times smaller.")
            : marked(
                  "near = {near} cuts into {object}, whose nearest point is at {nearest}: near = {better} would keep "
                  "it whole, but the safe gap at z = {z} would be {then} instead of {now}, {factor} times larger.");
    return {
        true, near,
        message(fmt::runtime(sentence), "near"_a = near_now, "object"_a = object_message(nearest.name),
                "nearest"_a = figures(rounded_down(nearest.nearest)), "better"_a = figures(near), "z"_a = figures(z),
                "then"_a = figures(change.then), "now"_a = figures(change.now), "factor"_a = figures(factor))};
}

const SeenThing& nearest_of(const std::vector<SeenThing>& seen) {
    return *std::min_element(seen.begin(), seen.end(),
                             [](const SeenThing& a, const SeenThing& b) { return a.nearest < b.nearest; });
}

}  // namespace

std::optional<double> largest_near(const std::vector<SeenThing>& seen) {
    if (seen.empty() || !(nearest_of(seen).nearest > 0.0)) return std::nullopt;
    const double near = rounded_down(margin * nearest_of(seen).nearest);
    return near < least_near ? std::nullopt : std::optional(near);
}

double rounded_down(double value) {
    const double unit = std::floor(std::log10(value)) - 1.0;
    const double digits = std::floor(value * std::pow(10.0, -unit) * (1.0 + 1e-12));
    return unit < 0.0 ? digits / std::round(std::pow(10.0, -unit)) : digits * std::pow(10.0, unit);
}

std::vector<SeenThing> seen_things(const Params& params, const Derived& derived, const Scene& scene) {
    View view(params, derived);
    std::vector<SeenThing> seen;
    const auto take = [&seen](const std::string& name, const Reach& reach, bool is_plane) {
        if (!reach.empty()) seen.push_back({name, std::max(reach.nearest, 0.0), reach.farthest, is_plane});
    };
    for (const SceneObject& object : scene.objects)
        take(object.description.name, reach_of(object, derived.view_from_world, view), false);
    take("the plane", reach_of(derived.planes.front().patch, derived.view_from_world, view), true);
    return seen;
}

std::vector<DistanceMark> distance_marks(const std::vector<SeenThing>& seen, std::size_t most) {
    constexpr double told_apart = 1.02;  // things whose distances have a smaller ratio share a mark
    std::vector<const SeenThing*> things;
    for (const SeenThing& thing : seen)
        if (thing.nearest > 0.0) things.push_back(&thing);
    std::stable_sort(things.begin(), things.end(),
                     [](const SeenThing* a, const SeenThing* b) { return a->nearest < b->nearest; });

    struct Group {
        const SeenThing* first;
        std::size_t count;
    };
    std::vector<Group> groups;
    for (const SeenThing* thing : things) {
        if (!groups.empty() && thing->nearest < told_apart * groups.back().first->nearest)
            ++groups.back().count;
        else
            groups.push_back({thing, 1});
    }
    while (groups.size() > std::max<std::size_t>(most, 1)) {
        const auto ratio = [&groups](std::size_t i) { return groups[i + 1].first->nearest / groups[i].first->nearest; };
        std::size_t closest = 0;
        for (std::size_t i = 1; i + 1 < groups.size(); ++i)
            if (ratio(i) < ratio(closest)) closest = i;
        groups[closest].count += groups[closest + 1].count;
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(closest) + 1);
    }

    std::vector<DistanceMark> marks;
    for (const Group& group : groups) {
        const SeenThing& first = *group.first;
        Message label = first.is_plane ? message("the plane") : object_message(first.name);
        if (group.count > 1) label = listed({label, verbatim("+" + std::to_string(group.count - 1))}, " ");
        marks.push_back({label, first.nearest, first.is_plane});
    }
    return marks;
}

std::optional<NearAdvice> near_advice(const Params& params, const Derived& derived,
                                      const std::vector<SeenThing>& seen) {
    if (params.projection.is_orthographic() || seen.empty()) return std::nullopt;
    const SeenThing& nearest = nearest_of(seen);
    const double z = std::max_element(seen.begin(), seen.end(), [](const SeenThing& a, const SeenThing& b) {
                         return a.farthest < b.farthest;
                     })->farthest;
    const std::optional<double> better = largest_near(seen);
    if (nearest.nearest < params.projection.near) return advice_where_cut(params, derived, nearest, z, better);
    const double near = better.value_or(params.projection.near);
    if (near <= params.projection.near || params.depth.mapping == DepthMapping::logarithmic) return std::nullopt;
    const Change change = change_of(params, derived, near, z);
    if (!(change.now >= least_gain * change.then)) return std::nullopt;
    return NearAdvice{false, near,
                      message("Nothing is nearer than {nearest}: with near = {near}, the safe gap at z = {z} would be "
                              "{then} instead of {now}, {factor} times smaller.",
                              "nearest"_a = figures(rounded_down(nearest.nearest)), "near"_a = figures(near),
                              "z"_a = figures(change.z), "then"_a = figures(change.then), "now"_a = figures(change.now),
                              "factor"_a = figures(change.now / change.then))};
}

std::optional<NearAdvice> near_advice(const Params& params, const Derived& derived, const Scene& scene) {
    return near_advice(params, derived, seen_things(params, derived, scene));
}

}  // namespace viewing
