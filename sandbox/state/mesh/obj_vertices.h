// Internal to state/: merges corners of an OBJ file's faces into vertices.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/mesh.h"
#include "state/mesh/obj_lines.h"

namespace viewing {

/// Finds or makes the one vertex for a pair of a position and a normal, in constant time. The first few vertices at a
/// position form a linked list, which is fastest; a hash map holds the others, of which a file may have any number.
class ObjVertices {
public:
    /// All corners of `content` must have a normal. `content` and `mesh` must outlive this object.
    ObjVertices(const ObjContent& content, Mesh& mesh);

    /// Returns the index of the corner's vertex, after adding it to the mesh if it is new.
    std::uint32_t vertex(const ObjCorner& corner);

    std::uint64_t steps() const { return steps_; }  ///< vertices compared so far

private:
    struct Made {
        int normal;
        std::uint32_t next;
    };
    struct Mixed {
        std::size_t operator()(std::uint64_t key) const;
    };

    std::uint32_t made(const ObjCorner& corner);

    const ObjContent& content_;
    Mesh& mesh_;
    std::vector<std::uint32_t> first_;  ///< by position
    std::vector<Made> made_;            ///< by vertex
    std::unordered_map<std::uint64_t, std::uint32_t, Mixed> further_;
    std::uint64_t steps_ = 0;
};

}  // namespace viewing
