// A row of an entered R or S that is right for a plane or light other than the question's.
#pragma once

#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lesson/formulas/expression.h"

namespace viewing {

/// Returns the plane (a, b, c, d), with a unit normal, for which `row` is row `index` of R, counted from 0. n_i is
/// taken as positive, since (n, d) and (−n, −d) are the same mirror. None for row 3, which is (0, 0, 0, 1) for every
/// plane, and if there is no such plane. Source: lecture, Planar Reflection: row i is e_i − 2 n_i (n, d).
std::optional<glm::dvec4> plane_of_mirror_row(const glm::dvec4& row, int index);

/// Returns the plane, with a unit normal, for which `row` is row `index` of this light's S, counted from 0. The row
/// does not determine the plane's number at `index`, which is therefore taken from `asked`. None if there is no such
/// plane or L_i is 0. Source: lecture, Projection Shadow Matrix: row i is (Π·L) e_i − L_i Π.
std::optional<glm::dvec4> plane_of_shadow_row(const glm::dvec4& row, int index, const glm::dvec4& light,
                                              const glm::dvec4& asked);

/// Returns the light for which `row` is row `index` of S on this plane, counted from 0. The plane has a unit normal.
/// The row determines L_i and Π·L. `others` gives the light's other numbers; if they give a different Π·L, one of
/// the light's x, y, z is adapted, provided that exactly one of them, apart from L_i, affects Π·L. None if there is no
/// such light, and for a row of zeros.
std::optional<glm::dvec4> light_of_shadow_row(const glm::dvec4& row, int index, const glm::dvec4& plane,
                                              const glm::dvec4& others);

struct OtherRow {
    int row = 0;            ///< from 1
    bool is_light = false;  ///< true: `numbers` is a light's position; false: a plane with a unit normal
    glm::dvec4 numbers{0.0};
};

/// Finds, in the 4×4 matrix with these 16 numbers, the first row that is not among `right_rows` (counted from 1) and
/// belongs to a plane other than `plane.equation` or, for S, to a light other than `light.position`. None if `expect`
/// is neither the R nor the S of `plane.equation` and `light.position`.
std::optional<OtherRow> other_row(const std::vector<double>& numbers, const std::vector<int>& right_rows,
                                  const std::string& expect, const Surroundings& surroundings);

}  // namespace viewing
