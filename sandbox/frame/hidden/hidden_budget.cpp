#include "frame/hidden/hidden_budget.h"

#include "text/catalogue.h"

namespace viewing {

Status check_hidden_budget(const Scene& scene, bool builds_tree) {
    const std::uint64_t count = scene.triangle_count();
    const std::uint64_t most = builds_tree ? most_bsp_polygons : most_hidden_polygons;
    if (count <= most) return std::monostate{};
    return Error{builds_tree ? say("The scene has {count} polygons, and a BSP tree is built of at most {most}: leave "
                                   "objects out, or take coarser meshes and teapots.",
                                   "count"_a = count, "most"_a = most)
                             : say("The scene has {count} polygons, and this method takes at most {most}: leave "
                                   "objects out, or take coarser meshes and teapots.",
                                   "count"_a = count, "most"_a = most)};
}

}  // namespace viewing
