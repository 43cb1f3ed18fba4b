#include "lesson/other_plane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace viewing {
namespace {

constexpr double tolerance = 0.01;  // entries are typed with two or more decimals

std::optional<glm::dvec4> if_unit(const glm::dvec4& plane) {
    if (std::abs(glm::length(glm::dvec3(plane)) - 1.0) > tolerance) return std::nullopt;
    return plane;
}

glm::dvec4 unit_vector(int index) {
    glm::dvec4 vector(0.0);
    vector[index] = 1.0;
    return vector;
}

bool are_same(const glm::dvec4& a, const glm::dvec4& b) {
    return glm::length(a - b) <= 2.0 * tolerance || glm::length(a + b) <= 2.0 * tolerance;
}

}  // namespace

std::optional<glm::dvec4> plane_of_mirror_row(const glm::dvec4& row, int index) {
    const glm::dvec4 product = (unit_vector(index) - row) / 2.0;  // n_i (n, d)
    if (index == 3 || product[index] <= 0.0) return std::nullopt;
    return if_unit(product / std::sqrt(product[index]));
}

std::optional<glm::dvec4> plane_of_shadow_row(const glm::dvec4& row, int index, const glm::dvec4& light,
                                              const glm::dvec4& asked) {
    if (light[index] == 0.0) return std::nullopt;
    glm::dvec4 plane = -row / light[index];
    plane[index] = asked[index];
    const double diagonal = glm::dot(plane, light) - light[index] * plane[index];
    if (std::abs(row[index] - diagonal) > tolerance) return std::nullopt;
    return if_unit(plane);
}

std::optional<OtherPlane> other_plane(const std::vector<double>& numbers, const std::vector<int>& right_rows,
                                      const std::string& expect, const Surroundings& surroundings) {
    const auto is_same = [&](const std::string& matrix) {
        const Result<bool> same = holds("close(" + expect + ", " + matrix + ", 1e-6)", surroundings);
        return same && *same;
    };
    const bool is_mirror = is_same("reflection_matrix(unit(plane.equation))");
    if (numbers.size() != 16 || (!is_mirror && !is_same("shadow_matrix(unit(plane.equation), light.position)")))
        return std::nullopt;
    const auto vector_of = [&](const char* expression) {
        const Result<Json> value = evaluate(expression, surroundings);
        glm::dvec4 vector(0.0);
        for (int i = 0; value && i < 4; ++i) vector[i] = (*value)[static_cast<std::size_t>(i)].get<double>();
        return vector;
    };
    const glm::dvec4 asked = vector_of("unit(plane.equation)"), light = vector_of("light.position");
    for (int index = 0; index < 4; ++index) {
        if (std::find(right_rows.begin(), right_rows.end(), index + 1) != right_rows.end()) continue;
        const double* const first = numbers.data() + 4 * index;
        const glm::dvec4 row(first[0], first[1], first[2], first[3]);
        const std::optional<glm::dvec4> plane =
            is_mirror ? plane_of_mirror_row(row, index) : plane_of_shadow_row(row, index, light, asked);
        if (plane && !are_same(*plane, asked)) return OtherPlane{index + 1, *plane};
    }
    return std::nullopt;
}

}  // namespace viewing
