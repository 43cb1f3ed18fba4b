// Shapes from formulas. Vertices are shared wherever positions and normals are equal, so that closed shapes are
// watertight without any tolerance. Read teapot.cpp next.
#include "geometry/shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace viewing {
namespace {

using Index = std::uint32_t;

Index add_vertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal) {
    mesh.positions.emplace_back(position);
    mesh.normals.emplace_back(normal);
    return static_cast<Index>(mesh.positions.size() - 1);
}

void add_triangle(Mesh& mesh, Index a, Index b, Index c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Adds a quad whose corners are given counterclockwise as seen from the front.
void add_quad(Mesh& mesh, Index a, Index b, Index c, Index d) {
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, c, d);
}

/// Returns the point at `turn` (0 … 1 is one full turn) of the unit circle about y, counterclockwise seen from above.
glm::dvec3 on_circle(double turn) {
    const double angle = turn * glm::two_pi<double>();
    return {std::cos(angle), 0.0, -std::sin(angle)};
}

double turn_of_slice(double slice, int slices) {
    return slice / slices;
}

/// Adds a disc of radius 1 at height y; the normals of all its vertices point straight up or down.
void add_disc(Mesh& mesh, double y, bool faces_up, int slices) {
    const glm::dvec3 axis(0.0, 1.0, 0.0);
    const glm::dvec3 normal = faces_up ? axis : -axis;
    const Index center = add_vertex(mesh, y * axis, normal);
    const Index rim = center + 1;
    for (int i = 0; i < slices; ++i) {
        add_vertex(mesh, on_circle(turn_of_slice(i, slices)) + y * axis, normal);
    }
    for (int i = 0; i < slices; ++i) {
        const Index here = rim + i, next = rim + (i + 1) % slices;
        faces_up ? add_triangle(mesh, center, here, next) : add_triangle(mesh, center, next, here);
    }
}

constexpr int min_slices = 3;

}  // namespace

Mesh box_mesh() {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {1.0, -1.0}) {
            glm::dvec3 normal(0.0), u(0.0), v(0.0);
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1.0;  // u × v = normal
            const Index a = add_vertex(mesh, normal - u - v, normal);
            const Index b = add_vertex(mesh, normal + u - v, normal);
            const Index c = add_vertex(mesh, normal + u + v, normal);
            const Index d = add_vertex(mesh, normal - u + v, normal);
            add_quad(mesh, a, b, c, d);
        }
    }
    return mesh;
}

Mesh sphere_mesh(int slices, int stacks) {
    slices = std::max(slices, min_slices);
    stacks = std::max(stacks, 2);
    Mesh mesh;
    const glm::dvec3 north_pole(0.0, 1.0, 0.0);
    const Index north = add_vertex(mesh, north_pole, north_pole);
    const Index south = add_vertex(mesh, -north_pole, -north_pole);
    const Index rings = south + 1;
    for (int stack = 1; stack < stacks; ++stack) {
        const double from_north = stack * glm::pi<double>() / stacks;
        for (int slice = 0; slice < slices; ++slice) {
            const glm::dvec3 point =
                std::sin(from_north) * on_circle(turn_of_slice(slice, slices)) + std::cos(from_north) * north_pole;
            add_vertex(mesh, point, point);
        }
    }

    const int last_ring = stacks - 2;
    const auto vertex = [&](int ring, int slice) { return rings + static_cast<Index>(ring * slices + slice % slices); };
    for (int slice = 0; slice < slices; ++slice) {
        add_triangle(mesh, north, vertex(0, slice), vertex(0, slice + 1));
        for (int ring = 0; ring < last_ring; ++ring) {
            add_quad(mesh, vertex(ring, slice), vertex(ring + 1, slice), vertex(ring + 1, slice + 1),
                     vertex(ring, slice + 1));
        }
        add_triangle(mesh, south, vertex(last_ring, slice + 1), vertex(last_ring, slice));
    }
    return mesh;
}

