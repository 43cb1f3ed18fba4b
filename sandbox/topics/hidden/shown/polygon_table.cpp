#include "topics/hidden/shown/polygon_table.h"

#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"

namespace viewing {
namespace {

/// On stage, a list that fits in the type of sentences uses that type, because a lesson's step refers to the list's
/// numbers.
ImFont* font_of(int lines, ImVec2 room) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    constexpr float least_width = 300.0F;  // enough for "box, polygon 12" and "nearest vertex", design pixels
    const float height = static_cast<float>(lines) * (fonts.caption->FontSize + 2.0F * px(cell_padding_y));
    return widgets::HasPlainTitles() && room.x >= px(least_width) && room.y >= height ? fonts.caption : fonts.note;
}

/// Draws a swatch of the object's color before the polygon's name.
void swatch(const OrderRow& row) {
    const float side = std::round(0.6F * ImGui::GetTextLineHeight());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y + std::round((ImGui::GetTextLineHeight() - side) * 0.5F);
    const ImU32 color = row.is_reached || row.color == 0 ? row.color : with_alpha(row.color, 90);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side}, color, px(2.0F));
    ImGui::Dummy({side, side});
    ImGui::SameLine(0.0F, px(5.0F));
}

}  // namespace

PolygonTable::PolygonTable(PolygonLinks& links, const HiddenResult& result, const char* id, const char* detail,
                           int count, ImVec2 size)
    : links_(links), has_tree_(result.tree != nullptr), has_detail_(*detail != '\0') {
    const ImVec2 available = ImGui::GetContentRegionAvail();
    const ImVec2 room(size.x > 0.0F ? size.x : available.x, size.y > 0.0F ? size.y : available.y);
    const int lines = count + 1;  // with the titles
    ImGui::PushFont(font_of(lines, room));
    padding_px_ = padding_to_fill(lines, room.y);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {px(4.0F), padding_px_});
    // On stage, rows that are far apart have lines between them, which lead the eye from a name to its number.
    const ImGuiTableFlags lines_between = padding_px_ > px(cell_padding_y) ? ImGuiTableFlags_BordersInnerH : 0;
    is_open_ = ImGui::BeginTable(id, has_detail_ ? 3 : 2, ImGuiTableFlags_ScrollY | lines_between, size);
    if (!is_open_) return;
    const float number_width = ImGui::CalcTextSize(std::to_string(count).c_str()).x + px(8.0F);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, number_width);
    ImGui::TableSetupColumn(widgets::LabelText(marked("polygon")).c_str(), ImGuiTableColumnFlags_WidthStretch);
    if (has_detail_) ImGui::TableSetupColumn(widgets::LabelText(detail).c_str(), ImGuiTableColumnFlags_WidthFixed);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().quiet);
    // Do not use TableHeadersRow(): it clips a title that is a fraction of a pixel wider than its column. Do not use a
    // row with ImGuiTableRowFlags_Headers either: its texts do not widen columns.
    ImGui::TableNextRow(0, row_height());
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, palette().view_ground);
    ImGui::TableSetColumnIndex(1);
    ImGui::TextUnformatted(tr("polygon"));
    if (has_detail_) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(tr(detail));  // left-aligned, so that it sets the column's width
    }
    ImGui::PopStyleColor();
}

PolygonTable::~PolygonTable() {
    if (is_open_) {
        widgets::CountScrolled();
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

float PolygonTable::row_height() const {
    return ImGui::GetTextLineHeight() + 2.0F * padding_px_;
}

void PolygonTable::scroll_to(int place) const {
    const float height = row_height(), top = static_cast<float>(place) * height;
    const float room = ImGui::GetWindowHeight() - 2.0F * height;  // below the header
    const float at = ImGui::GetScrollY();
    if (top < at || top > at + room - height) ImGui::SetScrollY(std::max(0.0F, top - 0.4F * room));
}

bool PolygonTable::row(int number, const OrderRow& row) {
    ImGui::TableNextRow(0, row_height());
    ImGui::PushID(number);
    const bool is_lit = row.fragment >= 0 && row.fragment == links_.now.hovered_fragment;
    if (row.is_current || is_lit)
        ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, with_alpha(palette().accent, row.is_current ? 90U : 45U));
    const bool is_plain = row.is_reached || row.is_current;
    ImGui::PushStyleColor(ImGuiCol_Text, is_plain ? palette().text : palette().quiet);
    ImGui::TableNextColumn();
    const std::string digits = std::to_string(number);
    const bool is_clicked = select(row, digits);
    text_at_right(digits);
    ImGui::TableNextColumn();
    swatch(row);
    shortened_text(row.name, ImGui::GetContentRegionAvail().x, row.brief_name);
    if (has_detail_) {
        ImGui::TableNextColumn();
        text_at_right(row.detail);
    }
    ImGui::PopStyleColor();
    ImGui::PopID();
    return is_clicked;
}

/// Makes the row an item that can be hovered and clicked, and records it as "3 box, polygon 12".
bool PolygonTable::select(const OrderRow& row, const std::string& digits) {
    const bool is_selected = row.fragment >= 0 && row.fragment == links_.now.selected_fragment;
    const float x = ImGui::GetCursorPosX();
    const bool is_clicked = ImGui::Selectable(
        "##row", is_selected, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap);
    if (is_clicked) {
        links_.next.selected_fragment = is_selected ? -1 : row.fragment;
        links_.next.selected_node = has_tree_ ? links_.tree.node_of(links_.next.selected_fragment) : -1;
    }
    if (ImGui::IsItemHovered()) links_.next.hovered_fragment = row.fragment;
    widgets::Record((digits + " " + row.name).c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(x);
    return is_clicked;
}

}  // namespace viewing
