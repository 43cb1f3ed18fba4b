#include "report/order_report.h"

#include "frame/hidden/hidden_budget.h"
#include "frame/hidden/hidden_surfaces.h"
#include "report/as_json.h"
#include "state/fields.h"
#include "visibility/bsp.h"
#include "visibility/culling.h"
#include "visibility/hiding.h"
#include "visibility/painter.h"

namespace viewing {
namespace {

constexpr std::size_t most_polygons = 20'000;

/// `name` of an index in the order's own numbers.
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

}  // namespace

Result<Json> order_as_json(const Params& params, const Scene& scene, glm::ivec2 size_px) {
    if (const Status affordable = check_hidden_budget(scene, false); !affordable) return Error{affordable.error()};
    const SceneSurface surface = surface_of(scene);
    const Viewpoint viewpoint = hidden_request(params, derive(params, scene, Viewport{size_px}), size_px).viewpoint;
    const std::vector<Polygon> polygons =
        params.cull.enabled ? culled(surface.polygons, viewpoint, params.cull.face, params.cull.front_face)
                            : surface.polygons;
    if (polygons.size() > most_polygons)
        return Error{std::to_string(polygons.size()) +
                     " polygons are too many to compare each with every other one: at most " +
                     std::to_string(most_polygons)};

    const std::vector<HidingPair> pairs =
        hiding_pairs(polygons, viewpoint, params.visibility.epsilon * surface.diagonal);
    std::vector<int> object_of;
    for (const Polygon& polygon : polygons) object_of.push_back(polygon.object);
    const auto object = [&](int index) { return scene.objects[static_cast<std::size_t>(index)].description.name; };
    const auto number = [&](int index) { return polygons[static_cast<std::size_t>(index)].source; };

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
    if (const Status affordable = check_hidden_budget(scene, true); !affordable) return Error{affordable.error()};
    const SceneSurface surface = surface_of(scene);
    const BspTree tree = build_bsp(surface.polygons, {.splitter = params.visibility.splitter,
                                                      .epsilon = params.visibility.epsilon * surface.diagonal});
    if (!tree.problem.empty()) return Error{tree.problem};
    const Viewpoint viewpoint = hidden_request(params, derive(params, scene, Viewport{size_px}), size_px).viewpoint;
    Json order = Json::array();
    for (const BspVisit& visit : walk_bsp(tree, viewpoint.eye_world(), BspOrder::back_to_front).visits)
        order.push_back(visit.node + 1);
    return Json{{"count", tree.nodes.size()}, {"order", std::move(order)}};
}

}  // namespace viewing