Mesh torus_mesh(int slices, int sides) {
    constexpr double ring_radius = 0.9, tube_radius = 0.34;
    slices = std::max(slices, min_slices);
    sides = std::max(sides, min_slices);
    Mesh mesh;
    for (int slice = 0; slice < slices; ++slice) {
        const glm::dvec3 outward = on_circle(turn_of_slice(slice, slices));
        for (int side = 0; side < sides; ++side) {
            const double angle = side * glm::two_pi<double>() / sides;
            const glm::dvec3 normal = std::cos(angle) * outward + glm::dvec3(0.0, std::sin(angle), 0.0);
            add_vertex(mesh, ring_radius * outward + tube_radius * normal, normal);
        }
    }
    const auto vertex = [&](int slice, int side) { return static_cast<Index>(slice % slices * sides + side % sides); };
    for (int slice = 0; slice < slices; ++slice) {
        for (int side = 0; side < sides; ++side) {
            add_quad(mesh, vertex(slice, side), vertex(slice + 1, side), vertex(slice + 1, side + 1),
                     vertex(slice, side + 1));
        }
    }
    return mesh;
}

Mesh cylinder_mesh(int slices) {
    slices = std::max(slices, min_slices);
    const glm::dvec3 top(0.0, 1.0, 0.0);
    Mesh mesh;
    for (int slice = 0; slice < slices; ++slice) {
        const glm::dvec3 outward = on_circle(turn_of_slice(slice, slices));
        add_vertex(mesh, outward - top, outward);
        add_vertex(mesh, outward + top, outward);
    }
    for (int slice = 0; slice < slices; ++slice) {
        const Index here = 2 * static_cast<Index>(slice), next = 2 * static_cast<Index>((slice + 1) % slices);
        add_quad(mesh, here, next, next + 1, here + 1);
    }
    add_disc(mesh, 1.0, true, slices);
    add_disc(mesh, -1.0, false, slices);
    return mesh;
}

Mesh cone_mesh(int slices) {
    slices = std::max(slices, min_slices);
    const glm::dvec3 tip(0.0, 1.0, 0.0);
    // The side rises by 2 while its radius shrinks by 1, so its normal points outward by 2 and upward by 1.
    const auto side_normal = [&](double slice) {
        return glm::normalize(2.0 * on_circle(turn_of_slice(slice, slices)) + tip);
    };
    Mesh mesh;
    for (int slice = 0; slice < slices; ++slice) {
        add_vertex(mesh, on_circle(turn_of_slice(slice, slices)) - tip, side_normal(slice));
        add_vertex(mesh, tip, side_normal(slice + 0.5));  // one tip per slice: no single normal is right for all
    }
    for (int slice = 0; slice < slices; ++slice) {
        const Index here = 2 * static_cast<Index>(slice), next = 2 * static_cast<Index>((slice + 1) % slices);
        add_triangle(mesh, here, next, here + 1);
    }
    add_disc(mesh, -1.0, false, slices);
    return mesh;
}

Mesh quad_mesh() {
    const glm::dvec3 up(0.0, 1.0, 0.0);
    Mesh mesh;
    const Index a = add_vertex(mesh, {-1.0, 0.0, 1.0}, up);
    const Index b = add_vertex(mesh, {1.0, 0.0, 1.0}, up);
    const Index c = add_vertex(mesh, {1.0, 0.0, -1.0}, up);
    const Index d = add_vertex(mesh, {-1.0, 0.0, -1.0}, up);
    add_quad(mesh, a, b, c, d);
    return mesh;
}

Mesh triangle_mesh(const std::array<glm::dvec3, 3>& vertices) {
    Mesh mesh;
    mesh.positions.assign(vertices.begin(), vertices.end());
    mesh.indices = {0, 1, 2};
    const glm::dvec3 a = mesh.positions[0], b = mesh.positions[1], c = mesh.positions[2];
    const glm::dvec3 twice_area = glm::cross(b - a, c - a);
    const double length = glm::length(twice_area);
    mesh.normals.assign(3, length > 0.0 ? twice_area / length : glm::dvec3(0.0, 1.0, 0.0));
    return mesh;
}

void center_and_fit(Mesh& mesh) {
    const Bounds bounds = bounds_of(mesh);
    if (bounds.empty()) {
        return;
    }
    const glm::dvec3 center = bounds.center(), size = bounds.size();
    const double longest = std::max({size.x, size.y, size.z});
    const double scale = longest > 0.0 ? 2.0 / longest : 1.0;
    for (glm::vec3& position : mesh.positions) {
        position = glm::vec3((glm::dvec3(position) - center) * scale);
    }
}

}  // namespace viewing
