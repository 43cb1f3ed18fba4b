#include "topics/depth/numbers/decals.h"

#include <algorithm>

#include "topics/depth/numbers/fighting.h"

namespace viewing {
namespace {

constexpr int first_mark = 3;
constexpr int mark_count = 252;

}  // namespace

bool has_decals(const Scene& scene) {
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [](const SceneObject& object) { return object.description.decal; });
}

std::vector<int> decal_marks(const Scene& scene) {
    std::vector<int> marks(scene.objects.size(), 0);
    if (!has_decals(scene)) return marks;
    const auto is_decal = [&](int object) { return scene.objects[object].description.decal; };
    int bases = 0;
    for (const FlatPair& pair : near_coplanar_pairs(scene)) {
        if (is_decal(pair.first) == is_decal(pair.second)) continue;
        int& decal = marks[is_decal(pair.first) ? pair.first : pair.second];
        int& base = marks[is_decal(pair.first) ? pair.second : pair.first];
        if (decal != 0) continue;
        if (base == 0) base = first_mark + bases++ % mark_count;
        decal = base;
    }
    return marks;
}

}  // namespace viewing
