// A triangle mesh, shared by all folders: positions, normals, indices. Shapes and files create it, methods sort
// it, render/ uploads it. Read shapes.h next.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace viewing {

/// Indexed triangles in model space, counterclockwise when seen from outside, with one unit normal per vertex.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;      ///< same count as positions
    std::vector<std::uint32_t> indices;  ///< three per triangle

    std::size_t triangle_count() const { return indices.size() / 3; }
};

/// An axis-aligned box, which is empty (min > max) until something is added.
struct Bounds {
    glm::dvec3 min{1e300};
    glm::dvec3 max{-1e300};

    bool empty() const { return min.x > max.x; }
    void add(const glm::dvec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void add(const Bounds& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
    glm::dvec3 center() const { return (min + max) * 0.5; }
    glm::dvec3 size() const { return max - min; }
    bool operator==(const Bounds&) const = default;
};

/// Returns the bounds of all vertices; empty if the mesh has no vertices.
Bounds bounds_of(const Mesh& mesh);

}  // namespace viewing
