// Loads scenes: finds a scene's description and makes its meshes.
#include "state/scene.h"

#include <algorithm>
#include <cctype>
#include <glm/gtc/matrix_transform.hpp>
#include <unordered_set>

#include "platform/text_file.h"
#include "state/file/state_json.h"
#include "state/mesh/coplanar.h"
#include "state/mesh/mesh_cache.h"
#include "state/presets.h"
#include "text/words.h"

namespace viewing {

namespace {

namespace fs = std::filesystem;

/// A scene's description, the folder that its relative file names start from, and the words by which messages refer to
/// its objects ("room.json: objects"), which are empty if the scene is a single mesh file.
struct Described {
    SceneDescription scene;
    fs::path base;
    std::string objects;
    fs::path file = {};  ///< its own file; empty for an asset or an inline scene
};

/// Checks each file of a scene before it is read, and lists the files that were read.
class Gate {
public:
    explicit Gate(const SceneReading& reading) : reading_(reading), reach_(reading.reach) {}

    Status pass(const fs::path& file, const std::string& shown) {
        if (!seen_.insert(file.string()).second) return std::monostate{};
        if (!reach_.includes(file)) {
            if (reading_.outside != nullptr) *reading_.outside = resolved(file);
            return Error{shown + " is outside the state's folder; --allow-outside allows reading it"};
        }
        read_.push_back(resolved(file));
        return std::monostate{};
    }
    /// Permits reading the files in the folder of a scene's file.
    void open_folder_of(const fs::path& file) { reach_.add(file.has_parent_path() ? file.parent_path() : "."); }

