// What the views' tables have in common.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "ui/parts/look.h"

namespace viewing {

/// Around the content of a table's cells, design pixels.
constexpr float cell_padding_x = 5.0F, cell_padding_y = 1.0F;

/// Of each column of a table without what is around it, pixels; 0 for those that are left out.
template <std::size_t count>
struct ColumnWidths : std::array<float, count> {
    /// With what is around them.
    float sum() const {
        float sum = 0.0F;
        for (const float width : *this) sum += width > 0.0F ? width + 2.0F * px(cell_padding_x) : 0.0F;
        return sum;
    }
};

/// Pixels.
float width_of(const std::string& text, ImFont* font);

/// At the right end of its cell, or from the left where it does not fit.
void text_at_right(const std::string& text);

/// What is too wide is told in brief, or where there is nothing briefer by widgets::Shortened; then a tooltip has the
/// whole.
void shortened_text(const std::string& text, float width, const std::string& brief = "");

}  // namespace viewing
