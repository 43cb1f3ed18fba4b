// The appearance: three palettes, ImGui's own colors and metrics, and the frame that all fields share. Check each theme
// with widgets-demo.
#include <algorithm>

#include "widgets/inner.h"

namespace widgets {

namespace {

constexpr ImU32 Rgb(unsigned rrggbb) {
    return IM_COL32((rrggbb >> 16) & 0xFF, (rrggbb >> 8) & 0xFF, rrggbb & 0xFF, 0xFF);
}

constexpr Palette dark{
    .ground = Rgb(0x12151B),
    .raised = Rgb(0x1E232C),
    .field = Rgb(0x242A35),
    .field_hovered = Rgb(0x2D3542),
    .field_active = Rgb(0x374151),
    .border = Rgb(0x343C49),
    .text = Rgb(0xE2E7EE),
    .quiet = Rgb(0x8C96A5),
    .accent = Rgb(0x5A9EF0),
    .view_ground = Rgb(0x1B1F27),
    .light = Rgb(0xE69F00),
    .plane = Rgb(0x2BB98B),
    .camera = Rgb(0x56B4E9),
    .mirror = Rgb(0xCC79A7),
    .point = Rgb(0xF0E442),
    .trouble = Rgb(0xEB6239),
};

// On a light background, the role colors have the same hues but are darker: their contrast is at least 3 : 1 on every
// background color.
constexpr Palette light{
    .ground = Rgb(0xF4F5F7),
    .raised = Rgb(0xE6E9EE),
    .field = Rgb(0xFFFFFF),
    .field_hovered = Rgb(0xEDF3FB),
    .field_active = Rgb(0xDCE8F8),
    .border = Rgb(0xC3CAD4),
    .text = Rgb(0x1A1F27),
    .quiet = Rgb(0x56606E),
    .accent = Rgb(0x2A72CC),
    .view_ground = Rgb(0xE9ECF0),
    .light = Rgb(0xB06600),
    .plane = Rgb(0x068E62),
    .camera = Rgb(0x2783B7),
    .mirror = Rgb(0xBB5C90),
    .point = Rgb(0x6A7F00),
    .trouble = Rgb(0xE43401),
};

// Projectors wash out colors, so this palette has a white background, black text, thicker strokes, and role colors with
// a contrast of 4.5 : 1.
constexpr Palette projector{
    .ground = Rgb(0xFFFFFF),
    .raised = Rgb(0xE8EBF0),
    .field = Rgb(0xFFFFFF),
    .field_hovered = Rgb(0xE6F0FC),
    .field_active = Rgb(0xCFE1F8),
    .border = Rgb(0x5B6675),
    .text = Rgb(0x000000),
    .quiet = Rgb(0x343B45),
    .accent = Rgb(0x1D5FB4),
    .view_ground = Rgb(0xF2F4F7),
    .light = Rgb(0x9C5400),
    .plane = Rgb(0x04704C),
    .camera = Rgb(0x21709C),
    .mirror = Rgb(0xA04F7C),
    .point = Rgb(0x4C6A00),
    .trouble = Rgb(0xCA2E00),
    .stroke = 1.6F,
    .type_scale = 1.3F,
};

bool HasLightGround(const Palette& palette) {
    return inner::InkOn(palette.ground) == IM_COL32_BLACK;
}

}  // namespace

ImU32 Palette::of(Role role) const {
    switch (role) {
        case Role::none:
            return text;
        case Role::light:
            return light;
        case Role::plane:
            return plane;
        case Role::camera:
            return camera;
        case Role::mirror:
            return mirror;
        case Role::point:
            return point;
        case Role::trouble:
            return trouble;
    }
    return text;
}

const Palette& palette_of(ThemeKind theme) {
    switch (theme) {
        case ThemeKind::dark:
            return dark;
        case ThemeKind::light:
            return light;
        case ThemeKind::projector:
            return projector;
    }
    return dark;
}

namespace {

void SetMetrics(ImGuiStyle& style, const Context& context) {
    const float field_border = HasLightGround(context.palette) ? context.palette.stroke : 0.0F;
    style.WindowPadding = ImVec2(8, 8);
    style.FramePadding = ImVec2(8, 3);
    style.ItemSpacing = ImVec2(8, 4);
    style.ItemInnerSpacing = ImVec2(6, 4);
    style.CellPadding = ImVec2(4, 2);
    style.IndentSpacing = 14;
    style.ScrollbarSize = 10;
    style.GrabMinSize = 8;
    style.WindowRounding = 0;
    style.ChildRounding = 4;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.ScrollbarRounding = 5;
    style.GrabRounding = 3;
    style.TabRounding = 4;
    style.ScaleAllSizes(context.scale);
    style.WindowBorderSize = 0.0F;
    style.ChildBorderSize = 0.0F;
    style.PopupBorderSize = std::max(1.0F, context.scale * context.palette.stroke);
    style.FrameBorderSize = field_border * context.scale;
}

}  // namespace

void ApplyStyle(const Context& context) {
    using inner::Mix;
    using inner::WithAlpha;
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    SetMetrics(style, context);
    style.DisabledAlpha = context.palette.stroke > 1.0F ? 0.6F : 0.45F;

    const Palette& p = context.palette;
    const ImU32 popup = HasLightGround(p) ? p.field : p.raised;
    const auto set = [&style](ImGuiCol slot, ImU32 color) {
        style.Colors[slot] = ImGui::ColorConvertU32ToFloat4(color);
    };
    if (HasLightGround(p)) ImGui::StyleColorsLight(&style);
    set(ImGuiCol_Text, p.text);
    set(ImGuiCol_TextDisabled, p.quiet);
    set(ImGuiCol_WindowBg, p.ground);
    set(ImGuiCol_ChildBg, WithAlpha(p.ground, 0.0F));
    set(ImGuiCol_PopupBg, popup);
    set(ImGuiCol_Border, p.border);
    set(ImGuiCol_FrameBg, p.field);
    set(ImGuiCol_FrameBgHovered, p.field_hovered);
    set(ImGuiCol_FrameBgActive, p.field_active);
    set(ImGuiCol_TitleBg, p.raised);
    set(ImGuiCol_TitleBgActive, p.raised);
    set(ImGuiCol_TitleBgCollapsed, p.raised);
    set(ImGuiCol_MenuBarBg, p.raised);
    set(ImGuiCol_ScrollbarBg, WithAlpha(p.ground, 0.0F));
    set(ImGuiCol_ScrollbarGrab, p.border);
    set(ImGuiCol_ScrollbarGrabHovered, Mix(p.border, p.quiet, 0.5F));
    set(ImGuiCol_ScrollbarGrabActive, p.quiet);
    set(ImGuiCol_CheckMark, p.accent);
    set(ImGuiCol_SliderGrab, p.accent);
    set(ImGuiCol_SliderGrabActive, Mix(p.accent, p.text, 0.25F));
    set(ImGuiCol_Button, p.field);
    set(ImGuiCol_ButtonHovered, p.field_hovered);
    set(ImGuiCol_ButtonActive, p.field_active);
    set(ImGuiCol_Header, WithAlpha(p.accent, 0.30F));
    set(ImGuiCol_HeaderHovered, WithAlpha(p.accent, 0.20F));
    set(ImGuiCol_HeaderActive, WithAlpha(p.accent, 0.40F));
    set(ImGuiCol_Separator, p.border);
    set(ImGuiCol_SeparatorHovered, p.accent);
    set(ImGuiCol_SeparatorActive, p.accent);
    set(ImGuiCol_PlotHistogram, p.accent);
    set(ImGuiCol_TextSelectedBg, WithAlpha(p.accent, 0.35F));
    set(ImGuiCol_DragDropTarget, p.accent);
    set(ImGuiCol_NavHighlight, p.accent);
    set(ImGuiCol_ModalWindowDimBg, WithAlpha(IM_COL32_BLACK, 0.45F));
}

namespace inner {

ImU32 Mix(ImU32 a, ImU32 b, float t) {
    const ImVec4 from = ImGui::ColorConvertU32ToFloat4(a);
    const ImVec4 to = ImGui::ColorConvertU32ToFloat4(b);
    return ImGui::ColorConvertFloat4ToU32(ImVec4(from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t,
                                                 from.z + (to.z - from.z) * t, from.w + (to.w - from.w) * t));
}

ImU32 WithAlpha(ImU32 color, float alpha) {
    const auto opacity = static_cast<ImU32>(std::clamp(alpha, 0.0F, 1.0F) * 255.0F + 0.5F);
    return (color & ~IM_COL32_A_MASK) | (opacity << IM_COL32_A_SHIFT);
}

ImU32 InkOn(ImU32 color) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(color);
    const float brightness = 0.30F * c.x + 0.59F * c.y + 0.11F * c.z;
    return brightness > 0.55F ? IM_COL32_BLACK : IM_COL32_WHITE;
}

void DrawField(ImDrawList* draw, ImVec2 min, ImVec2 max, bool hovered, bool active, bool lit, Role role) {
    const Palette& palette = CurrentContext().palette;
    const ImGuiStyle& style = ImGui::GetStyle();
    ImU32 fill = active ? palette.field_active : hovered ? palette.field_hovered : palette.field;
    if (lit) fill = Mix(fill, palette.accent, 0.25F);
    draw->AddRectFilled(min, max, Shown(fill), style.FrameRounding);
    if (lit) {
        draw->AddRect(min, max, Shown(palette.accent), style.FrameRounding, 0, Px(1.5F) * palette.stroke);
    } else if (style.FrameBorderSize > 0.0F) {
        draw->AddRect(min, max, Shown(palette.border), style.FrameRounding, 0, style.FrameBorderSize);
    }
    if (role != Role::none) {
        const float stripe = Px(3) * palette.stroke;
        draw->AddRectFilled(min, ImVec2(min.x + stripe, max.y), Shown(palette.of(role)), style.FrameRounding,
                            ImDrawFlags_RoundCornersLeft);
    }
}

void DrawTriangle(ImDrawList* draw, ImVec2 center, float radius, bool down, ImU32 color) {
    const float r = radius;
    if (down) {
        draw->AddTriangleFilled(ImVec2(center.x - r, center.y - 0.6F * r), ImVec2(center.x + r, center.y - 0.6F * r),
                                ImVec2(center.x, center.y + 0.7F * r), color);
    } else {
        draw->AddTriangleFilled(ImVec2(center.x - 0.6F * r, center.y - r), ImVec2(center.x + 0.7F * r, center.y),
                                ImVec2(center.x - 0.6F * r, center.y + r), color);
    }
}

}  // namespace inner
}  // namespace widgets
