#include "state/mesh/mesh_cache.h"

#include <map>
#include <mutex>

#include "geometry/shapes.h"
#include "state/fields.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {

namespace {

using SharedMesh = std::shared_ptr<const ObjMesh>;

class Cache {
public:
    SharedMesh find(const std::string& key) {
        const std::scoped_lock lock(mutex_);
        const auto found = meshes_.find(key);
        return found == meshes_.end() ? nullptr : found->second.lock();
    }

    /// Adds a mesh and returns it. If two threads made the same mesh, both share the one that was added first.
    SharedMesh add(const std::string& key, ObjMesh mesh, bool keep) {
        const std::scoped_lock lock(mutex_);
        std::erase_if(meshes_, [](const auto& entry) { return entry.second.expired(); });
        SharedMesh shared = meshes_[key].lock();
        if (!shared) {
            shared = std::make_shared<const ObjMesh>(std::move(mesh));
            meshes_[key] = shared;
        }
        if (keep) {
            last_file_ = shared;
        }
        return shared;
    }

private:
    std::mutex mutex_;
    std::map<std::string, std::weak_ptr<const ObjMesh>> meshes_;
    SharedMesh last_file_;
};

Cache& cache() {
    static Cache instance;
    return instance;
}

std::string shape_key(const ObjectDescription& object) {
    std::string key(name_of(object.shape));
    if (object.shape == ShapeKind::teapot) {
        key += " " + std::to_string(object.resolution);
    } else if (object.shape == ShapeKind::triangle) {
        for (const glm::dvec3& vertex : object.vertices) {
            key += " " + format_number(vertex.x) + " " + format_number(vertex.y) + " " + format_number(vertex.z);
        }
    }
    return key;
}

Mesh shape_mesh(const ObjectDescription& object) {
    switch (object.shape) {
        case ShapeKind::box:
            return box_mesh();
        case ShapeKind::sphere:
            return sphere_mesh();
        case ShapeKind::torus:
            return torus_mesh();
        case ShapeKind::cylinder:
            return cylinder_mesh();
        case ShapeKind::cone:
            return cone_mesh();
        case ShapeKind::quad:
            return quad_mesh();
        case ShapeKind::triangle:
            return triangle_mesh(object.vertices);
        case ShapeKind::teapot:
            return teapot_mesh(object.resolution);
        case ShapeKind::mesh:
            break;
    }
    return {};
}

/// Combines a file's name, size, modification time and reading options, so that new content gets a new key.
std::string file_key(const std::filesystem::path& file, const MeshReading& reading) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    const auto time = std::filesystem::last_write_time(file, error).time_since_epoch().count();
    return "file " + std::filesystem::absolute(file, error).string() + " " + std::to_string(size) + " " +
           std::to_string(static_cast<std::int64_t>(time)) + " " + format_number(reading.crease_deg) +
           (reading.fit ? " fit" : "");
}

}  // namespace

Result<SharedMesh> shared_mesh(const ObjectDescription& object, const std::filesystem::path& base,
                               WorkProgress* progress) {
    const bool is_file = object.shape == ShapeKind::mesh;
    const std::filesystem::path file = base / object.file;
    const std::string key = is_file ? file_key(file, object.reading) : shape_key(object);
    if (SharedMesh shared = cache().find(key)) {
        report(progress, 1.0);
        return shared;
    }
    if (!is_file) {
        return cache().add(key, ObjMesh{shape_mesh(object), {}, {}}, false);
    }
    Result<ObjMesh> mesh = load_obj(file, object.reading, progress);
    if (!mesh) {
        return Error{mesh.error()};
    }
    return cache().add(key, std::move(*mesh), true);
}

}  // namespace viewing
