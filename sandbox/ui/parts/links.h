// Assigns a bit to each parameter, so that a matrix entry can highlight the controls that it depends on, and vice
// versa. Also returns the lecture's symbols for the entries of S, R, V, C, and P.
#pragma once

#include <array>

#include "frame/derive.h"
#include "widgets/widgets.h"

namespace viewing {

namespace link {
using widgets::Links;
constexpr Links bit(int index) {
    return Links{1} << index;
}
constexpr Links light[4] = {bit(0), bit(1), bit(2), bit(3)};
constexpr Links plane[4] = {bit(4), bit(5), bit(6), bit(7)};
constexpr Links position[3] = {bit(8), bit(9), bit(10)};
constexpr Links yaw = bit(11), pitch = bit(12), roll = bit(13);
constexpr Links fovy = bit(14), near = bit(15), far = bit(16), height = bit(17), type = bit(18), mapping = bit(19);
constexpr Links window_x = bit(52), window_y = bit(53);  // left and right, bottom and top
constexpr Links all_light = light[0] | light[1] | light[2] | light[3];
constexpr Links all_plane = plane[0] | plane[1] | plane[2] | plane[3];
constexpr Links turning = yaw | pitch | roll;
/// The bits of the entries themselves; `cell` = 4 · row + column.
constexpr Links shadow_entry(int cell) {
    return bit(20 + cell);
}
constexpr Links mirror_entry(int cell) {
    return bit(36 + cell);
}
}  // namespace link

using MatrixCells = std::array<widgets::MatrixCell, 16>;

/// Returns the symbol and the links of each entry, row by row.
MatrixCells shadow_cells(bool by_rows = false);
/// `printed_by_rows`: the transpose, which GL receives from the slide's code. `plus_2ab`: with the slides' mistake
/// +2ab.
MatrixCells mirror_cells(bool printed_by_rows = false, bool plus_2ab = false);
/// `swapped_order`: with the mistake C = R T.
MatrixCells view_cells(bool swapped_order);
MatrixCells camera_cells(bool swapped_order);
MatrixCells projection_cells(const Params& params, bool clip_zero_to_one);

/// Marks the entries whose displayed numbers differ between the two matrices.
void mark_changed(MatrixCells& cells, const glm::dmat4& now, const glm::dmat4& before);

/// The roles of letters. In S, l and L belong to the light, and n, d, and Π to the plane. In R, a to d belong to the
/// plane. In P, n, f, h, and the window's l, r, b, and t belong to the camera.
std::span<const widgets::LetterRole> shadow_roles();
std::span<const widgets::LetterRole> mirror_roles();
std::span<const widgets::LetterRole> camera_roles();

}  // namespace viewing
