// Meshes on the GPU: uploaded once and kept as long as a scene refers to them.
#pragma once

#include <memory>
#include <unordered_map>

#include "geometry/mesh.h"
#include "gl/objects.h"

namespace viewing {

struct GpuMesh {
    gl::VertexArray vertex_array;
    gl::Buffer vertices, indices;
    GLsizei index_count = 0;
    Bounds bounds;  ///< in model space

    int triangle_count() const { return index_count / 3; }
    void draw(int triangles) const;  ///< draws the first `triangles` triangles
};

/// Interleaves positions and normals and uploads them; attribute 0 is the position, 1 the normal.
GpuMesh upload(const Mesh& mesh);

class GpuMeshes {
public:
    const GpuMesh& of(const std::shared_ptr<const Mesh>& mesh);

    /// Frees meshes to which no scene refers anymore.
    void drop_unused();

private:
    struct Entry {
        std::weak_ptr<const Mesh> source;
        GpuMesh mesh;
    };
    std::unordered_map<const Mesh*, Entry> entries_;
};

}  // namespace viewing
