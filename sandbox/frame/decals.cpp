#include "frame/decals.h"

#include <algorithm>

#include "frame/fighting.h"

namespace viewing {
namespace {

constexpr int first_mark = 3;  ///< 1 is the patch, 2 is where a shadow falls on it
constexpr int last_mark = 254;

}  // namespace

std::vector<int> decal_marks(const Scene& scene) {
    std::vector<int> marks(scene.objects.size(), 0);
    const auto is_decal = [&](int object) { return scene.objects[static_cast<std::size_t>(object)].description.decal; };
    if (std::ranges::none_of(scene.objects, [](const SceneObject& object) { return object.description.decal; }))
        return marks;
    int next = first_mark;
    for (const FlatPair& pair : near_coplanar_pairs(scene)) {
        if (is_decal(pair.first) == is_decal(pair.second)) continue;
        int& decal = marks[static_cast<std::size_t>(is_decal(pair.first) ? pair.first : pair.second)];
        int& base = marks[static_cast<std::size_t>(is_decal(pair.first) ? pair.second : pair.first)];
        if (decal != 0) continue;
        if (base == 0) base = next == last_mark ? first_mark : next++;
        decal = base;
    }
    return marks;
}

}  // namespace viewing
