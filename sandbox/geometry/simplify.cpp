#include "geometry/simplify.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace viewing {
namespace {

/// The cells that contain vertices, numbered in order of appearance.
class Clusters {
public:
    Clusters(const Mesh& mesh, int cells) : of_vertex_(mesh.positions.size()) {
        const Bounds bounds = bounds_of(mesh);
        const glm::dvec3 size = bounds.empty() ? glm::dvec3(0.0) : bounds.size();
        const double longest = std::max({size.x, size.y, size.z});
        const double per_unit = longest > 0.0 ? cells / longest : 0.0;
        std::unordered_map<std::uint64_t, std::uint32_t> numbers;
        for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
            const glm::dvec3 place = (glm::dvec3(mesh.positions[vertex]) - bounds.min) * per_unit;
            std::uint64_t cell = 0;
            for (int axis = 0; axis < 3; ++axis)
                cell = (cell << 21U) | static_cast<std::uint64_t>(std::clamp(place[axis], 0.0, cells - 1.0));
            const auto next = static_cast<std::uint32_t>(sums_.size());
            const std::uint32_t number = numbers.try_emplace(cell, next).first->second;
            if (number == next) sums_.emplace_back();
            of_vertex_[vertex] = number;
            sums_[number].position += glm::dvec3(mesh.positions[vertex]);
            sums_[number].normal += glm::dvec3(mesh.normals[vertex]);
            ++sums_[number].count;
        }
    }

    std::uint32_t of(std::uint32_t vertex) const { return of_vertex_[vertex]; }

    /// Returns one vertex per cell, at the mean of the cell's vertices.
    Mesh middles() const {
        Mesh made;
        for (const Sum& sum : sums_) {
            const double length = glm::length(sum.normal);
            made.positions.emplace_back(sum.position / sum.count);
            made.normals.emplace_back(length > 0.0 ? sum.normal / length : glm::dvec3(0.0, 1.0, 0.0));
        }
        return made;
    }

private:
    struct Sum {
        glm::dvec3 position{0.0}, normal{0.0};
        double count = 0.0;
    };
    std::vector<std::uint32_t> of_vertex_;
    std::vector<Sum> sums_;
};

using Triangle = std::array<std::uint32_t, 3>;

struct HashOfTriangle {
    std::size_t operator()(const Triangle& triangle) const {
        std::uint64_t hash = 0;
        for (const std::uint32_t corner : triangle) hash = (hash ^ corner) * 0x9E3779B97F4A7C15U;
        return static_cast<std::size_t>(hash ^ (hash >> 29U));
    }
};

}  // namespace

Mesh simplified(const Mesh& mesh, int cells) {
    const Clusters clusters(mesh, cells);
    Mesh made = clusters.middles();
    std::unordered_set<Triangle, HashOfTriangle> known;
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        Triangle triangle{clusters.of(mesh.indices[first]), clusters.of(mesh.indices[first + 1]),
                          clusters.of(mesh.indices[first + 2])};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) continue;
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        if (known.insert(triangle).second) made.indices.insert(made.indices.end(), triangle.begin(), triangle.end());
    }
    return made;
}

Mesh simplified_to(const Mesh& mesh, std::size_t most_triangles) {
    constexpr int most_cells = 128;
    int cells = most_cells;
    Mesh made = simplified(mesh, cells);
    while (made.triangle_count() > most_triangles && cells > 1) made = simplified(mesh, cells = cells * 3 / 4);
    return made;
}

}  // namespace viewing
