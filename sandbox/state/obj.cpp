// A Wavefront OBJ file as a Mesh: the library's callbacks collect positions, normals and corners; then polygons are cut
// into triangles and corners with the same position and normal become one vertex. Materials and groups are ignored.
#include "state/obj.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "geometry/shapes.h"
#include "state/obj_lines.h"
#include "state/polygon.h"

namespace viewing {

namespace {

constexpr int no_normal = -1;
constexpr double largest_coordinate = 1e12;

/// One corner of a face: indices from 0.
struct Corner {
    int position;
    int normal;
};

/// What the callbacks collect.
struct Collected {
    ObjLines& lines;
    std::vector<glm::vec3> positions, normals;
    std::vector<Corner> corners;
    std::vector<std::uint32_t> face_sizes;
    std::uint64_t triangle_count = 0;
    std::string trouble;

    void stop(const std::string& what) {
        if (trouble.empty()) {
            trouble = what;
        }
        lines.stop();
    }
};

bool is_usable(const glm::vec3& v) {
    const auto fits = [](float x) { return std::abs(static_cast<double>(x)) <= largest_coordinate; };
    return fits(v.x) && fits(v.y) && fits(v.z);  // NaN fits nowhere
}

void take_vertex(void* data, float x, float y, float z, float) {
    auto& collected = *static_cast<Collected*>(data);
    collected.positions.emplace_back(x, y, z);
    if (!is_usable(collected.positions.back())) {
        collected.stop("vertex " + std::to_string(collected.positions.size()) + " has a coordinate beyond 1e12");
    }
}

void take_normal(void* data, float x, float y, float z) {
    static_cast<Collected*>(data)->normals.emplace_back(x, y, z);
}

/// An index as the file has it (from 1, or from the end if negative) made to count from 0; −1 for one out of range.
int from_zero(int index, std::size_t count) {
    const auto size = static_cast<int>(count);
    return index > 0 ? index - 1 : index < 0 && -index <= size ? size + index : -1;
}

void take_face(void* data, tinyobj::index_t* indices, int count) {
    auto& collected = *static_cast<Collected*>(data);
    collected.face_sizes.push_back(static_cast<std::uint32_t>(count));
    collected.triangle_count += static_cast<std::uint64_t>(count) - 2;
    if (collected.triangle_count > max_obj_triangles) {
        collected.stop("more than 50 million triangles");
        return;
    }
    for (int i = 0; i < count; ++i) {
        const tinyobj::index_t& index = indices[i];
        const int position = from_zero(index.vertex_index, collected.positions.size());
        const int normal =
            index.normal_index == 0 ? no_normal : from_zero(index.normal_index, collected.normals.size());
        if (position < 0 || (index.normal_index != 0 && normal < 0)) {
            collected.stop("face " + std::to_string(collected.face_sizes.size()) + " names " +
                           (position < 0 ? "vertex " + std::to_string(index.vertex_index)
                                         : "normal " + std::to_string(index.normal_index)) +
                           ", which there is not");
            return;
        }
        collected.corners.push_back({position, normal});
    }
}

/// Positive indices may name what comes later in the file, so they are checked at the end.
std::string index_trouble(const Collected& collected) {
    std::size_t face = 0;
    std::size_t face_end = 0;
    for (std::size_t i = 0; i < collected.corners.size(); ++i) {
        while (i >= face_end) {
            face_end += collected.face_sizes[face++];
        }
        const Corner& corner = collected.corners[i];
        const bool bad_position = corner.position >= static_cast<int>(collected.positions.size());
        if (bad_position || corner.normal >= static_cast<int>(collected.normals.size())) {
            return "face " + std::to_string(face) + " names " +
                   (bad_position ? "vertex " + std::to_string(corner.position + 1) + ", but there are " +
                                       std::to_string(collected.positions.size())
                                 : "normal " + std::to_string(corner.normal + 1) + ", but there are " +
                                       std::to_string(collected.normals.size()));
        }
    }
    return "";
}

bool is_direction(const glm::vec3& v) {
    const float squared = glm::dot(v, v);
    return std::isfinite(squared) && squared > 0.0F;
}

/// Normals count only if every corner has one that points somewhere.
bool every_corner_has_a_normal(const Collected& collected) {
    for (const Corner& corner : collected.corners) {
        if (corner.normal == no_normal || !is_direction(collected.normals[static_cast<std::size_t>(corner.normal)])) {
            return false;
        }
    }
    return true;
}

/// Gives each pair of position and normal one vertex: the vertices at a position are chained.
class VertexMaker {
public:
    VertexMaker(const Collected& collected, bool with_normals, Mesh& mesh)
        : collected_(collected), with_normals_(with_normals), mesh_(mesh), first_(collected.positions.size(), none) {}

