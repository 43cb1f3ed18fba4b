// A draggable line between two pictures that share an area.
#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "widgets/depth.h"
#include "widgets/depth/depth_inner.h"

namespace widgets {

namespace {

using inner::Px;
using inner::Shown;

/// Draws a name on a plate of the background color.
void DrawName(ImDrawList* draw, ImVec2 min, ImVec2 size, const char* name, const char* recorded_as) {
    const Palette& palette = CurrentContext().palette;
    const ImVec2 max(min.x + size.x, min.y + size.y);
    draw->AddRectFilled(min, max, Shown(inner::WithAlpha(palette.ground, 0.8F)), Px(4));
    inner::FaceOf(CurrentContext().fonts.note)
        .Draw(draw, ImVec2(min.x + Px(6), min.y + Px(3)), Shown(palette.text), name);
    inner::RecordRect(recorded_as, min, max, name);
}

/// Draws each name on its side of the line, if it fits.
void DrawNames(ImDrawList* draw, ImVec2 min, ImVec2 max, float x, const DividerStyle& style) {
    const inner::Face face = inner::FaceOf(CurrentContext().fonts.note);
    const float away = Px(10);
    const auto size_of = [&](const char* name) {
        const ImVec2 text = face.Measure(name);
        return ImVec2(text.x + Px(12), text.y + Px(6));
    };
    const ImVec2 left = size_of(style.left), right = size_of(style.right);
    const float top = style.names_at_bottom ? max.y - Px(8) - left.y : min.y + Px(8);
    if (*style.left && x - away - left.x >= min.x) {
        DrawName(draw, ImVec2(std::floor(x - away - left.x), top), left, style.left, "left");
    }
    if (*style.right && x + away + right.x <= max.x) {
        DrawName(draw, ImVec2(std::floor(x + away), top), right, style.right, "right");
    }
}

/// Draws a bar with an outline, so that it stays visible on any picture, and a round grip with two arrowheads.
void DrawBar(ImDrawList* draw, ImVec2 min, ImVec2 max, float x, const inner::DragLineUse& use) {
    const Palette& palette = CurrentContext().palette;
    const ImU32 fill = Shown(use.held || use.hovered ? palette.accent : palette.text), edge = Shown(palette.ground);
    const float half = Px(1) * palette.stroke, outline = Px(1) * palette.stroke, r = Px(9), y = 0.5F * (min.y + max.y);
    draw->AddRectFilled(ImVec2(x - half - outline, min.y), ImVec2(x + half + outline, max.y), edge);
    draw->AddRectFilled(ImVec2(x - half, min.y), ImVec2(x + half, max.y), fill);
    draw->AddCircleFilled(ImVec2(x, y), r + outline, edge);
    draw->AddCircleFilled(ImVec2(x, y), r, fill);
    for (const float side : {-1.0F, 1.0F}) {
        const ImVec2 arrow[] = {ImVec2(x + side * Px(6.5F), y), ImVec2(x + side * Px(2.5F), y - Px(3.5F)),
                                ImVec2(x + side * Px(2.5F), y + Px(3.5F))};
        draw->AddTriangleFilled(arrow[0], arrow[1], arrow[2], edge);
    }
}

}  // namespace

bool Divider(const char* id, ImVec2 min, ImVec2 max, float& share, const DividerStyle& style) {
    const float width = max.x - min.x;
    if (!(width > 0.0F) || !(max.y > min.y)) return false;
    const Group group(id);
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const auto limited = [](double value, double otherwise) {
        return static_cast<float>(std::isnan(value) ? otherwise : std::clamp(value, 0.0, 1.0));
    };
    const float default_share = limited(style.default_share, 0.5);
    float edited = limited(share, default_share);
    const inner::DragLineUse use = inner::UseLine(
        {.id = "divider",
         .x = min.x + edited * width,
         .text = viewing::number_text(edited, 2),
         .tip_title = "Divider",
         .tip = viewing::marked(
             "Drag to see more of one picture; hold Alt for finer steps, right-click to reset the divider.")},
        min.y, max.y);
    ImGui::SetCursorScreenPos(cursor);
    if (use.x) edited = limited((*use.x - min.x) / width, edited);
    if (use.reset) edited = default_share;

    ImDrawList* draw = ImGui::GetWindowDrawList();
    const float x = std::floor(min.x + edited * width) + 0.5F;
    draw->PushClipRect(min, max, true);
    DrawBar(draw, min, max, x, use);
    DrawNames(draw, min, max, x, style);
    draw->PopClipRect();

    const bool changed = (use.x || use.reset) && edited != share;
    if (changed) share = edited;
    return changed;
}

}  // namespace widgets
