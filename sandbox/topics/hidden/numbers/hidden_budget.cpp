#include "topics/hidden/numbers/hidden_budget.h"

#include "text/numbers.h"

namespace viewing {

Message beyond_hidden_budget(const Scene& scene, bool builds_tree) {
    const auto count = static_cast<std::int64_t>(scene.triangle_count());
    const std::int64_t most = builds_tree ? most_bsp_polygons : most_hidden_polygons;
    if (count <= most) return {};
    const std::string polygons = grouped_number(count), limit = grouped_number(most);
    return builds_tree ? message(
                             "The scene has {count} polygons, but a BSP tree is limited to {most}: remove "
                             "objects, or use coarser meshes and teapots.",
                             "count"_a = polygons, "most"_a = limit)
                       : message(
                             "The scene has {count} polygons, but this method is limited to {most}: remove "
                             "objects, or use coarser meshes and teapots.",
                             "count"_a = polygons, "most"_a = limit);
}

}  // namespace viewing
