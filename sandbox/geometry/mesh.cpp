// Queries about a whole mesh. Read shapes.cpp next.
#include "geometry/mesh.h"

namespace viewing {

Bounds bounds_of(const Mesh& mesh) {
    Bounds bounds;
    for (const glm::vec3& position : mesh.positions) {
        bounds.add(position);
    }
    return bounds;
}

}  // namespace viewing
