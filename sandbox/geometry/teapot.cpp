// Newell's teapot (1975): 32 bicubic Bézier patches. All of it except the handle and the spout is a body of revolution,
// and these two are symmetric, so 20 rings and 14 cross-sections define all control points. The numbers are Newell's,
// with z up; the mesh has y up. Read navigation.h next.
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "geometry/shapes.h"

namespace viewing {
namespace {

/// A ring of control points about the axis. It consists of four quarter circles; `tangent` is the distance of a
/// quarter's inner control points from its ends.
struct Ring {
    double radius, height, tangent;
};

/// Returns a ring whose `tangent` is 0.56 of the radius, as in nearly all rings.
constexpr Ring ring(double radius, double height) {
    return {radius, height, 0.56 * radius};
}

/// A cross-section of the handle or the spout: two points in the plane of symmetry, and sides at a distance of
/// `half_width` from that plane.
struct Section {
    double x0, z0, x1, z1, half_width;
};

// In the two arrays of rings, each line completes a patch, and its last entry also begins the next patch. The outside
// is on the left of each profile.

constexpr std::array pot_rings = {
    ring(1.4, 2.4),    ring(1.3375, 2.53125), ring(1.4375, 2.53125), ring(1.5, 2.4),  // rim
    ring(1.75, 1.875), ring(2.0, 1.35),       ring(2.0, 0.9),                         // upper body
    ring(2.0, 0.45),   ring(1.5, 0.225),      ring(1.5, 0.15),                        // lower body
    ring(1.5, 0.075),  ring(1.425, 0.0),      ring(0.0, 0.0),                         // bottom
};

constexpr std::array lid_rings = {
    ring(0.0, 3.15), Ring{0.8, 3.15, 0.45}, ring(0.0, 2.85), ring(0.2, 2.7),  // knob
    ring(0.4, 2.55), ring(1.3, 2.55),       ring(1.3, 2.4),                   // lid
};

constexpr std::array<Section, 7> handle_sections = {{
    {-1.6, 2.025, -1.5, 2.25, 0.3},
    {-2.3, 2.025, -2.5, 2.25, 0.3},
    {-2.7, 2.025, -3.0, 2.25, 0.3},
    {-2.7, 1.8, -3.0, 1.8, 0.3},
    {-2.7, 1.575, -3.0, 1.35, 0.3},
    {-2.5, 1.125, -2.65, 0.9375, 0.3},
    {-2.0, 0.9, -1.9, 0.6, 0.3},
}};

constexpr std::array<Section, 7> spout_sections = {{
    {1.7, 1.425, 1.7, 0.6, 0.66},
    {2.6, 1.425, 3.1, 0.825, 0.66},
    {2.3, 2.1, 2.4, 2.025, 0.25},
    {2.7, 2.4, 3.3, 2.4, 0.25},
    {2.8, 2.475, 3.525, 2.49375, 0.25},
    {2.9, 2.475, 3.45, 2.5125, 0.15},
    {2.8, 2.4, 3.2, 2.4, 0.15},
}};

/// Control points [along][around], converted to y up. ∂along × ∂around points outward.
using Patch = std::array<std::array<glm::dvec3, 4>, 4>;

glm::dvec3 y_up(double x, double y, double z) {
    return {x, z, -y};
}

/// Returns the quarter of a ring that begins at an angle of `quarter` · 90°.
std::array<glm::dvec3, 4> quarter_ring(const Ring& ring, int quarter) {
    const std::array<glm::dvec2, 4> first = {
        {{ring.radius, 0.0}, {ring.radius, ring.tangent}, {ring.tangent, ring.radius}, {0.0, ring.radius}}};
    std::array<glm::dvec3, 4> points;
    for (std::size_t i = 0; i < 4; ++i) {
        glm::dvec2 p = first[i];
        for (int turn = 0; turn < quarter; ++turn) {
            p = {-p.y, p.x};
        }
        points[i] = y_up(p.x, p.y, ring.height);
    }
    return points;
}

/// Returns half of a cross-section: from point 1 to point 0 on the side of negative y, from point 0 to point 1 on the
/// other side.
std::array<glm::dvec3, 4> half_section(const Section& s, bool negative_side) {
    const double y = negative_side ? -s.half_width : s.half_width;
    const std::array<glm::dvec3, 4> points = {y_up(s.x0, 0.0, s.z0), y_up(s.x0, y, s.z0), y_up(s.x1, y, s.z1),
                                              y_up(s.x1, 0.0, s.z1)};
    return negative_side ? std::array{points[3], points[2], points[1], points[0]} : points;
}

/// Adds one patch for every four rows; neighboring patches share a row.
template <typename Row, typename PointsOfRow>
void add_patches(std::vector<Patch>& patches, std::span<const Row> rows, PointsOfRow points_of_row) {
    for (std::size_t first = 0; first + 3 < rows.size(); first += 3) {
        Patch& patch = patches.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) {
            patch[i] = points_of_row(rows[first + i]);
        }
    }
}

std::vector<Patch> teapot_patches() {
    std::vector<Patch> patches;
    for (const std::span<const Ring> rings : {std::span<const Ring>(pot_rings), std::span<const Ring>(lid_rings)}) {
        for (int quarter = 0; quarter < 4; ++quarter) {
            add_patches(patches, rings, [=](const Ring& row) { return quarter_ring(row, quarter); });
        }
    }
    for (const std::span<const Section> sections :
         {std::span<const Section>(handle_sections), std::span<const Section>(spout_sections)}) {
        for (const bool negative_side : {true, false}) {
            add_patches(patches, sections, [=](const Section& row) { return half_section(row, negative_side); });
        }
    }
    return patches;
}

using Weights = std::array<double, 4>;

/// Returns the cubic Bernstein polynomials at t.
Weights bernstein(double t) {
    const double s = 1.0 - t;
    return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

/// Returns the derivatives of the cubic Bernstein polynomials at t.
Weights bernstein_slope(double t) {
    const double s = 1.0 - t;
    return {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t};
}

glm::dvec3 weighted_sum(const Patch& patch, const Weights& along, const Weights& around) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            sum += along[i] * around[j] * patch[i][j];
        }
    }
    return sum;
}

