#include "lesson/questions/typed_matrix.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "lesson/step_reader.h"
#include "state/file/state_json.h"
#include "text/numbers.h"

namespace viewing {
namespace {

/// Returns the w of (0, 0.5, 0), a point in the middle of the scene.
double w_of_middle(const glm::dmat4& matrix) {
    return (matrix * glm::dvec4(0.0, 0.5, 0.0, 1.0)).w;
}

/// Reads a list of four rows of four numbers.
Result<glm::dmat4> matrix_of(const Json& rows) {
    glm::dmat4 matrix(0.0);
    bool fits = rows.is_array() && rows.size() == 4;
    for (std::size_t row = 0; fits && row < 4; ++row) {
        fits = rows[row].is_array() && rows[row].size() == 4;
        for (std::size_t column = 0; fits && column < 4; ++column) {
            fits = rows[row][column].is_number();
            if (fits) matrix[static_cast<int>(column)][static_cast<int>(row)] = rows[row][column].get<double>();
        }
    }
    if (!fits) return Error{"must be a 4 by 4 matrix, got " + describe(rows)};
    return matrix;
}

bool is_of_camera(const Ask& ask) {
    return ask.shows_as == "C" || ask.shows_as == "V";
}

/// Returns whether a matrix only rotates and translates, up to the rounding of typed numbers.
bool is_rigid(const glm::dmat4& matrix) {
    constexpr double tolerance = 1e-3;
    const glm::dmat3 axes(matrix);
    const glm::dmat3 off = glm::transpose(axes) * axes - glm::dmat3(1.0);
    double worst = std::abs(glm::determinant(axes) - 1.0);
    for (int i = 0; i < 9; ++i) worst = std::max(worst, std::abs(off[i / 3][i % 3]));
    for (int column = 0; column < 4; ++column)
        worst = std::max(worst, std::abs(matrix[column].w - (column == 3 ? 1.0 : 0.0)));
    return worst <= tolerance;
}

/// Returns the start with a camera that has this matrix as its C or V.
Result<LoadedState> with_camera(const LessonStep& step, const glm::dmat4& matrix) {
    if (!is_rigid(matrix)) return Error{"no camera has this matrix: it does not only rotate and move"};
    const glm::dmat4 world_from_view = step.ask.shows_as == "V" ? glm::inverse(matrix) : matrix;
    LoadedState state = step.start;
    CameraParams& camera = state.params.camera;
    const Angles angles = angles_from_rotation(glm::dmat3(world_from_view));
    camera.position = glm::dvec3(world_from_view[3]);
    camera.yaw = angles.yaw_deg;
    camera.pitch = angles.pitch_deg;
    camera.roll = angles.roll_deg;
    return state;
}

}  // namespace

void check_shown_matrix(const Ask& ask, const Where& where) {
    if (!ask.factors.empty() && ask.factors.size() != ask.items.size())
        where.key("factors").refuse("must have one expression for each item");
    if (!ask.shows_as.empty() && !is_of_camera(ask) && !find_field(ask.shows_as))
        refuse_unknown({where.prefix, ask.shows_as});
}

glm::dmat4 matrix_of_rows(const std::vector<double>& numbers) {
    glm::dmat4 matrix(0.0);
    for (int i = 0; i < 16; ++i) matrix[i % 4][i / 4] = numbers[i];
    return matrix;
}

Result<std::vector<glm::dmat4>> products_of(const Ask& ask, const std::vector<int>& items,
                                            const Surroundings& surroundings) {
    std::vector<glm::dmat4> products;
    glm::dmat4 product(1.0);
    for (const int item : items) {
        const Result<Json> value = evaluate(ask.factors[item], surroundings);
        const Result<glm::dmat4> factor = value ? matrix_of(*value) : Error{value.error()};
        if (!factor) return Error{factor.error()};
        product *= *factor;
        products.push_back(product);
    }
    return products;
}

LoadedState with_right_matrix(const LessonStep& step) {
    LoadedState state = step.start;
    state.params.shadow.clip_to_receiver = false;
    return state;
}

Result<LoadedState> with_typed_matrix(const LessonStep& step, const glm::dmat4& matrix) {
    if (is_of_camera(step.ask)) return with_camera(step, matrix);
    const double sign = step.ask.up_to_factor && w_of_middle(matrix) < 0.0 ? -1.0 : 1.0;
    std::string rows;
    for (int i = 0; i < 16; ++i)
        rows += std::string(i == 0 ? "[[" : i % 4 == 0 ? "], [" : ", ") + format_number(sign * matrix[i % 4][i / 4]);
    LoadedState state = with_right_matrix(step);
    const std::vector<std::string> setting{step.ask.shows_as + "=" + rows + "]]"};
    Result<Params> changed = apply_settings(state.params, setting);
    if (!changed) return Error{changed.error()};
    state.params = *std::move(changed);
    return state;
}

}  // namespace viewing
