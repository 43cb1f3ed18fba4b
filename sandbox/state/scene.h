// A scene as the rest of the program sees it: its description, with its meshes made or loaded.
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
    std::shared_ptr<const Mesh> mesh;  ///< shared between scenes with the same shape or file
    glm::dmat4 world_from_model{1.0};
};

struct Scene {
    std::vector<SceneObject> objects;
    Bounds bounds_world;
    std::optional<CoplanarParams> made_from = {};  ///< the parameters of the formula that made the objects, if any
    std::filesystem::path file = {};               ///< its source, unless that is an asset or the state itself
    std::vector<std::filesystem::path> read = {};  ///< all files read for it, resolved
    std::vector<std::string> notes = {};           ///< about its mesh files; they name places as errors do

    const SceneObject* find(std::string_view name) const;
    /// Returns the number of triangles in all objects.
    std::size_t triangle_count() const;
};

/// Returns the directory of presets and scenes: $VIEWING_SANDBOX_ASSETS, else `assets` beside the program, else
/// ../share/viewing-sandbox relative to it. Empty if none of these exists.
std::filesystem::path assets_directory();

/// Describes the problem with the assets directory: it is missing, or has no presets, scenes, lessons or exercises; ""
/// if there is no problem. Names the environment variable if that is the cause.
std::string assets_problem();

/// Options for reading a scene. `origin` starts messages about the source itself.
struct SceneReading {
    WorkProgress* progress = nullptr;
    std::string origin = "scene";
    FileReach reach = {};
    std::filesystem::path* outside = nullptr;  ///< receives the first needed file that is out of reach
};

/// Makes or loads every mesh. Scenes share meshes of the same shape or file. Safe to call from several threads.
///
/// A name selects a scene in assets/scenes; a path leads to a scene file, or to an OBJ file, which is shown by itself.
/// Relative paths of mesh files start from `base` (the directory of the file that named the scene; if empty, the
/// working directory). `coplanar` holds the parameters of a scene that a formula makes.
///
/// A file out of reach is an error and is not touched; if a scene's own file is within reach, so is its folder. Refuses
/// more than max_scene_triangles; objects that share a mesh share its memory. Errors name the scene's file and the
/// field: "room.json: objects[3].file: chair.obj: …". Errors in `source` itself begin with `origin`: "mine.json: scene:
/// …", "mine.json: scene.objects[3].file: …".
Result<Scene> load_scene(const SceneSource& source, const std::filesystem::path& base,
                         const CoplanarParams& coplanar = {}, const SceneReading& reading = {});

/// The most triangles that all objects of a scene may have together.
inline constexpr std::uint64_t max_scene_triangles = 50'000'000;

/// A mesh read from a file.
struct ObjMesh {
    Mesh mesh;
    glm::dvec3 origin{0.0};          ///< the mesh's origin in the object's coordinates
    std::vector<std::string> notes;  ///< about skipped or replaced parts: "bunny.obj: line 3: …"
};

/// Loads a Wavefront OBJ file and centers it in double precision. With `fit`, its longest side becomes 2; without it,
/// `origin` says where the center was. Splits polygons into triangles; a polygon that is not concave becomes a fan
/// around its first corner. Corners keep the file's normals; the others get one computed from the faces: smooth within
/// a smoothing group, flat after "s off" and, in a file without any "s" line, smooth up to the crease angle. Refuses
/// more than 50 million triangles or 4 GiB. Ignores materials.
Result<ObjMesh> load_obj(const std::filesystem::path& file, const MeshReading& reading = {},
                         WorkProgress* progress = nullptr);

/// Whether a file name is that of a Wavefront file: it ends with ".obj", in upper or lower case.
bool is_obj_file(const std::filesystem::path& file);

/// Returns the scene that shows one mesh file, resting on the plane y = 0. Reads the file to find its height and caches
/// it, so that load_scene() is then fast. Even a broken file yields a scene; load_scene() then reports the error.
SceneDescription scene_of_mesh(const std::filesystem::path& file, WorkProgress* progress = nullptr);

}  // namespace viewing
