// A scene as the rest of the program sees it: its description, together with the meshes made or loaded for it.
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
    std::filesystem::path file = {};               ///< its own file; empty for an asset or an inline scene
    std::vector<std::filesystem::path> read = {};  ///< the resolved paths of all files that were read for it
    std::vector<std::string> notes = {};  ///< about its mesh files; like an error, each begins with its location

    const SceneObject* find(std::string_view name) const;
    /// Returns the number of triangles in all objects.
    std::size_t triangle_count() const;
};

/// Returns the directory of presets and scenes: $VIEWING_SANDBOX_ASSETS if that is set; else `assets` beside the
/// program; else ../share/viewing-sandbox relative to the program's folder. Returns an empty path if there is no such
/// directory.
std::filesystem::path assets_directory();

/// Returns what is wrong with the assets directory: it is missing, or it contains no presets, scenes, lessons or
/// exercises. Returns "" if nothing is wrong. Names the environment variable if that is the cause.
std::string assets_problem();

/// Options for reading a scene. Messages about the source itself begin with `origin`.
struct SceneReading {
    WorkProgress* progress = nullptr;
    std::string origin = "scene";
    FileReach reach = {};
    std::filesystem::path* outside = nullptr;  ///< receives the first needed file that is out of reach
};

/// Loads a scene, and makes or loads its meshes. Scenes share meshes of the same shape or file. Safe to call from
/// several threads.
///
/// A name selects a scene in assets/scenes; a path names a scene file, or an OBJ file, which is shown by itself.
/// Relative paths in `source` start from `base` (the directory of the file that names the scene; if empty, the working
/// directory); those in a scene file start from that file's own directory. `coplanar` holds the parameters of a scene
/// that a formula makes.
///
/// A file out of reach is not read, and is an error; if a scene's own file is within reach, so is its folder. Refuses a
/// scene with more than max_scene_triangles triangles, even if its objects share a mesh and thus its memory. Errors
/// name the scene's file and the field: "room.json: objects[3].file: chair.obj: …". Errors in `source` itself begin
/// with `origin`: "mine.json: scene: …", "mine.json: scene.objects[3].file: …".
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
/// around its first corner. Corners keep the normals that the file gives them; the others get normals computed from the
/// faces. These are smooth within a smoothing group and flat after "s off"; in a file without any "s" line, they are
/// smooth up to the crease angle. Refuses a file of more than 50 million triangles or 4 GiB. Ignores materials.
Result<ObjMesh> load_obj(const std::filesystem::path& file, const MeshReading& reading = {},
                         WorkProgress* progress = nullptr);

/// Returns whether a file name has the extension of Wavefront files, ".obj", in upper or lower case.
bool is_obj_file(const std::filesystem::path& file);

/// Returns a scene that shows one mesh file, resting on the plane y = 0. Reads the file to find the mesh's height, and
/// caches the mesh, so that load_scene() is fast afterward. Even a broken file yields a scene; load_scene() then
/// reports the error.
SceneDescription scene_of_mesh(const std::filesystem::path& file, WorkProgress* progress = nullptr);

}  // namespace viewing