    std::vector<fs::path> take_read() { return std::move(read_); }

private:
    const SceneReading& reading_;
    FileReach reach_;
    std::unordered_set<std::string> seen_;
    std::vector<fs::path> read_;
};

Result<Described> described_by_file(const fs::path& file, const std::string& shown, const std::string& origin) {
    const Result<std::string> text = read_text_file(file);
    if (!text) {
        return Error{origin + ": " + text.error()};
    }
    Result<SceneDescription> scene = parse_scene(*text, shown);
    if (!scene) {
        return Error{scene.error()};
    }
    return Described{std::move(*scene), file.parent_path(), shown + ": objects"};
}

Result<Described> described(const SceneSource& source, const fs::path& base, const SceneReading& reading, Gate& gate) {
    const std::string& origin = reading.origin;
    if (const auto* scene = std::get_if<SceneDescription>(&source)) {
        return Described{*scene, base, origin + ".objects"};
    }
    const auto& name = std::get<std::string>(source);
    const fs::path path(name);
    const bool is_name = !path.has_parent_path() && path.extension() != ".json" && !is_obj_file(path);
    std::error_code error;
    if (const fs::path assets = assets_directory(); is_name && !assets.empty()) {
        const fs::path known = assets / "scenes" / (name + ".json");
        if (fs::exists(known, error)) {
            return described_by_file(known, name + ".json", origin);
        }
    }
    const fs::path file = base / path;
    if (is_name && !fs::exists(file, error)) {
        return Error{origin + ": " + one_line(name) + " is neither a file nor a scene" + names_hint(name, scenes())};
    }
    if (const Status passed = gate.pass(file, name); !passed) {
        return Error{origin + ": " + passed.error()};
    }
    if (is_obj_file(file)) {
        return Described{scene_of_mesh(file, reading.progress), base, "", file};
    }
    Result<Described> scene = described_by_file(file, name, origin);
    if (scene) {
        scene->file = file;
        gate.open_folder_of(file);
    }
    return scene;
}

/// Returns how messages refer to an object's mesh file.
std::string place_of(const Described& from, std::size_t object, const std::string& origin) {
    return from.objects.empty() ? origin : from.objects + "[" + std::to_string(object) + "].file";
}

std::string too_many(std::uint64_t triangles) {
    return "the scene has " + std::to_string(triangles) + " triangles, but at most " +
           std::to_string(max_scene_triangles) + " are drawn: remove objects, or use coarser meshes and teapots";
}

}  // namespace

bool is_obj_file(const std::filesystem::path& file) {
    return in_lower_case(file.extension().string()) == ".obj";
}

const SceneObject* Scene::find(std::string_view name) const {
    const auto found = std::find_if(objects.begin(), objects.end(),
                                    [name](const SceneObject& object) { return object.description.name == name; });
    return found == objects.end() ? nullptr : &*found;
}

std::size_t Scene::triangle_count() const {
    std::size_t count = 0;
    for (const SceneObject& object : objects) count += object.mesh ? object.mesh->triangle_count() : 0;
    return count;
}

Result<Scene> load_scene(const SceneSource& source, const fs::path& base, const CoplanarParams& coplanar,
                         const SceneReading& reading) {
    if (const auto* name = std::get_if<std::string>(&source); name && !is_utf8(*name))
        return Error{one_line(*name) + ": the file name is not UTF-8, which states need; rename the file"};
    Gate gate(reading);
    Result<Described> from = described(source, base, reading, gate);
    if (!from) {
        return Error{from.error()};
    }
    Scene scene;
    scene.file = from->file;
    if (from->scene.made_by) {
        from->scene = coplanar_scene(coplanar);
        scene.made_from = coplanar;
    }
    std::uint64_t triangles = 0;
    const auto count = static_cast<double>(from->scene.objects.size());
    for (std::size_t i = 0; i < from->scene.objects.size(); ++i) {
        const ObjectDescription& object = from->scene.objects[i];
        const auto done = static_cast<double>(i);
        WorkProgress of_object{.whole = reading.progress, .begin = done / count, .end = (done + 1.0) / count};
        if (is_canceled(&of_object)) {
            return Error{reading.origin + ": loading was canceled"};
        }
        if (object.shape == ShapeKind::mesh) {
            if (const Status passed = gate.pass(from->base / object.file, object.file); !passed) {
                return Error{place_of(*from, i, reading.origin) + ": " + passed.error()};
            }
        }
        const Result<std::shared_ptr<const ObjMesh>> read = shared_mesh(object, from->base, &of_object);
        if (!read) {
            return Error{place_of(*from, i, reading.origin) + ": " + read.error()};
        }
        const auto& [mesh, origin, notes] = **read;
        triangles += mesh.triangle_count();
        const glm::dmat4 placed = world_from_model(object.position, object.rotation, object.scale);
        scene.objects.push_back({object, {*read, &mesh}, glm::translate(placed, origin)});
        for (const std::string& note : notes) scene.notes.push_back(place_of(*from, i, reading.origin) + ": " + note);
    }
    if (triangles > max_scene_triangles) {
        return Error{reading.origin + ": " + too_many(triangles)};
    }
    for (const SceneObject& object : scene.objects) {
        if (is_canceled(reading.progress)) {
            return Error{reading.origin + ": loading was canceled"};
        }
        for (const glm::vec3& position : object.mesh->positions) {
            scene.bounds_world.add(glm::dvec3(object.world_from_model * glm::dvec4(position, 1.0)));
        }
    }
    scene.read = gate.take_read();
    return scene;
}

SceneDescription scene_of_mesh(const fs::path& file, WorkProgress* progress) {
    std::error_code error;
    ObjectDescription object;
    object.name = file.stem().string();
    object.shape = ShapeKind::mesh;
    object.file = fs::absolute(file, error).string();
    object.color = {0xc9, 0xa2, 0x6b};

    double half_height = 1.0;
    if (const Result<std::shared_ptr<const ObjMesh>> read = shared_mesh(object, "", progress)) {
        half_height = bounds_of((*read)->mesh).size().y / 2.0;
    }
    object.position.y = half_height;
    return {{object}};
}

}  // namespace viewing
