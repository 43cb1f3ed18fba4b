#include "topics/depth/shown/fragment_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "text/catalogue.h"
#include "topics/depth/numbers/fragment_text.h"
#include "topics/depth/shown/pixel_numbers.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"
#include "widgets/widgets.h"

namespace viewing {
namespace {

constexpr float least_name = 64.0F, swatch_room = 16.0F;  ///< design pixels

enum FragmentColumn { number, object, eye_z, facing, stored, compared, result, fragment_columns };
constexpr std::array<const char*, fragment_columns> fragment_titles = {
    "", marked("object"), marked("eye z"), marked("facing"), marked("stored"), marked("compare"), marked("test")};

/// The columns' names in lessons.
constexpr std::array<const char*, fragment_columns> fragment_targets = {
    "column:pixel.number", "column:pixel.object",  "column:pixel.eye_z", "column:pixel.facing",
    "column:pixel.stored", "column:pixel.compare", "column:pixel.test"};

/// The texts of a row and their style.
struct FragmentRow {
    std::array<std::string, fragment_columns> texts;
    std::string explanation;
    ImU32 swatch = 0;
    bool is_seen = false, is_drawn = false;
    bool is_close = false;  ///< a tie, or decided by rounding
};

/// Hides covered values, and the colors and the explanation that would give them away.
void cover(FragmentRow& row) {
    for (std::size_t c = 0; c < fragment_targets.size(); ++c)
        if (widgets::IsCovered(fragment_targets[c])) row.texts[c] = "?";
    if (widgets::IsPartCovered("column:pixel")) row.explanation.clear();
    if (!widgets::IsCovered(fragment_targets[compared]) && !widgets::IsCovered(fragment_targets[result])) return;
    row.is_seen = row.is_close = false;
    row.is_drawn = true;
}

ImU32 color_of(const Scene& scene, const std::string& object) {
    if (const SceneObject* found = scene.find(object)) {
        const Color& color = found->description.color;
        return IM_COL32(color.r, color.g, color.b, 255);
    }
    return palette().plane;
}

std::vector<FragmentRow> rows_of(const std::vector<Fragment>& fragments, const DepthPrecision& precision,
                                 const Scene& scene) {
    std::vector<FragmentRow> rows;
    const int seen = seen_fragment(fragments);
    for (const Fragment& fragment : fragments) {
        const TestText test = test_text(fragment, precision);
        FragmentRow row;
        row.is_seen = std::ssize(rows) == seen;
        row.is_close = test.is_close;
        row.is_drawn = fragment.drawn;
        row.swatch = color_of(scene, fragment.object);
        row.texts = {std::to_string(rows.size() + 1),
                     object_text(fragment.object),
                     number_text(fragment.eye_z, 3),
                     fragment.front_facing ? tr("front") : tr("back"),
                     code_text(fragment.stored, precision),
                     say(test.compare),
                     row.is_seen ? say("{result}, seen", "result"_a = test.result) : say(test.result)};
        row.explanation = say(decision_sentence(fragment, precision)) + "\n" +
                          say("stored code {code} (GL's code may differ by ±{within}), code width Δz {step}",
                              "code"_a = code_text(fragment.stored, precision),
                              "within"_a = grouped_number(static_cast<std::int64_t>(std::min(fragment.within, 1e15))),
                              "step"_a = step_text(fragment.step));
        if (row.is_seen) {
            row.explanation += "\n";
            row.explanation += tr("This fragment is the last to write its color, so it is the visible one.");
        }
        cover(row);
        rows.push_back(std::move(row));
    }
    return rows;
}

struct TableFonts {
    ImFont *text, *number;
};

bool is_number(int column) {
    return column == number || column == eye_z || column == stored || column == compared;
}

using FragmentWidths = ColumnWidths<fragment_columns>;

/// Returns the column widths; the names get the remaining space.
FragmentWidths widths_of(const std::vector<FragmentRow>& rows, const TableFonts& fonts, float room) {
    FragmentWidths widths{};
    for (int column = 0; column < fragment_columns; ++column) {
        const auto c = static_cast<std::size_t>(column);
        widths[c] = width_of(tr(fragment_titles[c]), fonts.text);
        for (const FragmentRow& row : rows)
            widths[c] = std::max(widths[c], width_of(row.texts[c], is_number(column) ? fonts.number : fonts.text));
        widths[c] = std::ceil(widths[c]) + 1.0F;
    }
    const float whole_names = widths[object] + px(swatch_room);
    widths[object] = px(least_name);
    const FragmentWidths wanted = widths;
    constexpr std::array<FragmentColumn, 4> by_importance = {compared, eye_z, stored, facing};
    for (const FragmentColumn column : by_importance) widths[column] = 0.0F;
    for (const FragmentColumn column : by_importance) {
        widths[column] = wanted[column];
        if (widths.sum() > room) widths[column] = 0.0F;
    }
    widths[object] = std::max(std::min(whole_names, widths[object] + room - widths.sum()), px(least_name));
    return widths;
}

void draw_object(const FragmentRow& row) {
    const float side = std::round(0.6F * ImGui::GetTextLineHeight());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float top = at.y + std::round((ImGui::GetTextLineHeight() - side) * 0.5F);
    const ImU32 color = row.is_drawn ? row.swatch : with_alpha(row.swatch, 90);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + side, top + side}, color, px(2.0F));
    ImGui::Dummy({side, side});
    ImGui::SameLine(0.0F, px(5.0F));
    shortened_text(row.texts[object], ImGui::GetContentRegionAvail().x);
}