    std::uint32_t vertex(const Corner& corner) {
        const int normal = with_normals_ ? corner.normal : no_normal;
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
        mesh_.positions.push_back(collected_.positions[static_cast<std::size_t>(corner.position)]);
        if (with_normals_) {
            mesh_.normals.push_back(glm::normalize(collected_.normals[static_cast<std::size_t>(normal)]));
        }
        return made;
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    struct Made {
        int normal;
        std::uint32_t next;
    };
    const Collected& collected_;
    bool with_normals_;
    Mesh& mesh_;
    std::vector<std::uint32_t> first_;  ///< by position
    std::vector<Made> made_;            ///< by vertex
};

/// Empty when the job was cancelled.
Mesh assembled(const Collected& collected, const ProgressSpan& progress) {
    Mesh mesh;
    mesh.indices.reserve(3 * collected.triangle_count);
    VertexMaker maker(collected, every_corner_has_a_normal(collected), mesh);
    std::vector<glm::vec3> corners;
    std::vector<std::uint32_t> triangles;
    std::size_t begin = 0;
    for (std::size_t face = 0; face < collected.face_sizes.size(); ++face) {
        if (face % 65'536 == 0) {
            progress.show(static_cast<double>(face) / static_cast<double>(collected.face_sizes.size()));
            if (progress.cancelled()) {
                return {};
            }
        }
        corners.clear();
        for (std::size_t i = begin; i < begin + collected.face_sizes[face]; ++i) {
            corners.push_back(collected.positions[static_cast<std::size_t>(collected.corners[i].position)]);
        }
        triangles.clear();
        triangulate(corners, triangles);
        for (const std::uint32_t corner : triangles) {
            mesh.indices.push_back(maker.vertex(collected.corners[begin + corner]));
        }
        begin += collected.face_sizes[face];
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

void ProgressSpan::show(double fraction) const {
    if (progress != nullptr) {
        progress->fraction = begin + (end - begin) * static_cast<float>(std::min(fraction, 1.0));
    }
}

bool ProgressSpan::cancelled() const {
    return progress != nullptr && progress->cancelled;
}

Result<Mesh> read_obj(std::istream& stream, std::uint64_t size_bytes, const std::string& name,
                      const ProgressSpan& progress) {
    const float middle = progress.begin + 0.8F * (progress.end - progress.begin);
    ObjLines lines(stream, size_bytes, {progress.progress, progress.begin, middle});
    Collected collected{lines, {}, {}, {}, {}, 0, {}};

    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = take_vertex;
    callbacks.normal_cb = take_normal;
    callbacks.index_cb = take_face;
    std::istream checked(&lines);
    std::string warnings;
    std::string errors;
    const bool parsed = tinyobj::LoadObjWithCallback(checked, callbacks, &collected, nullptr, &warnings, &errors);

    const auto refusal = [&name](const std::string& what) { return Error{name + ": " + what}; };
    if (progress.cancelled()) {
        return refusal("loading was cancelled");
    }
    if (!lines.trouble().empty()) {
        return refusal(lines.trouble());
    }
    if (!parsed || !collected.trouble.empty()) {
        return refusal(parsed ? collected.trouble : "not an OBJ file");
    }
    if (collected.face_sizes.empty()) {
        return refusal(collected.positions.empty() ? "not an OBJ file, or an empty one: it has no vertices and no faces"
                                                   : "has vertices but no faces");
    }
    if (const std::string trouble = index_trouble(collected); !trouble.empty()) {
        return refusal(trouble);
    }
    Mesh mesh = assembled(collected, {progress.progress, middle, progress.end});
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
    progress.show(1.0);
    return mesh;
}

Result<Mesh> load_obj_file(const std::filesystem::path& file, const ProgressSpan& progress) {
    const std::string name = file.string();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        return Error{name + ": no such file"};
    }
    if (!std::filesystem::is_regular_file(status)) {
        return Error{name + ": " +
                     (std::filesystem::is_directory(status) ? "is a directory, not a file" : "is not a file")};
    }
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

Result<Mesh> load_obj(const std::filesystem::path& file, LoadProgress* progress) {
    return load_obj_file(file, {progress, 0.0F, 1.0F});
}

}  // namespace viewing
