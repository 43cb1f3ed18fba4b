// libFuzzer: reads arbitrary bytes as a Wavefront OBJ file. An accepted mesh must be valid: it must be finite and
// within its box, its indices must refer to existing vertices, and its normals must have length 1.
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "state/mesh/obj.h"

namespace {

void check(bool holds) {
    if (!holds) {
        std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
    const viewing::Result<viewing::ObjMesh> read = viewing::read_obj(stream, size, "fuzz.obj", {}, nullptr);
    if (!read) {
        check(read.error().find('\n') == std::string::npos);
        return 0;
    }
    for (const std::string& note : read->notes) check(note.find('\n') == std::string::npos);
    const viewing::Mesh* const mesh = &read->mesh;
    check(!mesh->indices.empty() && mesh->indices.size() % 3 == 0);
    check(mesh->normals.size() == mesh->positions.size());
    for (const std::uint32_t index : mesh->indices) {
        check(index < mesh->positions.size());
    }
    for (const glm::vec3& position : mesh->positions) {
        check(std::abs(position.x) < 1.01F && std::abs(position.y) < 1.01F && std::abs(position.z) < 1.01F);
    }
    for (const glm::vec3& normal : mesh->normals) {
        check(std::abs(glm::length(normal) - 1.0F) < 1e-3F);
    }
    return 0;
}
