#include "lesson/questions/other_row.h"

#include <algorithm>
#include <array>
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

/// Returns L_i from row i of S, whose off-diagonal entries are −L_i Π_j. None if the entries do not have this form, if
/// the whole row is 0, or if every Π_j with j ≠ i is 0.
std::optional<double> light_at(const glm::dvec4& row, int index, const glm::dvec4& plane) {
    glm::dvec4 beside = plane, entries = row;
    beside[index] = entries[index] = 0.0;
    const double size = glm::dot(beside, beside);
    if (size == 0.0 || row == glm::dvec4(0.0)) return std::nullopt;
    const double number = -glm::dot(entries, beside) / size;
    if (glm::length(entries + number * beside) > tolerance) return std::nullopt;
    return number;
}

/// Returns the light given by the off-diagonal entries; a coordinate that its row does not determine comes from
/// `asked`.
glm::dvec4 light_of_rows(const std::array<glm::dvec4, 4>& rows, const glm::dvec4& plane, const glm::dvec4& asked) {
    glm::dvec4 light = asked;
    for (int i = 0; i < 4; ++i) light[i] = light_at(rows[i], i, plane).value_or(asked[i]);
    return light;
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

std::optional<glm::dvec4> light_of_shadow_row(const glm::dvec4& row, int index, const glm::dvec4& plane,
                                              const glm::dvec4& others) {
    const std::optional<double> at_index = light_at(row, index, plane);
    if (!at_index) return std::nullopt;
    glm::dvec4 light = others;
    light[index] = *at_index;
    const double missing = row[index] - (glm::dot(plane, light) - plane[index] * light[index]);
    if (std::abs(missing) > tolerance) {
        int counting = -1, count = 0;
        for (int j = 0; j < 3; ++j)
            if (j != index && plane[j] != 0.0) {
                counting = j;
                ++count;
            }
        if (count != 1) return std::nullopt;
        light[counting] += missing / plane[counting];
    }
    if (glm::length(light) <= tolerance) return std::nullopt;
    return light;
}

std::optional<OtherRow> other_row(const std::vector<double>& numbers, const std::vector<int>& right_rows,
                                  const std::string& expect, const Surroundings& surroundings) {
    const auto is_same = [&](const std::string& matrix) {
        const Result<bool> same = holds("close(" + expect + ", " + matrix + ", 1e-6)", surroundings);
        return same && *same;
    };
    const bool is_mirror = is_same("reflection_matrix(unit(plane.equation))");
    const bool is_empty = std::count(numbers.begin(), numbers.end(), 0.0) == std::ssize(numbers);
    if (is_empty || numbers.size() != 16 ||
        (!is_mirror && !is_same("shadow_matrix(unit(plane.equation), light.position)")))
        return std::nullopt;
    const auto vector_of = [&](const char* expression) {
        const Result<Json> value = evaluate(expression, surroundings);
        glm::dvec4 vector(0.0);
        for (int i = 0; value && i < 4; ++i) vector[i] = (*value)[i].get<double>();
        return vector;
    };
    const glm::dvec4 asked = vector_of("unit(plane.equation)"), light = vector_of("light.position");
    std::array<glm::dvec4, 4> rows;
    for (std::size_t i = 0; i < 16; ++i) rows[i / 4][static_cast<int>(i % 4)] = numbers[i];
    const glm::dvec4 whole = light_of_rows(rows, asked, light);
    for (int index = 0; index < 4; ++index) {
        if (std::find(right_rows.begin(), right_rows.end(), index + 1) != right_rows.end()) continue;
        const glm::dvec4& row = rows[index];
        const std::optional<glm::dvec4> plane =
            is_mirror ? plane_of_mirror_row(row, index) : plane_of_shadow_row(row, index, light, asked);
        if (plane && !are_same(*plane, asked)) return OtherRow{index + 1, false, *plane};
        if (is_mirror) continue;
        const std::optional<glm::dvec4> other = light_of_shadow_row(row, index, asked, whole);
        if (other && glm::length(*other - light) > 2.0 * tolerance) return OtherRow{index + 1, true, *other};
    }
    return std::nullopt;
}

}  // namespace viewing
