#include "app/stand_ins.h"

#include <algorithm>
#include <map>

#include "geometry/simplify.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

constexpr std::size_t large = 150'000, most_of_stand_in = 30'000;  // triangles

bool is_large(const SceneObject& object) {
    return object.mesh->triangle_count() > large;
}

}  // namespace

Scene with_stand_ins(const Scene& scene) {
    Scene coarse = scene;
    std::map<const Mesh*, std::shared_ptr<const Mesh>> made;  // objects share meshes
    for (SceneObject& object : coarse.objects) {
        if (!is_large(object)) continue;
        std::shared_ptr<const Mesh>& stand_in = made[object.mesh.get()];
        if (!stand_in) stand_in = std::make_shared<const Mesh>(simplified_to(*object.mesh, most_of_stand_in));
        object.mesh = stand_in;
    }
    return coarse;
}

void StandIns::follow(const Scene& scene, int version) {
    if (auto made = task_.take(); made && *made) {
        scene_ = **std::move(made);
        sentence_ = say("simplified while moving: {drawn} of {all} triangles",
                        "drawn"_a = grouped_number(static_cast<std::int64_t>(scene_->triangle_count())),
                        "all"_a = grouped_number(static_cast<std::int64_t>(triangles_)));
    }
    if (version == version_) return;
    version_ = version;
    task_.drop();
    scene_.reset();
    was_slow_ = false;
    if (std::none_of(scene.objects.begin(), scene.objects.end(), is_large)) return;
    triangles_ = scene.triangle_count();
    task_.start([scene](WorkProgress&) -> Result<Scene> { return with_stand_ins(scene); });
}

const Scene* StandIns::choose(bool is_held, bool is_slow) {
    was_slow_ = was_slow_ || (is_held && is_slow);
    return is_held && was_slow_ && scene_ ? &*scene_ : nullptr;
}

}  // namespace viewing
