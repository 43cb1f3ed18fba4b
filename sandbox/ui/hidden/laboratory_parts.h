// What the laboratory's views in the lower right have in common.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "ui/hidden/laboratory.h"
#include "ui/parts/look.h"

namespace viewing {

/// The camera's result, null while there is none.
const std::shared_ptr<const HiddenResult>& shown_result(const HiddenStatus& hidden);

/// A view's child window over its rectangle, on the views' ground; ends with its scope.
struct LaboratoryView {
    LaboratoryView(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);
    ~LaboratoryView();
    LaboratoryView(const LaboratoryView&) = delete;
    LaboratoryView& operator=(const LaboratoryView&) = delete;
};

/// How high a widgets::Note is in the room that there is, pixels.
float note_height(const char* text);

/// A sentence in the middle of the view and, unless null, a button below it. True when it was clicked.
bool offer(const char* sentence, const char* button = nullptr);

/// "The method is at work: 40 %": instead of a view whose method has not finished.
void tell_waiting(const HiddenStatus& hidden);

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

}  // namespace viewing
