#include "topics/hidden/measured/order_report.h"

#include "report/as_json.h"
#include "state/fields.h"
#include "text/per_enum.h"
#include "topics/hidden/methods/bsp.h"
#include "topics/hidden/methods/culling.h"
#include "topics/hidden/methods/hiding.h"
#include "topics/hidden/methods/painter.h"
#include "topics/hidden/methods/projected.h"
#include "topics/hidden/numbers/hidden_budget.h"
#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {
namespace {

constexpr std::size_t most_polygons = 20'000, most_pairs = 1'000'000;

/// `name` converts an index to the entry in the report: a polygon's number or an object's name.
template <typename Name>
Json list_of(std::span<const int> indices, const Name& name) {
    Json list = Json::array();
    for (const int index : indices) list.push_back(name(index));
    return list;
}

template <typename Name>
Json order_of(int count, std::span<const HidingPair> pairs, const Name& name) {
    Json list = Json::array();
    for (const auto& [before, after] : pairs) list.push_back({name(before), name(after)});
    const WholeOrder found = whole_order(count, pairs);
    const bool exists = found.cycle.empty();
    return {{"count", count},
            {"pairs", std::move(list)},
            {"exists", exists},
            {"order", exists ? list_of(found.order, name) : Json()},
            {"cycle", exists ? Json() : list_of(found.cycle, name)}};
}

constexpr auto newell_tests =
    per_enum<NewellTest>("depth_extents", "x_extents", "y_extents", "p_behind_q", "q_in_front_of_p",
                         "projections_disjoint", "q_behind_p", "p_in_front_of_q", "none");
static_assert(std::size(newell_tests) == newell_test_count);
constexpr auto newell_actions = per_enum<NewellAction>("goes_on", "swaps", "splits", "draws", "forces");

Json extent_of(const Polygon& polygon, const Viewpoint& viewpoint) {
    const Projected seen = project(polygon, viewpoint, viewpoint.clip_from_world());
    return {{"left", seen.min.x}, {"right", seen.max.x},     {"bottom", seen.min.y},
            {"top", seen.max.y},  {"nearest", seen.nearest}, {"farthest", seen.farthest}};
}

}  // namespace

Result<Json> order_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px) {
    if (const Message why = beyond_hidden_budget(scene, false); !why.empty()) return Error{say(why)};
    const SceneSurface surface = surface_of(scene);
    const Viewpoint viewpoint = hidden_request(params, derive(params, scene, Viewport{size_px}), size_px).viewpoint;
    const std::vector<Polygon> polygons =
        params.cull.enabled ? culled(surface.polygons, viewpoint, params.cull.face, params.cull.front_face)
                            : surface.polygons;
    if (polygons.size() > most_polygons)
        return Error{std::to_string(polygons.size()) + " polygons are too many to compare in pairs: at most " +
                     std::to_string(most_polygons)};

    const std::vector<HidingPair> pairs =
        hiding_pairs(polygons, viewpoint, params.visibility.epsilon * surface.diagonal, most_pairs);
    if (pairs.size() > most_pairs)
        return Error{"more than a million pairs of the " + std::to_string(polygons.size()) +
                     " polygons hide each other: too many to list"};
    std::vector<int> object_of;
    for (const Polygon& polygon : polygons) object_of.push_back(polygon.object);
    const auto object = [&](int index) { return scene.objects[index].description.name; };
    const auto number = [&](int index) { return polygons[index].source; };

    Json of_polygons = order_of(static_cast<int>(polygons.size()), pairs, number);
    of_polygons["object"] = list_of(object_of, object);
    Json keys = Json::object();
    const std::span<const char* const> names = names_of<PainterKey>();
    for (std::size_t key = 0; key < names.size(); ++key)
        keys[names[key]] = wrong_pairs(pairs, painter_order(polygons, viewpoint, static_cast<PainterKey>(key)).order);
    of_polygons["painter_keys"] = std::move(keys);
    return Json{{"scene", scene_name(params)},
                {"size", as_json(size_px)},
                {"objects", order_of(static_cast<int>(scene.objects.size()), grouped(pairs, object_of), object)},
                {"polygons", std::move(of_polygons)}};
}

Result<Json> bsp_order_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px) {
    if (const Message why = beyond_hidden_budget(scene, true); !why.empty()) return Error{say(why)};
    const SceneSurface surface = surface_of(scene);
    const BspTree tree = build_bsp(surface.polygons, {.splitter = params.visibility.splitter,
                                                      .epsilon = params.visibility.epsilon * surface.diagonal});
    if (!tree.problem.empty()) return Error{say(tree.problem)};
    const Viewpoint viewpoint = hidden_request(params, derive(params, scene, Viewport{size_px}), size_px).viewpoint;
    Json order = Json::array();
    for (const BspVisit& visit : walk_bsp(tree, viewpoint.eye_world(), BspOrder::back_to_front).visits)
        order.push_back(visit.node + 1);
    return Json{{"count", tree.nodes.size()}, {"order", std::move(order)}};
}

Result<Json> newell_step_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px) {
    if (const Message why = beyond_hidden_budget(scene, true); !why.empty()) return Error{say(why)};
    Params by_newell = params;
    by_newell.visibility.method = VisibilityMethod::newell;
    const HiddenRequest request = hidden_request(by_newell, derive(params, scene, Viewport{size_px}), size_px);
    const std::shared_ptr<const NewellOrder> newell = HiddenSurfaceSolver(scene).solve(request)->newell;
    if (newell->steps.empty()) return Error{"there are no polygons to compare"};
    const auto count = static_cast<int>(newell->steps.size());
    const int step = params.visibility.step < 0 ? count : params.visibility.step;
    if (step == 0 || step > count) return Error{"no such step: the steps are 1 to " + std::to_string(count)};
    const NewellStep& reached = newell->steps[static_cast<std::size_t>(step) - 1];
    const auto extent = [&](int fragment) {
        return fragment < 0 ? Json() : extent_of(newell->fragments[fragment], request.viewpoint);
    };
    return Json{{"test", newell_tests[reached.decided_by]},
                {"action", newell_actions[reached.action]},
                {"a", extent(reached.p)},
                {"b", extent(reached.q)}};
}

}  // namespace viewing