/// Makes the whole row an item that can be hovered and clicked, and records it as "2 box: 812 < 812  tie: fails".
bool draw_row_item(const FragmentRow& row, const std::string& on_click) {
    const float x = ImGui::GetCursorPosX();
    ImGui::PushStyleColor(ImGuiCol_HeaderHovered, palette().field);  // fainter than the visible fragment's highlight
    ImGui::PushStyleColor(ImGuiCol_HeaderActive, palette().field);
    const bool is_clicked =
        ImGui::Selectable("##row", false, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap);
    ImGui::PopStyleColor(2);
    const std::string told =
        row.texts[compared].empty() ? row.texts[result] : row.texts[compared] + "  " + row.texts[result];
    widgets::Record((row.texts[number] + " " + row.texts[object] + ": " + told).c_str());
    ImGui::PushFont(widgets::CurrentContext().fonts.text);
    const std::string explanation = on_click.empty() ? row.explanation : row.explanation + "\n" + on_click;
    widgets::Tooltip(row.texts[object].c_str(), explanation.c_str());
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::SetCursorPosX(x);
    return is_clicked;
}

ImU32 color_of(const FragmentRow& row, int column) {
    if (row.is_close && (column == compared || column == result)) return palette().trouble;
    if (row.is_seen && column == result) return palette().accent;
    return row.is_drawn ? palette().text : palette().quiet;
}

bool draw_row(const FragmentRow& row, const FragmentWidths& widths, const TableFonts& fonts, float height,
              const std::string& on_click) {
    bool is_clicked = false;
    ImGui::TableNextRow(0, height);
    // Red text needs a darker background.
    const ImU32 tint = with_alpha(palette().accent, row.is_close ? 12U : 38U);
    if (row.is_seen) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, tint);
    for (int column = 0; column < fragment_columns; ++column) {
        const auto c = static_cast<std::size_t>(column);
        if (widths[c] <= 0.0F) continue;
        ImGui::TableNextColumn();
        if (column == number) is_clicked = draw_row_item(row, on_click);
        ImGui::PushFont(is_number(column) ? fonts.number : fonts.text);
        ImGui::PushStyleColor(ImGuiCol_Text, color_of(row, column));
        if (column == object)
            draw_object(row);
        else if (is_number(column))
            text_at_right(row.texts[c]);
        else
            ImGui::TextUnformatted(row.texts[c].c_str());
        widgets::MarkTarget(fragment_targets[c]);
        ImGui::PopStyleColor();
        ImGui::PopFont();
    }
    return is_clicked;
}

void draw_fragment_titles(const FragmentWidths& widths) {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().quiet);
    for (int column = 0; column < fragment_columns; ++column) {
        const auto c = static_cast<std::size_t>(column);
        if (widths[c] <= 0.0F) continue;
        ImGui::TableNextColumn();
        if (is_number(column))
            text_at_right(tr(fragment_titles[c]));
        else
            ImGui::TextUnformatted(tr(fragment_titles[c]));
        widgets::MarkTarget(fragment_targets[c]);
    }
    ImGui::PopStyleColor();
}

}  // namespace

std::optional<std::size_t> draw_fragment_table(const std::vector<Fragment>& fragments, const DepthPrecision& precision,
                                               const Scene& scene, bool is_large, const std::string& on_click) {
    std::optional<std::size_t> clicked;
    const widgets::Fonts& own = widgets::CurrentContext().fonts;
    const TableFonts fonts = is_large ? TableFonts{own.text, own.number} : TableFonts{own.note, own.small_number};
    const std::vector<FragmentRow> rows = rows_of(fragments, precision, scene);
    ImGui::PushFont(fonts.text);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float padding = padding_to_fill(static_cast<int>(rows.size()) + 1, room.y);
    const float row_height = ImGui::GetTextLineHeight() + 2.0F * padding;
    const FragmentWidths widths = widths_of(rows, fonts, room.x - ImGui::GetStyle().ScrollbarSize);
    const int shown =
        static_cast<int>(std::count_if(widths.begin(), widths.end(), [](float width) { return width > 0.0F; }));
    const bool scrolls = room.y >= 4.0F * row_height;
    const ImVec2 size(std::min(room.x, widths.sum() + ImGui::GetStyle().ScrollbarSize), scrolls ? room.y : 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {px(cell_padding_x), padding});
    ImGui::PushStyleColor(ImGuiCol_TableHeaderBg, palette().view_ground);
    if (ImGui::BeginTable("fragments", shown, scrolls ? ImGuiTableFlags_ScrollY : 0, size)) {
        ImGui::TableSetupScrollFreeze(0, 1);
        for (int column = 0; column < fragment_columns; ++column) {
            const auto c = static_cast<std::size_t>(column);
            if (widths[c] <= 0.0F) continue;
            ImGui::TableSetupColumn(fragment_titles[c], ImGuiTableColumnFlags_WidthFixed, widths[c]);
        }
        draw_fragment_titles(widths);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()), row_height);
        while (clipper.Step())
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                ImGui::PushID(i);
                const auto row = static_cast<std::size_t>(i);
                if (draw_row(rows[row], widths, fonts, row_height, on_click)) clicked = row;
                ImGui::PopID();
            }
        if (scrolls) widgets::CountScrolled();
        ImGui::EndTable();
    }
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return clicked;
}

}  // namespace viewing
