// A Wavefront OBJ file as a Mesh: polygons are cut into triangles, and corners with the same position and normal become
// one vertex. Materials and groups are ignored. Read obj_lines.cpp next.
#include "state/mesh/obj.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "geometry/shapes.h"
#include "platform/file.h"
#include "state/mesh/obj_lines.h"
#include "state/mesh/obj_vertices.h"
#include "state/mesh/polygon.h"

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

constexpr const char* was_cancelled = "loading was cancelled";

/// The triangles; an error where it was cancelled or would take too long.
Result<Mesh> assembled(const ObjContent& content, WorkProgress* progress) {
    Mesh mesh;
    mesh.indices.reserve(static_cast<std::size_t>(3 * content.triangle_count));
    ObjVertices vertices(content, every_corner_has_a_normal(content), mesh);
    PolygonCutter cutter;
    std::vector<glm::vec3> corners;
    std::vector<std::uint32_t> triangles;
    std::size_t begin = 0, next_look = 0;
    constexpr std::size_t corners_between_looks = 8'192;
    const auto add_face = [&](std::uint32_t count) -> Status {
        if (begin >= next_look) {
            report(progress, static_cast<double>(begin) / static_cast<double>(content.corners.size()));
            if (is_cancelled(progress)) return Error{was_cancelled};
            next_look = begin + corners_between_looks;
        }
        corners.clear();
        for (std::size_t i = begin; i < begin + count; ++i)
            corners.push_back(content.positions[static_cast<std::size_t>(content.corners[i].position)]);
        triangles.clear();
        if (!cutter.cut(corners, triangles))
            return Error{"its concave faces have too many corners: to cut them up takes more than " +
                         std::to_string(PolygonCutter::most_tests / 1'000'000) +
                         " million tests; cut them into triangles before"};
        for (const std::uint32_t corner : triangles)
            mesh.indices.push_back(vertices.vertex(content.corners[begin + corner]));
        begin += count;
        return std::monostate{};
    };
    for (const auto& [corners_each, count] : content.faces)
        for (std::uint32_t face = 0; face < count; ++face)
            if (Status added = add_face(corners_each); !added) return Error{added.error()};
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
    if (content->faces.empty()) {
        return refusal(content->positions.empty() ? "not an OBJ file, or an empty one: it has no vertices and no faces"
                                                  : "has vertices but no faces");
    }
    WorkProgress of_assembling{.whole = progress, .begin = reading, .end = 1.0};
    Result<Mesh> assembly = assembled(*content, &of_assembling);
    if (!assembly) {
        return refusal(assembly.error());
    }
    Mesh mesh = *std::move(assembly);
    if (is_cancelled(progress)) return refusal(was_cancelled);
    center_and_fit(mesh);
    if (!has_area(mesh)) {
        return refusal("has no face with an area");
    }
    if (is_cancelled(progress)) {
        return refusal(was_cancelled);
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
