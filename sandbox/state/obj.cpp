// A Wavefront OBJ file as a Mesh: polygons are cut into triangles, and corners with the same position and normal become
// one vertex. Materials and groups are ignored. Read obj_lines.cpp next.
#include "state/obj.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "geometry/shapes.h"
#include "platform/file.h"
#include "state/obj_lines.h"
#include "state/polygon.h"

namespace viewing {

namespace {

bool is_direction(const glm::vec3& v) {
    const float squared = glm::dot(v, v);
    return std::isfinite(squared) && squared > 0.0F;
}

/// Normals count only if every corner has one that points somewhere.
bool every_corner_has_a_normal(const ObjContent& content) {
    for (const ObjCorner& corner : content.corners) {
        if (corner.normal == ObjCorner::no_normal ||
            !is_direction(content.normals[static_cast<std::size_t>(corner.normal)])) {
            return false;
        }
    }
    return true;
}

/// Gives each pair of position and normal one vertex: the vertices at a position are chained.
class VertexMaker {
public:
    VertexMaker(const ObjContent& content, bool with_normals, Mesh& mesh)
        : content_(content), with_normals_(with_normals), mesh_(mesh), first_(content.positions.size(), none) {}

    std::uint32_t vertex(const ObjCorner& corner) {
        const int normal = with_normals_ ? corner.normal : ObjCorner::no_normal;
        std::uint32_t* link = &first_[static_cast<std::size_t>(corner.position)];
        while (*link != none) {
            if (made_[*link].normal == normal) {
                return *link;
            }
            link = &made_[*link].next;
        }
        const auto made = static_cast<std::uint32_t>(made_.size());
        *link = made;
        made_.push_back({normal, none});
        mesh_.positions.push_back(content_.positions[static_cast<std::size_t>(corner.position)]);
        if (with_normals_) {
            mesh_.normals.push_back(glm::normalize(content_.normals[static_cast<std::size_t>(normal)]));
        }
        return made;
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    struct Made {
        int normal;
        std::uint32_t next;
    };
    const ObjContent& content_;
    bool with_normals_;
    Mesh& mesh_;
    std::vector<std::uint32_t> first_;  ///< by position
    std::vector<Made> made_;            ///< by vertex
};

/// Empty when the job was cancelled.
Mesh assembled(const ObjContent& content, WorkProgress* progress) {
    Mesh mesh;
    mesh.indices.reserve(3 * content.triangle_count);
    VertexMaker maker(content, every_corner_has_a_normal(content), mesh);
    std::vector<glm::vec3> corners;
    std::vector<std::uint32_t> triangles;
    std::size_t begin = 0;
    for (std::size_t face = 0; face < content.face_sizes.size(); ++face) {
        if (face % 65'536 == 0) {
            report(progress, static_cast<double>(face) / static_cast<double>(content.face_sizes.size()));
            if (is_cancelled(progress)) {
                return {};
            }
        }
        corners.clear();
        for (std::size_t i = begin; i < begin + content.face_sizes[face]; ++i) {
            corners.push_back(content.positions[static_cast<std::size_t>(content.corners[i].position)]);
        }
        triangles.clear();
        triangulate(corners, triangles);
        for (const std::uint32_t corner : triangles) {
            mesh.indices.push_back(maker.vertex(content.corners[begin + corner]));
        }
        begin += content.face_sizes[face];
    }
    return mesh;
}

bool has_area(const Mesh& mesh) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 ab = glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - a;
        const glm::dvec3 ac = glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - a;
        if (glm::length(glm::cross(ab, ac)) > 1e-12) {
            return true;
        }
    }
    return false;
}

}  // namespace

Result<Mesh> read_obj(std::istream& stream, std::uint64_t size_bytes, const std::string& name, WorkProgress* progress) {
    const auto refusal = [&name](const std::string& what) { return Error{name + ": " + what}; };
    constexpr double reading = 0.8;
    WorkProgress of_reading{.whole = progress, .begin = 0.0, .end = reading};
    const Result<ObjContent> content = read_obj_lines(stream, size_bytes, &of_reading);
    if (!content) {
        return refusal(content.error());
    }
    if (content->face_sizes.empty()) {
        return refusal(content->positions.empty() ? "not an OBJ file, or an empty one: it has no vertices and no faces"
                                                  : "has vertices but no faces");
    }
    WorkProgress of_assembling{.whole = progress, .begin = reading, .end = 1.0};
    Mesh mesh = assembled(*content, &of_assembling);
    if (mesh.indices.empty()) {
        return refusal("loading was cancelled");
    }
    center_and_fit(mesh);
    if (!has_area(mesh)) {
        return refusal("has no face with an area");
    }
    if (mesh.normals.empty()) {
        make_normals(mesh);
    }
    report(progress, 1.0);
    return mesh;
}

Result<Mesh> load_obj(const std::filesystem::path& file, WorkProgress* progress) {
    const std::string name = file.string();
    if (Status checked = check_readable(file); !checked) {
        return Error{checked.error()};
    }
    std::error_code error;
    const std::uint64_t size_bytes = std::filesystem::file_size(file, error);
    if (!error && size_bytes > max_obj_bytes) {
        return Error{name + ": larger than 4 GiB"};
    }
    std::ifstream stream(file, std::ios::binary);
    if (error || !stream) {
        return Error{name + ": cannot be read"};
    }
    return read_obj(stream, size_bytes, name, progress);
}

}  // namespace viewing
