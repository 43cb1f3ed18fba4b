// A scene as the rest of the program sees it: its description with the meshes made or loaded.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "platform/progress.h"
#include "state/file_reach.h"
#include "state/params.h"
#include "text/result.h"

namespace viewing {

struct SceneObject {
    ObjectDescription description;
    std::shared_ptr<const Mesh> mesh;  ///< shared between scenes that hold the same shape or file
    glm::dmat4 world_from_model{1.0};
};

struct Scene {
    std::vector<SceneObject> objects;
    Bounds bounds_world;
    std::optional<CoplanarParams> made_from = {};  ///< what the formula took that made the objects, if one did
    std::filesystem::path file = {};  ///< that it was read from, where that is no asset and not the state itself
    std::vector<std::filesystem::path> read = {};  ///< resolved: all files that were read for it
    std::vector<std::string> notes = {};           ///< of its mesh files, with the places that errors name

    const SceneObject* find(std::string_view name) const;
    /// Of all its objects.
    std::size_t triangle_count() const;
};

/// Where presets and scenes live: $VIEWING_SANDBOX_ASSETS, else `assets` beside the program, else
/// ../share/viewing-sandbox below it. Empty when there is none.
std::filesystem::path assets_directory();

/// What is wrong with it: it is not there, or has no presets, scenes, lessons or exercises; "" where all is well. Says
/// so where the environment variable is at fault.
std::string assets_problem();

/// How a scene is read. `origin`: what messages about the source itself open with.
struct SceneReading {
    WorkProgress* progress = nullptr;
    std::string origin = "scene";
    FileReach reach = {};
    std::filesystem::path* outside = nullptr;  ///< takes the first file that is needed and is not within reach
};

/// Makes or loads every mesh. Relative mesh files are looked up from `base` (the directory of the file that
/// named the scene; empty: the working directory). A named scene comes from assets/scenes; a path is that of a scene
/// file, or of an OBJ file, which is then shown by itself. The same shape or file is shared between scenes. Safe to
/// call from several threads. Errors name the scene's file and the field: "room.json: objects[3].file: chair.obj: …";
/// what is wrong with `source` itself opens with `origin`: "mine.json: scene: …", "mine.json: scene.objects[3].file:
/// …". `coplanar`: the parameters of a scene that its file says is made by a formula. A file that is not within reach
/// is not touched and is an error; the folder of a scene's own file, which was within reach, is so too. More than
/// max_scene_triangles are refused; objects that share a mesh share its memory.
Result<Scene> load_scene(const SceneSource& source, const std::filesystem::path& base,
                         const CoplanarParams& coplanar = {}, const SceneReading& reading = {});

/// Of all objects together.
inline constexpr std::uint64_t max_scene_triangles = 50'000'000;

/// A mesh as a file has it.
struct ObjMesh {
    Mesh mesh;
    glm::dvec3 origin{0.0};          ///< where the mesh's origin lies in the coordinates of the object
    std::vector<std::string> notes;  ///< what was left out or replaced: "bunny.obj: line 3: …"
};

/// A Wavefront OBJ file, centred in double precision and with `fit` scaled so that its longest side is 2; without it
/// the mesh is centred too, but its origin says where. Polygons are cut into triangles: one that is not concave into a
/// fan about its first corner. Corners keep the file's normals; others get one made from the faces: smooth within a
/// smoothing group, flat after "s off", and without any "s" smooth up to the crease angle. At most 50 million triangles
/// and 4 GiB. Materials are ignored.
Result<ObjMesh> load_obj(const std::filesystem::path& file, const MeshReading& reading = {},
                         WorkProgress* progress = nullptr);

/// Whether a name says that it is a Wavefront file: ".obj" in capitals or not.
bool is_obj_file(const std::filesystem::path& file);

/// The scene that shows one mesh file, standing on the plane y = 0. Reads the file to know how high it is, and keeps
/// what it read, so that load_scene() is quick afterwards. A broken file gives a scene all the same: load_scene() then
/// says what is wrong with it.
SceneDescription scene_of_mesh(const std::filesystem::path& file, WorkProgress* progress = nullptr);

}  // namespace viewing
