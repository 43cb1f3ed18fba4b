#include "topics/depth/shown/cell_layout.h"

#include <algorithm>
#include <cmath>

#include "ui/parts/look.h"

namespace viewing {
namespace {

// Design pixels.
constexpr float margin_x = 8.0F, margin_y = 6.0F;
constexpr float row = 22.0F, row_gap = 3.0F, below_rows = 1.0F;
constexpr float caption_line = 14.0F, line = 15.0F, two_lines = 26.0F, large_line = 21.0F;
constexpr float grid_margin = 4.0F;  ///< CellGrid's own margin
constexpr float least_side = 36.5F, least_side_where_low = 29.0F;
constexpr float cells_on_a_side = 9.0F;  ///< at most this many along the shorter side

/// Cuts the rows of controls off the top of `room`; returns the rest.
Rect take_controls(CellLayout& layout, Rect room, float width, float height) {
    layout.has_step_bar = width >= 600.0F;
    layout.has_calls = width >= 380.0F || height >= 200.0F;
    layout.calls_above = layout.has_calls && (width < 380.0F || (width >= 600.0F && width < 900.0F));
    layout.calls = layout.steps = {room.min, {room.max.x, room.min.y + px(row)}};
    if (layout.calls_above) {
        const float down = px(row + row_gap);
        layout.steps = {{room.min.x, room.min.y + down}, {room.max.x, layout.calls.max.y + down}};
    } else if (layout.has_calls) {
        layout.calls.max.x = room.min.x + std::floor(layout.has_step_bar ? px(320.0F) : 0.52F * room.width());
        layout.steps.min.x = layout.calls.max.x + px(8.0F);
    }
    room.min.y = layout.steps.max.y + px(below_rows);
    return room;
}

/// The size of small text relative to its usual size.
float type_scale() {
    return widgets::HasPlainTitles() ? stage_type.small / TypeSizes{}.small : 1.0F;
}

int count_that_fits(float length, float side) {
    return std::clamp(static_cast<int>(std::floor((length - 2.0F * px(grid_margin)) / side)), 1, 16);
}

}  // namespace

CellLayout lay_out_cells(const Rect& rect) {
    CellLayout layout;
    Rect room{{rect.min.x + px(margin_x), rect.min.y + px(margin_y)},
              {std::max(rect.max.x - px(margin_x), rect.min.x + px(margin_x)),
               std::max(rect.max.y - px(margin_y), rect.min.y + px(margin_y))}};
    const float design = px(1.0F), width = room.width() / design, height = room.height() / design;
    const bool is_low = height < 170.0F, is_large = width >= 900.0F && height >= 400.0F;
    room = take_controls(layout, room, width, height);

    const float type = type_scale();
    const float sentence = px(is_large ? large_line : type * (is_low || width >= 600.0F ? line : two_lines));
    layout.sentence = {{room.min.x, std::max(room.max.y - sentence, room.min.y)}, room.max};
    layout.caption_height = is_low ? 0.0F : px(is_large ? large_line : type * caption_line);
    const float top = room.min.y + layout.caption_height, bottom = std::max(layout.sentence.min.y, top);
    const float each = std::floor(0.5F * (room.width() - px(8.0F)));
    layout.colors = {{room.min.x, top}, {room.min.x + each, bottom}};
    layout.depths = {{room.max.x - each, top}, {room.max.x, bottom}};

    const float shortest = std::min(layout.colors.width(), layout.colors.height()) - 2.0F * px(grid_margin);
    const auto side = [&](float least) { return std::max(px(type * least), shortest / cells_on_a_side); };
    // When presenting, a low view has fewer columns, so that each cell has space for all its digits.
    const float high = side(is_low ? least_side_where_low : least_side);
    const float wide = widgets::HasPlainTitles() ? side(least_side) : high;
    layout.block = {count_that_fits(layout.colors.width(), wide), count_that_fits(layout.colors.height(), high)};
    return layout;
}

}  // namespace viewing
