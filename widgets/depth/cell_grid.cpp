// A block of pixels as large squares with a number in each, as on the lecture's z-buffer slide.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "text/catalogue.h"
#include "widgets/area.h"
#include "widgets/depth.h"
#include "widgets/depth/depth_inner.h"

namespace widgets {

namespace {

using inner::Px;
using inner::Shown;

/// The layout of the cells: squares whose sides are a whole number of pixels.
struct Grid {
    ImVec2 min;
    float side;
    int columns, rows;

    ImVec2 MaxOfAll() const {
        return ImVec2(min.x + side * static_cast<float>(columns), min.y + side * static_cast<float>(rows));
    }
    ImVec2 Min(int cell) const {
        return ImVec2(min.x + side * static_cast<float>(cell % columns),
                      min.y + side * static_cast<float>(cell / columns));
    }
    ImVec2 Max(int cell) const {
        const ImVec2 corner = Min(cell);
        return ImVec2(corner.x + side, corner.y + side);
    }
    int Under(ImVec2 pointer) const {
        const int column = static_cast<int>(std::floor((pointer.x - min.x) / side));
        const int row = static_cast<int>(std::floor((pointer.y - min.y) / side));
        return column >= 0 && column < columns && row >= 0 && row < rows ? row * columns + column : -1;
    }
};

Grid LayOut(ImVec2 min, ImVec2 max, int columns, int rows) {
    const float margin = Px(4), width = max.x - min.x - 2.0F * margin, height = max.y - min.y - 2.0F * margin;
    const float side = std::floor(std::min(width / static_cast<float>(columns), height / static_cast<float>(rows)));
    Grid grid{.min = min, .side = std::max(side, 1.0F), .columns = columns, .rows = rows};
    const ImVec2 end = grid.MaxOfAll();
    grid.min.x += std::floor(0.5F * (max.x - end.x));
    grid.min.y += std::floor(0.5F * (max.y - end.y));
    return grid;
}

/// Returns black or white, whichever has more contrast: at least 4.5 : 1 on any color. Source: WCAG 2, relative
/// luminance.
ImU32 ContrastingInk(ImU32 color) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(color);
    const auto linear = [](float v) { return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F); };
    const float luminance = 0.2126F * linear(c.x) + 0.7152F * linear(c.y) + 0.0722F * linear(c.z);
    return luminance > 0.179F ? IM_COL32_BLACK : IM_COL32_WHITE;
}

ImU32 ColorOf(const Cell& cell) {
    return cell.color & IM_COL32_A_MASK ? cell.color | IM_COL32_A_MASK : CurrentContext().palette.field;
}

bool Fits(const inner::Face& face, std::string_view text, float side) {
    if (text.empty()) return true;
    const ImVec2 size = face.Measure(text);
    return size.x <= side - Px(5) && size.y <= side - Px(3);
}

/// Returns the font with large digits if every text then fits in its cell, otherwise the one with small digits.
inner::Face FaceFor(std::span<const Cell> cells, float side) {
    const Fonts& fonts = CurrentContext().fonts;
    const inner::Face large = inner::FaceOf(fonts.number);
    const bool all_fit =
        std::all_of(cells.begin(), cells.end(), [&](const Cell& cell) { return Fits(large, cell.text, side); });
    return all_fit ? large : inner::FaceOf(fonts.small_number);
}

void DrawCell(ImDrawList* draw, const Cell& cell, ImVec2 min, ImVec2 max, float gap) {
    const ImVec2 end(max.x - gap, max.y - gap);
    const ImU32 color = ColorOf(cell);
    draw->AddRectFilled(min, end, Shown(color));
    if (!cell.unwritten) return;
    // A diagonal line; beside a number, only its beginning, so that it does not cross the number out.
    const float part = cell.text.empty() ? 1.0F : 0.25F;
    const ImVec2 start(min.x, end.y), stop(min.x + part * (end.x - min.x), end.y - part * (end.y - min.y));
    draw->AddLine(start, stop, Shown(inner::Mix(color, ContrastingInk(color), 0.3F)),
                  Px(1) * CurrentContext().palette.stroke);
}

/// Draws a ring on the cell's edge, clear of its text, between two thin lines that set it off from any color.
void DrawRing(ImDrawList* draw, const Grid& grid, int cell, ImU32 color, float width) {
    const Palette& palette = CurrentContext().palette;
    const ImVec2 min = grid.Min(cell), max = grid.Max(cell);
    const float line = std::min(Px(width) * palette.stroke, 0.3F * grid.side);
    if (grid.side >= Px(12)) draw->AddRect(min, max, Shown(palette.ground), 0.0F, 0, line + Px(2));
    draw->AddRect(min, max, Shown(color), 0.0F, 0, line);
}

