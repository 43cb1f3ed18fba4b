// Internal to state/: cutting a polygon into triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace viewing {

/// Appends count − 2 triangles as indices into `corners`, wound as the polygon is. The polygon may be concave and
/// slightly out of plane; of more than 256 corners it is taken as convex. Source: Meisters 1975, ear clipping.
void triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles);

}  // namespace viewing
