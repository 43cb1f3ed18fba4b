// Shared parts of the views' tables.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "ui/parts/look.h"

namespace viewing {

/// The padding of a table's cells, in design pixels.
constexpr float cell_padding_x = 5.0F, cell_padding_y = 1.0F;

/// The widths of a table's columns without padding, in pixels; 0 for omitted columns.
template <std::size_t count>
struct ColumnWidths : std::array<float, count> {
    /// Returns the width of the whole table, including the padding.
    float sum() const {
        float sum = 0.0F;
        for (const float width : *this) sum += width > 0.0F ? width + 2.0F * px(cell_padding_x) : 0.0F;
        return sum;
    }
};

/// Returns the padding above and below the cells of `rows` lines in the current font, in pixels. On stage, the lines
/// spread over `height`, up to three times their usual distance.
float padding_to_fill(int rows, float height);

/// Returns the width of a text in pixels.
float width_of(const std::string& text, ImFont* font);

/// Draws text right-aligned in its cell, or left-aligned if it does not fit.
void text_at_right(const std::string& text);

/// Draws a text. If it is too wide, draws `brief` instead or, if that is empty, a shortened form; a tooltip then shows
/// the whole text.
void shortened_text(const std::string& text, float width, const std::string& brief = "");

}  // namespace viewing
