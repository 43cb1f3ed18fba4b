#include "ui/parts/links.h"

#include <cmath>
#include <utility>

#include "frame/matrix_symbols.h"

namespace viewing {

using widgets::LetterRole;
using widgets::Links;
using widgets::Role;

namespace {

MatrixCells cells_of(const MatrixSymbols& symbols, const std::array<Links, 16>& links) {
    MatrixCells cells;
    for (std::size_t cell = 0; cell < 16; ++cell) cells[cell] = {symbols[cell], links[cell], false};
    return cells;
}

}  // namespace

MatrixCells shadow_cells(bool by_rows) {
    const MatrixSymbols symbols = shadow_symbols(by_rows);
    MatrixCells cells;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            const auto cell = static_cast<std::size_t>(4 * row + column);
            const int of_light = by_rows ? column : row, of_plane = by_rows ? row : column;
            const Links links =
                row == column ? link::all_light | link::all_plane : link::light[of_light] | link::plane[of_plane];
            cells[cell] = {symbols[cell], links, false, link::shadow_entry(static_cast<int>(cell))};
        }
    return cells;
}

MatrixCells mirror_cells(bool printed_by_rows, bool plus_2ab) {
    const Links* p = link::plane;
    // The links are symmetric except for the last column, which becomes the last row of the transpose.
    std::array<Links, 16> links{p[0],        p[0] | p[1], p[0] | p[2], p[0] | p[3],  //
                                p[0] | p[1], p[1],        p[1] | p[2], p[1] | p[3],  //
                                p[0] | p[2], p[1] | p[2], p[2],        p[2] | p[3],  //
                                0,           0,           0,           0};
    for (std::size_t i = 0; printed_by_rows && i < 3; ++i) std::swap(links[4 * i + 3], links[12 + i]);
    MatrixCells cells = cells_of(mirror_symbols(printed_by_rows, plus_2ab), links);
    for (int cell = 0; cell < 16; ++cell) cells[cell].own = link::mirror_entry(cell);
    return cells;
}

MatrixCells view_cells(bool swapped_order) {
    const Links turning = link::turning;
    const Links all = turning | link::position[0] | link::position[1] | link::position[2];
    const auto last = [&](int row) { return swapped_order ? link::position[row] : all; };
    return cells_of(view_symbols(swapped_order), {turning, turning, turning, last(0),  //
                                                  turning, turning, turning, last(1),  //
                                                  turning, turning, turning, last(2),  //
                                                  0, 0, 0, 0});
}

MatrixCells camera_cells(bool swapped_order) {
    const Links turning = link::turning;
    const Links all = turning | link::position[0] | link::position[1] | link::position[2];
    const auto last = [&](int row) { return swapped_order ? all : link::position[row]; };
    return cells_of(camera_symbols(swapped_order), {turning, turning, turning, last(0),  //
                                                    turning, turning, turning, last(1),  //
                                                    turning, turning, turning, last(2),  //
                                                    0, 0, 0, 0});
}

MatrixCells projection_cells(const Params& params, bool clip_zero_to_one) {
    const bool orthographic = params.projection.is_orthographic(), has_window = params.projection.has_window();
    const Links size = orthographic ? link::height : link::fovy, range = link::near | link::far | link::mapping;
    const Links scale = has_window && !orthographic ? link::near : has_window ? 0 : size;
    const Links wide = scale | (has_window ? link::window_x : 0), high = scale | (has_window ? link::window_y : 0);
    const auto shift = [&](Links edges, bool is_here) { return has_window && is_here ? edges : Links{0}; };
    const Links x_by_z = shift(link::window_x, !orthographic), x_by_w = shift(link::window_x, orthographic);
    const Links y_by_z = shift(link::window_y, !orthographic), y_by_w = shift(link::window_y, orthographic);
    return cells_of(projection_symbols(params, clip_zero_to_one), {wide, 0, x_by_z, x_by_w,  //
                                                                   0, high, y_by_z, y_by_w,  //
                                                                   0, 0, range, range,       //
                                                                   0, 0, link::type, link::type});
}

void mark_changed(MatrixCells& cells, const glm::dmat4& now, const glm::dmat4& before) {
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            cells[4 * row + column].changed = std::abs(now[column][row] - before[column][row]) >= 0.0005;
}

std::span<const LetterRole> shadow_roles() {
    static constexpr LetterRole roles[] = {
        {'l', Role::light}, {'L', Role::light}, {'n', Role::plane}, {'d', Role::plane}, {U'Π', Role::plane}};
    return roles;
}

std::span<const LetterRole> mirror_roles() {
    static constexpr LetterRole roles[] = {
        {'a', Role::plane}, {'b', Role::plane}, {'c', Role::plane}, {'d', Role::plane}};
    return roles;
}

std::span<const LetterRole> camera_roles() {
    static constexpr LetterRole roles[] = {{'n', Role::camera}, {'f', Role::camera}, {'h', Role::camera},
                                           {'l', Role::camera}, {'r', Role::camera}, {'b', Role::camera},
                                           {'t', Role::camera}};
    return roles;
}

}  // namespace viewing
