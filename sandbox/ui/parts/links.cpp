#include "ui/parts/links.h"

#include <cmath>
#include <utility>

namespace viewing {

using widgets::LetterRole;
using widgets::Links;
using widgets::Role;

namespace {

MatrixCells cells_of(const std::array<const char*, 16>& symbols, const std::array<Links, 16>& links) {
    MatrixCells cells;
    for (std::size_t cell = 0; cell < 16; ++cell) cells[cell] = {symbols[cell], links[cell], false};
    return cells;
}

}  // namespace

MatrixCells shadow_cells() {
    static constexpr std::array<const char*, 16> symbols = {
        "Π·L - l_x n_x", "-l_x n_y",      "-l_x n_z",      "-l_x d",  //
        "-l_y n_x",      "Π·L - l_y n_y", "-l_y n_z",      "-l_y d",  //
        "-l_z n_x",      "-l_z n_y",      "Π·L - l_z n_z", "-l_z d",  //
        "-l_w n_x",      "-l_w n_y",      "-l_w n_z",      "Π·L - l_w d"};
    MatrixCells cells;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            const auto cell = static_cast<std::size_t>(4 * row + column);
            const Links links =
                row == column ? link::all_light | link::all_plane : link::light[row] | link::plane[column];
            cells[cell] = {symbols[cell], links, false, link::shadow_entry(static_cast<int>(cell))};
        }
    return cells;
}

MatrixCells mirror_cells(bool printed_by_rows, bool plus_2ab) {
    const Links* p = link::plane;
    MatrixCells cells = cells_of({"1 - 2a^2", "-2ab", "-2ac", "-2ad",  //
                                  "-2ab", "1 - 2b^2", "-2bc", "-2bd",  //
                                  "-2ac", "-2bc", "1 - 2c^2", "-2cd",  //
                                  "0", "0", "0", "1"},
                                 {p[0], p[0] | p[1], p[0] | p[2], p[0] | p[3],  //
                                  p[0] | p[1], p[1], p[1] | p[2], p[1] | p[3],  //
                                  p[0] | p[2], p[1] | p[2], p[2], p[2] | p[3],  //
                                  0, 0, 0, 0});
    if (plus_2ab) cells[4].symbol = "+2ab";
    for (std::size_t row = 0; printed_by_rows && row < 4; ++row)
        for (std::size_t column = 0; column < row; ++column)
            std::swap(cells[4 * row + column], cells[4 * column + row]);
    for (int cell = 0; cell < 16; ++cell) cells[static_cast<std::size_t>(cell)].own = link::mirror_entry(cell);
    return cells;
}

MatrixCells view_cells(bool swapped_order) {
    const Links turning = link::turning;
    const Links all = turning | link::position[0] | link::position[1] | link::position[2];
    MatrixCells cells = cells_of({"right_x", "right_y", "right_z", "-right·eye",  //
                                  "up_x", "up_y", "up_z", "-up·eye",              //
                                  "back_x", "back_y", "back_z", "-back·eye",      //
                                  "0", "0", "0", "1"},
                                 {turning, turning, turning, all,  //
                                  turning, turning, turning, all,  //
                                  turning, turning, turning, all,  //
                                  0, 0, 0, 0});
    static constexpr const char* unturned[] = {"-eye_x", "-eye_y", "-eye_z"};
    for (std::size_t row = 0; swapped_order && row < 3; ++row)
        cells[4 * row + 3] = {unturned[row], link::position[row], false};
    return cells;
}

MatrixCells camera_cells(bool swapped_order) {
    const Links turning = link::turning;
    const Links all = turning | link::position[0] | link::position[1] | link::position[2];
    MatrixCells cells = cells_of({"right_x", "up_x", "back_x", "eye_x",  //
                                  "right_y", "up_y", "back_y", "eye_y",  //
                                  "right_z", "up_z", "back_z", "eye_z",  //
                                  "0", "0", "0", "1"},
                                 {turning, turning, turning, link::position[0],  //
                                  turning, turning, turning, link::position[1],  //
                                  turning, turning, turning, link::position[2],  //
                                  0, 0, 0, 0});
    static constexpr const char* turned[] = {"(R eye)_x", "(R eye)_y", "(R eye)_z"};
    for (std::size_t row = 0; swapped_order && row < 3; ++row) cells[4 * row + 3] = {turned[row], all, false};
    return cells;
}

MatrixCells projection_cells(const Params& params, bool clip_zero_to_one) {
    const bool orthographic = params.projection.type == ProjectionType::orthographic;
    const bool reversed = params.depth.mapping == DepthMapping::reversed;
    const char *scale = "c", *depth_scale = "(f+n)/(n-f)", *depth_shift = "2fn/(n-f)";
    if (orthographic) {
        scale = "2/h";
        depth_scale = "2/(n-f)";
        depth_shift = "(f+n)/(n-f)";
    }
    if (reversed) {
        depth_scale = orthographic ? "2/(f-n)" : "(f+n)/(f-n)";
        depth_shift = orthographic ? "(f+n)/(f-n)" : "2fn/(f-n)";
        if (clip_zero_to_one) {
            depth_scale = orthographic ? "1/(f-n)" : "n/(f-n)";
            depth_shift = orthographic ? "f/(f-n)" : "fn/(f-n)";
        }
    }
    const Links size = orthographic ? link::height : link::fovy;
    const Links range = link::near | link::far | link::mapping;
    return cells_of({orthographic ? "2/(h·aspect)" : "c/aspect", "0", "0", "0",  //
                     "0", scale, "0", "0",                                       //
                     "0", "0", depth_scale, depth_shift,                         //
                     "0", "0", orthographic ? "0" : "-1", orthographic ? "1" : "0"},
                    {size, 0, 0, 0,       //
                     0, size, 0, 0,       //
                     0, 0, range, range,  //
                     0, 0, link::type, link::type});
}

void mark_changed(MatrixCells& cells, const glm::dmat4& now, const glm::dmat4& before) {
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            cells[static_cast<std::size_t>(4 * row + column)].changed =
                std::abs(now[column][row] - before[column][row]) >= 0.0005;
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
    static constexpr LetterRole roles[] = {{'n', Role::camera}, {'f', Role::camera}, {'h', Role::camera}};
    return roles;
}

}  // namespace viewing