struct GridPicture {
    Grid grid;
    inner::Face face;
    bool has_text;
};

/// Returns whether the cell shows its text.
bool ShowsText(const GridPicture& picture, const Cell& cell) {
    return picture.has_text && !cell.text.empty() && Fits(picture.face, cell.text, picture.grid.side);
}

void DrawCells(ImDrawList* draw, const GridPicture& picture, std::span<const Cell> cells) {
    const Grid& grid = picture.grid;
    const bool record = CurrentContext().record;
    const float gap = grid.side >= Px(8) ? Px(1) : 0.0F;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        DrawCell(draw, cells[i], grid.Min(static_cast<int>(i)), grid.Max(static_cast<int>(i)), gap);
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const int cell = static_cast<int>(i);
        if (cells[i].accent) DrawRing(draw, grid, cell, CurrentContext().palette.accent, 2.0F);
        const ImVec2 min = grid.Min(cell), max = grid.Max(cell);
        const bool shows_text = ShowsText(picture, cells[i]);
        if (shows_text) {
            const ImVec2 size = picture.face.Measure(cells[i].text);
            const ImVec2 at(std::floor(0.5F * (min.x + max.x - gap - size.x)),
                            std::floor(0.5F * (min.y + max.y - gap - size.y)));
            picture.face.Draw(draw, at, Shown(ContrastingInk(ColorOf(cells[i]))), cells[i].text);
        }
        if (!record) continue;
        const std::string place = std::to_string(cell % grid.columns) + "/" + std::to_string(cell / grid.columns);
        inner::RecordRect(("cell/" + place).c_str(), min, max, shows_text ? cells[i].text : std::string_view{});
    }
}

const char* ProblemOf(std::span<const Cell> cells, int columns, int rows) {
    if (cells.empty() || columns <= 0 || rows <= 0) return viewing::marked("There are no pixels to show.");
    if (static_cast<std::int64_t>(columns) * rows > most_cells)
        return viewing::marked("Too many pixels to show one by one.");
    return nullptr;
}

/// Returns whether `selected` changed.
bool Select(int pointed, int& selected) {
    int next = selected;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) next = pointed == selected ? -1 : pointed;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) next = -1;
    const bool changed = next != selected;
    selected = next;
    return changed;
}

}  // namespace

bool CellGrid(const char* id, std::span<const Cell> cells, int columns, int rows, int& selected,
              const CellGridStyle& style) {
    const ImVec2 size = inner::AreaSize(style.size, ImVec2(40, 40));
    const Group group(id);
    ImGui::InvisibleButton("grid", size);
    Record("grid");
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax(), pointer = ImGui::GetIO().MousePos;
    const Palette& palette = CurrentContext().palette;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (style.hovered) *style.hovered = -1;

    draw->PushClipRect(min, max, true);
    draw->AddRectFilled(min, max, Shown(palette.view_ground), Px(4));
    bool changed = false;
    if (const char* problem = ProblemOf(cells, columns, rows)) {
        inner::DrawHint(draw, min, max, problem);
    } else {
        const int count = columns * rows;
        cells = cells.first(std::min(cells.size(), static_cast<std::size_t>(count)));
        const Grid grid = LayOut(min, max, columns, rows);
        const GridPicture picture{grid, FaceFor(cells, grid.side), count <= most_cells_with_text};
        const int pointed = ImGui::IsItemHovered() ? grid.Under(pointer) : -1;
        changed = Select(pointed, selected);
        DrawCells(draw, picture, cells);
        if (style.lit >= 0 && style.lit < count) DrawRing(draw, grid, style.lit, palette.quiet, 1.5F);
        if (pointed >= 0) DrawRing(draw, grid, pointed, palette.quiet, 1.5F);
        if (selected >= 0 && selected < count) DrawRing(draw, grid, selected, palette.text, 2.5F);
        if (style.hovered) *style.hovered = pointed;
        const auto index = static_cast<std::size_t>(pointed);
        if (pointed >= 0 && index < cells.size() && !cells[index].text.empty() && !ShowsText(picture, cells[index])) {
            inner::DrawReadoutBox(draw, {min, max}, pointer, std::string(cells[index].text), {});
        }
    }
    draw->PopClipRect();
    return changed;
}

}  // namespace widgets