/// Returns the outward unit normal. At a pole, where all control points of a row coincide, ∂around vanishes, so the
/// mixed derivative replaces it: near the pole, ∂around is nearly the mixed derivative times the distance from the
/// pole.
glm::dvec3 patch_normal(const Patch& patch, double u, double v) {
    const glm::dvec3 along = weighted_sum(patch, bernstein_slope(u), bernstein(v));
    glm::dvec3 around = weighted_sum(patch, bernstein(u), bernstein_slope(v));
    constexpr double negligible = 1e-9;
    if (glm::length(around) < negligible) {
        const double inwards = u < 0.5 ? 1.0 : -1.0;
        around = inwards * weighted_sum(patch, bernstein_slope(u), bernstein_slope(v));
    }
    return glm::normalize(glm::cross(along, around));
}

void tessellate(Mesh& mesh, const Patch& patch, int resolution) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto across = static_cast<std::uint32_t>(resolution) + 1;
    for (int i = 0; i <= resolution; ++i) {
        for (int j = 0; j <= resolution; ++j) {
            const double u = static_cast<double>(i) / resolution, v = static_cast<double>(j) / resolution;
            mesh.positions.emplace_back(weighted_sum(patch, bernstein(u), bernstein(v)));
            mesh.normals.emplace_back(patch_normal(patch, u, v));
        }
    }
    const auto add_triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
        if (p != q && q != r && r != p) {
            mesh.indices.insert(mesh.indices.end(), {a, b, c});
        }
    };
    for (std::uint32_t i = 0; i + 1 < across; ++i) {
        for (std::uint32_t j = 0; j + 1 < across; ++j) {
            const std::uint32_t here = first + i * across + j, below = here + across;
            add_triangle(here, below, below + 1);
            add_triangle(here, below + 1, here + 1);
        }
    }
}

}  // namespace

Mesh teapot_mesh(int resolution) {
    resolution = std::clamp(resolution, 1, 64);
    Mesh mesh;
    for (const Patch& patch : teapot_patches()) {
        tessellate(mesh, patch, resolution);
    }
    center_and_fit(mesh);
    return mesh;
}

}  // namespace viewing
