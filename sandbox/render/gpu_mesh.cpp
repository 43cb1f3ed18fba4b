#include "render/gpu_mesh.h"

namespace viewing {

void GpuMesh::draw(int triangles) const {
    glBindVertexArray(vertex_array.name());
    glDrawElements(GL_TRIANGLES, triangles * 3, GL_UNSIGNED_INT, nullptr);
}

GpuMesh upload(const Mesh& mesh) {
    std::vector<glm::vec3> interleaved;
    interleaved.reserve(mesh.positions.size() * 2);
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        interleaved.push_back(mesh.positions[vertex]);
        interleaved.push_back(mesh.normals[vertex]);
    }

    GpuMesh made{gl::make_vertex_array(), gl::make_buffer(), gl::make_buffer(),
                 static_cast<GLsizei>(mesh.indices.size()), bounds_of(mesh)};
    glBindVertexArray(made.vertex_array.name());
    glBindBuffer(GL_ARRAY_BUFFER, made.vertices.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(interleaved.size() * sizeof(glm::vec3)), interleaved.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.indices.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                 mesh.indices.data(), GL_STATIC_DRAW);
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexAttribArray(attribute);
        glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec3),
                              reinterpret_cast<const void*>(attribute * sizeof(glm::vec3)));
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return made;
}

const GpuMesh& GpuMeshes::of(const std::shared_ptr<const Mesh>& mesh) {
    Entry& entry = entries_[mesh.get()];
    if (entry.source.lock() != mesh) entry = {mesh, upload(*mesh)};  // a new mesh, possibly at a freed address
    return entry.mesh;
}

void GpuMeshes::drop_unused() {
    std::erase_if(entries_, [](const auto& item) { return item.second.source.expired(); });
}

}  // namespace viewing
