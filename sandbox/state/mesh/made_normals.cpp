#include "state/mesh/made_normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/normals.h"
#include "state/mesh/polygon.h"

namespace viewing {

namespace {

constexpr double rounding_deg = 0.01;  // so that an angle exactly at the crease angle still counts as smooth

struct Face {
    std::uint32_t begin, end;  ///< the range of its corners
    int smoothing;
    glm::dvec3 area_normal;
};

class NormalMaker {
public:
    NormalMaker(ObjContent& content, double crease_deg)
        : content_(content),
          least_cosine_(crease_deg + rounding_deg >= 180.0 ? -2.0 : std::cos(glm::radians(crease_deg + rounding_deg))) {
    }

    void make() {
        list_faces();
        list_corners();
        for (std::size_t position = 0; position < content_.positions.size(); ++position) {
            const std::uint32_t begin = position == 0 ? 0 : ends_[position - 1];
            about_.assign(corners_.begin() + begin, corners_.begin() + ends_[position]);
            if (std::any_of(about_.begin(), about_.end(), [&](std::uint32_t corner) { return lacks(corner); }))
                make_about_one();
        }
    }

private:
    void list_faces();
    void list_corners();
    void make_about_one();
    void join_across_edges();
    void add_normal(std::size_t root);
    bool is_smooth(const Face& a, const Face& b) const;

    bool lacks(std::uint32_t corner) const { return content_.corners[corner].normal == ObjCorner::no_normal; }
    const Face& face_at(std::uint32_t corner) const { return faces_[face_of_[corner]]; }

    /// Returns the entry of about_ that represents all entries joined to `place`.
    std::uint32_t root_of(std::uint32_t place) {
        while (root_[place] != place) place = root_[place] = root_[root_[place]];
        return place;
    }

    /// An edge that starts at the current position: its other end, and the entry of about_ for its face.
    struct Edge {
        int end;
        std::uint32_t place;
    };

    ObjContent& content_;
    const double least_cosine_;
    std::vector<Face> faces_;
    std::vector<std::uint32_t> face_of_;         ///< by corner
    std::vector<std::uint32_t> corners_, ends_;  ///< corners sorted by position, and the end of each position's range
    std::vector<std::uint32_t> about_, root_;    ///< corners at one position, and their union-find parents
    std::vector<Edge> edges_;
    std::vector<glm::dvec3> sums_;
    std::vector<int> made_;
};

void NormalMaker::list_faces() {
    faces_.reserve(static_cast<std::size_t>(content_.face_lines.count()));
    face_of_.resize(content_.corners.size());
    std::vector<glm::dvec3> polygon;
    std::uint32_t begin = 0;
    for (const auto& [corners_each, count, smoothing] : content_.faces) {
        for (std::uint32_t i = 0; i < count; ++i, begin += corners_each) {
            const std::uint32_t end = begin + corners_each;
            polygon.clear();
            for (std::uint32_t corner = begin; corner < end; ++corner) {
                polygon.push_back(content_.positions[content_.corners[corner].position]);
                face_of_[corner] = static_cast<std::uint32_t>(faces_.size());
            }
            faces_.push_back({begin, end, smoothing, area_normal(polygon)});
        }
    }
}

void NormalMaker::list_corners() {
    ends_.assign(content_.positions.size(), 0);
    for (const ObjCorner& corner : content_.corners) ++ends_[corner.position];
    std::exclusive_scan(ends_.begin(), ends_.end(), ends_.begin(), 0U);
    corners_.resize(content_.corners.size());
    for (std::uint32_t corner = 0; corner < content_.corners.size(); ++corner)
        corners_[ends_[content_.corners[corner].position]++] = corner;
}

bool NormalMaker::is_smooth(const Face& a, const Face& b) const {
    if (a.smoothing != b.smoothing || a.smoothing == ObjFaces::smoothing_off) return false;
    if (a.smoothing != ObjFaces::no_statement) return true;
    const double lengths = std::sqrt(glm::dot(a.area_normal, a.area_normal) * glm::dot(b.area_normal, b.area_normal));
    return lengths > 0.0 && glm::dot(a.area_normal, b.area_normal) >= least_cosine_ * lengths;
}

/// Joins the corners of faces that share a smooth edge. Sorts the edges so that the faces at each edge are adjacent, in
/// file order, and then compares each face with the next.
void NormalMaker::join_across_edges() {
    edges_.clear();
    for (std::uint32_t place = 0; place < about_.size(); ++place) {
        const std::uint32_t corner = about_[place];
        const Face& face = face_at(corner);
        const std::uint32_t before = corner == face.begin ? face.end - 1 : corner - 1;
        const std::uint32_t after = corner + 1 == face.end ? face.begin : corner + 1;
        edges_.push_back({content_.corners[before].position, place});
        edges_.push_back({content_.corners[after].position, place});
    }
    std::sort(edges_.begin(), edges_.end(),
              [](const Edge& a, const Edge& b) { return a.end != b.end ? a.end < b.end : a.place < b.place; });
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i) {
        const Edge &one = edges_[i], &other = edges_[i + 1];
        if (one.end == other.end && is_smooth(face_at(about_[one.place]), face_at(about_[other.place])))
            root_[root_of(other.place)] = root_of(one.place);
    }
}

void NormalMaker::make_about_one() {
    root_.resize(about_.size());
    std::iota(root_.begin(), root_.end(), 0U);
    join_across_edges();
    sums_.assign(about_.size(), glm::dvec3(0.0));
    made_.assign(about_.size(), ObjCorner::no_normal);
    for (std::uint32_t place = 0; place < about_.size(); ++place)
        sums_[root_of(place)] += face_at(about_[place]).area_normal;
    for (std::uint32_t place = 0; place < about_.size(); ++place) {
        if (!lacks(about_[place])) continue;
        const std::uint32_t root = root_of(place);
        if (made_[root] == ObjCorner::no_normal) add_normal(root);
        content_.corners[about_[place]].normal = made_[root];
    }
}

/// Adds the normal of joined corners. If the faces' normals cancel out, as on the two sides of a sheet, uses the normal
/// of one face.
void NormalMaker::add_normal(std::size_t root) {
    const glm::dvec3& own = face_at(about_[root]).area_normal;
    const bool cancels_out = glm::length(sums_[root]) < 1e-9 * glm::length(own);
    const glm::dvec3 sum = cancels_out ? own : sums_[root];
    const glm::dvec3 direction = direction_of(sum);
    made_[root] = static_cast<int>(content_.normals.size());
    content_.normals.emplace_back(direction == glm::dvec3(0.0) ? glm::dvec3(0.0, 1.0, 0.0) : direction);
}

}  // namespace

void make_missing_normals(ObjContent& content, double crease_deg) {
    const auto lacks = [](const ObjCorner& corner) { return corner.normal == ObjCorner::no_normal; };
    if (std::any_of(content.corners.begin(), content.corners.end(), lacks)) NormalMaker(content, crease_deg).make();
}

}  // namespace viewing
