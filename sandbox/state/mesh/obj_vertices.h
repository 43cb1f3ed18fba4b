// Internal to state/: which corners of an OBJ file's faces are one vertex.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/mesh.h"
#include "state/mesh/obj_lines.h"

namespace viewing {

/// Gives each pair of position and normal one vertex of the mesh, in constant time: the first vertices at a position
/// are chained, which is quickest, and further ones, of which a file may have any number, are looked up.
class ObjVertices {
public:
    /// `content`, whose corners all have a normal, and `mesh` must outlive it.
    ObjVertices(const ObjContent& content, Mesh& mesh);

    /// The index of the corner's vertex, which is added to the mesh where it is a new one.
    std::uint32_t vertex(const ObjCorner& corner);

    std::uint64_t steps() const { return steps_; }  ///< vertices looked at so far

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
