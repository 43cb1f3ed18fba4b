// Reads a Wavefront OBJ file as a Mesh: splits polygons into triangles and merges corners with the same position and
// normal into one vertex. Ignores materials and names. Read obj_lines.cpp next.
#include "state/mesh/obj.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "platform/file.h"
#include "state/mesh/made_normals.h"
#include "state/mesh/obj_lines.h"
#include "state/mesh/obj_vertices.h"
#include "state/mesh/polygon.h"
#include "text/numbers.h"

namespace viewing {

namespace {

constexpr const char* was_canceled = "loading was canceled";

Bounds bounds_of_corners(const ObjContent& content) {
    Bounds bounds;
    for (const ObjCorner& corner : content.corners) bounds.add(content.positions[corner.position]);
    return bounds;
}

/// Assembles the triangles of all faces.
class Assembly {
public:
    Assembly(ObjContent& content, WorkProgress* progress)
        : content_(content), progress_(progress), vertices_(content, mesh_) {
        mesh_.indices.reserve(static_cast<std::size_t>(3 * content.triangle_count));
    }

    /// Fails if canceled, or if it would take too long.
    Result<Mesh> run() {
        std::uint64_t face = 0;
        for (const auto& [corners_each, count, smoothing] : content_.faces)
            for (std::uint32_t i = 0; i < count; ++i, ++face)
                if (Status added = add_face(face, corners_each); !added) return Error{added.error()};
        if (crossing_count_ > 0)
            content_.notes.push_back(
                at_face(first_crossing_) + "crosses itself and is filled with a triangle fan" +
                (crossing_count_ > 1 ? " (and " + std::to_string(crossing_count_ - 1) + " more)" : ""));
        return std::move(mesh_);
    }

private:
    Status add_face(std::uint64_t face, std::uint32_t corner_count);
    std::string at_face(std::uint64_t face) const {
        return "line " + std::to_string(content_.face_lines.line_of(face)) + ": face " + std::to_string(face + 1) + " ";
    }

    ObjContent& content_;
    WorkProgress* const progress_;
    Mesh mesh_;
    ObjVertices vertices_;
    PolygonCutter cutter_;
    std::vector<glm::dvec3> corners_;
    std::vector<std::uint32_t> triangles_;
    std::size_t begin_ = 0, next_look_ = 0;
    std::uint64_t first_crossing_ = 0, crossing_count_ = 0;
};

Status Assembly::add_face(std::uint64_t face, std::uint32_t corner_count) {
    constexpr std::size_t corners_between_looks = 8'192;
    if (begin_ >= next_look_) {
        report(progress_, static_cast<double>(begin_) / static_cast<double>(content_.corners.size()));
        if (is_canceled(progress_)) return Error{was_canceled};
        next_look_ = begin_ + corners_between_looks;
    }
    corners_.clear();
    for (std::size_t i = begin_; i < begin_ + corner_count; ++i)
        corners_.push_back(content_.positions[content_.corners[i].position]);
    triangles_.clear();
    switch (cutter_.cut(corners_, triangles_)) {
        case PolygonCutter::Outcome::takes_too_long:
            return Error{
                at_face(face) + "has " + std::to_string(corner_count) + " corners: triangulating it takes more than " +
                std::to_string(PolygonCutter::most_tests / 1'000'000) + " million tests; triangulate it in the file"};
        case PolygonCutter::Outcome::crosses_itself:
            if (crossing_count_++ == 0) first_crossing_ = face;
            break;
        case PolygonCutter::Outcome::filled:
            break;
    }
    for (const std::uint32_t corner : triangles_)
        mesh_.indices.push_back(vertices_.vertex(content_.corners[begin_ + corner]));
    begin_ += corner_count;
    return std::monostate{};
}

/// Returns whether any triangle has a nonzero area; `unit` is half the mesh's longest side.
bool has_area(const Mesh& mesh, double unit) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
        const glm::dvec3 ab = glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - a;
        const glm::dvec3 ac = glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - a;
        if (glm::length(glm::cross(ab, ac)) > 1e-12 * unit * unit) {
            return true;
        }
    }
    return false;
}

}  // namespace

Result<ObjMesh> read_obj(std::istream& stream, std::uint64_t size_bytes, const std::string& name,
                         const MeshReading& reading, WorkProgress* progress) {
    const auto refusal = [&name](const std::string& what) { return Error{name + ": " + what}; };
    constexpr double share_of_lines = 0.8;
    WorkProgress of_lines{.whole = progress, .begin = 0.0, .end = share_of_lines};
    Result<ObjContent> content = read_obj_lines(stream, size_bytes, &of_lines);
    if (!content) return refusal(content.error());

    // Coordinates stay in double precision up to here, because they may be far from the origin and close together.
    const Bounds bounds = bounds_of_corners(*content);
    const glm::dvec3 center = bounds.center(), size = bounds.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0.0)) return refusal("has no face with a nonzero area");
    // The coordinates of a smaller mesh have too few digits to distinguish its corners. Without scaling, the limit is
    // that of single precision.
    const double least = reading.fit ? 1e-300 : 1e-30;
    if (longest < least)
        return refusal("is " + figures(longest) + " units across, but must be at least " + figures(least) +
                       ": scale its coordinates up");
    const double unit = reading.fit ? longest / 2.0 : 1.0;
    for (glm::dvec3& position : content->positions) position = (position - center) / unit;
    make_missing_normals(*content, reading.crease_deg);

    WorkProgress of_assembling{.whole = progress, .begin = share_of_lines, .end = 1.0};
    Result<Mesh> mesh = Assembly(*content, &of_assembling).run();
    if (!mesh) return refusal(mesh.error());
    if (!has_area(*mesh, longest / 2.0 / unit)) return refusal("has no face with a nonzero area");
    if (is_canceled(progress)) return refusal(was_canceled);
    report(progress, 1.0);
    for (std::string& note : content->notes) note = name + ": " + note;
    return ObjMesh{*std::move(mesh), reading.fit ? glm::dvec3(0.0) : center, std::move(content->notes)};
}

Result<ObjMesh> load_obj(const std::filesystem::path& file, const MeshReading& reading, WorkProgress* progress) {
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
    return read_obj(stream, size_bytes, name, reading, progress);
}

}  // namespace viewing
