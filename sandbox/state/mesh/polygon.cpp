#include "state/mesh/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viewing {

namespace {

constexpr std::uint64_t tests_a_corner = 100;
constexpr std::uint32_t no_corner = std::numeric_limits<std::uint32_t>::max();
constexpr double rounding = 1e-9;  // tolerance of turn(), as a fraction of the polygon's area

/// Makes two unit vectors perpendicular to a normal and to each other, the second to the left of the first.
void make_axes(const glm::dvec3& normal, glm::dvec3& right, glm::dvec3& up) {
    const glm::dvec3 size = glm::abs(normal);
    const glm::dvec3 least = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
                             : size.y <= size.z                   ? glm::dvec3(0.0, 1.0, 0.0)
                                                                  : glm::dvec3(0.0, 0.0, 1.0);
    right = glm::normalize(glm::cross(least, normal));
    up = glm::cross(normal, right);
}

}  // namespace

glm::dvec3 area_normal(std::span<const glm::dvec3> corners) {
    glm::dvec3 normal(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return normal;
}

void PolygonCutter::flatten(std::span<const glm::dvec3> corners) {
    const glm::dvec3 normal = area_normal(corners);
    const double length = glm::length(normal);
    glm::dvec3 right(1.0, 0.0, 0.0), up(0.0, 1.0, 0.0);
    if (length > 0.0) make_axes(normal / length, right, up);
    flat_.clear();
    for (const glm::dvec3& corner : corners)
        flat_.emplace_back(glm::dot(corner - corners[0], right), glm::dot(corner - corners[0], up));
}

double PolygonCutter::turn(Index a, Index b, Index c) const {
    const glm::dvec2 ab = flat_[b] - flat_[a], ac = flat_[c] - flat_[a];
    return ab.x * ac.y - ab.y * ac.x;
}

bool PolygonCutter::lies_in_triangle_at(Index corner, Index hollow) {
    ++tests_;
    const Index a = before_[corner], b = corner, c = after_[corner];
    if (!is_hollow_[hollow] || hollow == a || hollow == c) return false;
    const glm::dvec2& place = flat_[hollow];
    if (place == flat_[a] || place == flat_[b] || place == flat_[c]) return false;
    if (turn(a, b, hollow) < 0.0 || turn(b, c, hollow) < 0.0 || turn(c, a, hollow) < 0.0) return false;
    blocker_[corner] = hollow;
    return true;
}

/// Returns whether the corner can be cut off: whether it turns left and no other corner is inside its triangle. Testing
/// only hollow (reflex) corners is enough, because if any corner is inside, a hollow one is too.
bool PolygonCutter::is_ear(Index corner) {
    if (is_hollow_[corner] || turn_at(corner) <= 0.0) return false;
    if (blocker_[corner] != no_corner && lies_in_triangle_at(corner, blocker_[corner])) return false;
    const auto is_hollow = [this](Index hollow) { return is_hollow_[hollow] != 0; };
    const auto lies_inside = [this, corner](Index hollow) { return lies_in_triangle_at(corner, hollow); };
    const bool is_blocked =
        grid_.any_in({flat_[before_[corner]], flat_[corner], flat_[after_[corner]]}, is_hollow, lies_inside);
    tests_ += grid_.take_cells_seen();
    return !is_blocked;
}

/// Fills the grid with the reflex corners. Called again when so few of them are left that most cells are empty.
void PolygonCutter::fill_grid() {
    std::erase_if(hollows_, [this](Index corner) { return !is_hollow_[corner]; });
    if (!hollows_.empty()) grid_.fill(flat_, hollows_);
    hollow_count_ = hollows_.size();
}

/// Updates a corner after a neighbor was cut off.
void PolygonCutter::look_again(Index corner) {
    if (is_hollow_[corner] && turn_at(corner) > 0.0) {
        is_hollow_[corner] = 0;
        if (4 * --hollow_count_ < grid_.size()) fill_grid();
    }
    is_ear_[corner] = static_cast<char>(is_ear(corner));
    if (!is_ear_[corner] || is_queued_[corner]) return;
    ears_.push_back(corner);
    is_queued_[corner] = 1;
}

/// Cuts off ears until there are no more or only three corners are left; returns false if that takes too long.
bool PolygonCutter::clip_ears(std::vector<Index>& triangles) {
    const auto count = static_cast<Index>(flat_.size());
    is_ear_.assign(count, 0);
    is_queued_.assign(count, 0);
    blocker_.assign(count, no_corner);
    ears_.clear();
    fill_grid();
    for (Index corner = 0; corner < count && tests_ <= allowed_tests_; ++corner) look_again(corner);
    Index left = count;
    for (std::size_t next = 0; left > 3 && next < ears_.size() && tests_ <= allowed_tests_; ++next) {
        const Index ear = ears_[next];
        is_queued_[ear] = 0;
        if (!is_ear_[ear]) continue;
        is_ear_[ear] = 0;
        const Index before = before_[ear], after = after_[ear];
        triangles.insert(triangles.end(), {before, ear, after});
        after_[before] = after;
        before_[after] = before;
        --left;
        look_again(before);
        look_again(after);
    }
    return tests_ <= allowed_tests_;
}

/// Covers the rest with a fan of triangles around one of its corners.
PolygonCutter::Outcome PolygonCutter::fan(Index about, std::vector<Index>& triangles) {
    double area = 0.0, least = 0.0;
    for (Index corner = after_[about]; after_[corner] != about; corner = after_[corner]) {
        const double twice_area = turn(about, corner, after_[corner]);
        area += std::abs(twice_area);
        least = std::min(least, twice_area);
        triangles.insert(triangles.end(), {about, corner, after_[corner]});
    }
    return least < -rounding * area ? Outcome::crosses_itself : Outcome::filled;
}

PolygonCutter::Outcome PolygonCutter::cut(std::span<const glm::dvec3> corners, std::vector<std::uint32_t>& triangles) {
    const auto count = static_cast<Index>(corners.size());
    if (count == 3) {
        triangles.insert(triangles.end(), {0, 1, 2});
        return Outcome::filled;
    }
    flatten(corners);
    hollows_.clear();
    before_.resize(count);
    after_.resize(count);
    is_hollow_.assign(count, 0);
    for (Index corner = 0; corner < count; ++corner) {
        before_[corner] = (corner == 0 ? count : corner) - 1;
        after_[corner] = corner + 1 == count ? 0 : corner + 1;
        if (turn_at(corner) > 0.0) continue;
        is_hollow_[corner] = 1;
        hollows_.push_back(corner);
    }
    if (hollows_.empty()) return fan(0, triangles);
    allowed_tests_ += tests_a_corner * count;
    const std::size_t had = triangles.size();
    if (clip_ears(triangles)) {
        // Finds a remaining corner: its neighbors still point back to it.
        Index left = 0;
        while (after_[before_[left]] != left) ++left;
        return fan(left, triangles);
    }
    triangles.resize(had);
    return Outcome::takes_too_long;
}

}  // namespace viewing
