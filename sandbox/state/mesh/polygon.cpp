#include "state/mesh/polygon.h"

namespace viewing {

namespace {

constexpr std::size_t most_clipped_corners = 256;

/// Twice the polygon's area times its normal (Newell), which also holds for concave polygons.
glm::dvec3 area_normal(std::span<const glm::vec3> corners) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::dvec3(corners[i]) - origin;
        const glm::dvec3 b = glm::dvec3(corners[(i + 1) % corners.size()]) - origin;
        normal += glm::cross(a, b);
    }
    return normal;
}

/// How far to the left of a → b the point c lies, seen against the normal: twice the triangle's area.
double turn(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::dvec3& normal) {
    return glm::dot(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)), normal);
}

}  // namespace

double PolygonCutter::turn_at(Index corner) const {
    return turn(corners_[before_[corner]], corners_[corner], corners_[after_[corner]], normal_);
}

/// Whether the corner can be cut off: it turns left and no other corner lies in its triangle. Where any does, one that
/// does not turn left does.
bool PolygonCutter::is_ear(Index corner) {
    if (is_hollow_[corner]) return false;
    const glm::vec3 &a = corners_[before_[corner]], &b = corners_[corner], &c = corners_[after_[corner]];
    for (const Index hollow : hollows_) {
        if (!is_hollow_[hollow] || hollow == before_[corner] || hollow == after_[corner]) continue;
        ++tests_;
        const glm::vec3& p = corners_[hollow];
        if (p == a || p == b || p == c) continue;
        if (turn(a, b, p, normal_) >= 0.0 && turn(b, c, p, normal_) >= 0.0 && turn(c, a, p, normal_) >= 0.0)
            return false;
    }
    return true;
}

/// After a neighbour has gone.
void PolygonCutter::look_again(Index corner) {
    is_hollow_[corner] = static_cast<char>(turn_at(corner) <= 0.0);
    is_ear_[corner] = static_cast<char>(is_ear(corner));
    if (!is_ear_[corner] || is_queued_[corner]) return;
    ears_.push_back(corner);
    is_queued_[corner] = 1;
}

void PolygonCutter::clip_ears(std::vector<Index>& triangles) {
    const auto count = static_cast<Index>(corners_.size());
    is_ear_.assign(count, 0);
    is_queued_.assign(count, 0);
    ears_.clear();
    for (Index corner = 0; corner < count; ++corner) look_again(corner);
    Index left = count, last = count - 1;
    for (std::size_t next = 0; left > 3 && next < ears_.size(); ++next) {
        const Index ear = ears_[next];
        is_queued_[ear] = 0;
        if (!is_ear_[ear]) continue;
        is_ear_[ear] = 0;
        triangles.insert(triangles.end(), {before_[ear], ear, after_[ear]});
        last = before_[ear];
        after_[last] = after_[ear];
        before_[after_[ear]] = last;
        --left;
        look_again(last);
        look_again(after_[last]);
    }
    // The last triangle, or what is left of a polygon that crosses itself: a fan.
    for (Index corner = after_[last]; after_[corner] != last; corner = after_[corner])
        triangles.insert(triangles.end(), {last, corner, after_[corner]});
}

bool PolygonCutter::cut(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles) {
    corners_ = corners;
    const auto count = static_cast<Index>(corners.size());
    hollows_.clear();
    if (count > 3 && count <= most_clipped_corners) {
        normal_ = area_normal(corners);
        before_.resize(count);
        after_.resize(count);
        is_hollow_.assign(count, 0);
        for (Index corner = 0; corner < count; ++corner) {
            before_[corner] = (corner + count - 1) % count;
            after_[corner] = (corner + 1) % count;
            if (turn_at(corner) > 0.0) continue;
            is_hollow_[corner] = 1;
            hollows_.push_back(corner);
        }
    }
    if (!hollows_.empty()) {
        if (tests_ + 3 * static_cast<std::uint64_t>(count) * hollows_.size() > most_tests) return false;
        clip_ears(triangles);
        return true;
    }
    for (Index i = 0; i + 2 < count; ++i) triangles.insert(triangles.end(), {count - 1, i, i + 1});
    return true;
}

}  // namespace viewing
