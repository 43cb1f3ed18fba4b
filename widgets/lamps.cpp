// Lamps for degrees of freedom, and the splitter between two areas.
#include <algorithm>
#include <cmath>

#include "widgets/inner.h"

namespace widgets {

using inner::Px;
using inner::Shown;

namespace {

constexpr float keys_gap = 5.0F;  // design pixels

bool IsRefused(const Lamp& lamp) {
    return lamp.asked && !lamp.available;
}

float TextWidth(const Lamp& lamp, const inner::Face& face) {
    const float keys = *lamp.keys == '\0' ? 0.0F : Px(keys_gap) + face.Measure(lamp.keys).x;
    return face.Measure(lamp.label).x + keys;
}

/// Draws a lamp. Moving: filled, with a glow. Available but at rest: a ring in its color. Unavailable: a quiet ring,
/// struck through, in the trouble color while its key is pressed.
void DrawLamp(ImDrawList* draw, ImVec2 min, float height, const Lamp& lamp, ImU32 color, const inner::Face& face) {
    const Palette& palette = CurrentContext().palette;
    const float radius = Px(4.5F), line = Px(1.5F) * palette.stroke;
    const ImVec2 center(min.x + Px(8), std::floor(min.y + height * 0.5F) + 0.5F);
    if (lamp.active) {
        draw->AddCircleFilled(center, radius + Px(3), Shown(inner::WithAlpha(color, 0.25F)));
        draw->AddCircleFilled(center, radius, Shown(color));
    } else if (lamp.available) {
        draw->AddCircle(center, radius - line * 0.5F, Shown(color), 0, line);
    } else {
        const ImU32 off = Shown(IsRefused(lamp) ? palette.trouble : inner::Mix(palette.ground, palette.quiet, 0.6F));
        if (IsRefused(lamp)) draw->AddCircleFilled(center, radius + Px(3), inner::WithAlpha(off, 0.25F));
        draw->AddCircle(center, radius - line * 0.5F, off, 0, line);
        const float reach = radius * 0.72F;
        draw->AddLine(ImVec2(center.x - reach, center.y + reach), ImVec2(center.x + reach, center.y - reach), off,
                      line);
    }
    const ImU32 ink = lamp.active      ? palette.text
                      : lamp.available ? palette.quiet
                                       : inner::Mix(palette.ground, palette.quiet, 0.85F);
    const ImVec2 at(min.x + Px(17), std::floor(min.y + (height - face.size) * 0.5F));
    face.Draw(draw, at, Shown(IsRefused(lamp) ? palette.trouble : ink), lamp.label);
    const ImVec2 behind(at.x + face.Measure(lamp.label).x + Px(keys_gap), at.y);
    face.Draw(draw, behind, Shown(lamp.available ? palette.accent : ink), lamp.keys);
}

}  // namespace

void Lamps(const char* label, std::span<const Lamp> lamps, Role role) {
    if (lamps.empty()) return;
    const Context& context = CurrentContext();
    const inner::Face face = inner::FaceOf(context.fonts.note);
    float widest = 0.0F;
    for (const Lamp& lamp : lamps) widest = std::max(widest, TextWidth(lamp, face));
    const float each = std::ceil(widest + Px(17) + Px(8)), height = face.size + Px(6);

    // Use as few rows as possible, all of the same length.
    const int count = static_cast<int>(lamps.size());
    const int fitting = std::clamp(static_cast<int>(ImGui::GetContentRegionAvail().x / each), 1, count);
    const int rows = (count + fitting - 1) / fitting;
    const int per_row = (count + rows - 1) / rows;

    const ImVec2 min = ImGui::GetCursorScreenPos();
    ImGui::Dummy(ImVec2(each * static_cast<float>(per_row), height * static_cast<float>(rows)));
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const Group group(label);
    for (int i = 0; i < count; ++i) {
        const Lamp& lamp = lamps[i];
        const ImVec2 at(min.x + each * static_cast<float>(i % per_row),
                        min.y + height * static_cast<float>(i / per_row));
        DrawLamp(draw, at, height, lamp, context.palette.of(role), face);
        inner::RecordRect(lamp.label, at, ImVec2(at.x + each, at.y + height),
                          lamp.active      ? "active"
                          : lamp.available ? "available"
                          : lamp.asked     ? "refused"
                                           : "absent");
    }
}

bool Splitter(const char* id, bool vertical, float& position, float min, float max, float length, float direction) {
    Context& context = CurrentContext();
    Editing& editing = context.editing;
    const float thickness = Px(6);
    const ImVec2 size =
        vertical ? ImVec2(thickness, std::max(length, 1.0F)) : ImVec2(std::max(length, 1.0F), thickness);
    ImGui::InvisibleButton(id, size);
    const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    const ImVec2 corner = ImGui::GetItemRectMin(), far_corner = ImGui::GetItemRectMax();
    inner::RecordRect(id, corner, far_corner);

    if (hovered || active) {
        ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
        const ImU32 color = Shown(inner::WithAlpha(context.palette.accent, active ? 1.0F : 0.6F));
        const float inset = thickness * 0.5F - Px(1);
        const ImVec2 from = vertical ? ImVec2(corner.x + inset, corner.y) : ImVec2(corner.x, corner.y + inset);
        const ImVec2 to =
            vertical ? ImVec2(far_corner.x - inset, far_corner.y) : ImVec2(far_corner.x, far_corner.y - inset);
        ImGui::GetWindowDrawList()->AddRectFilled(from, to, color, Px(1));
    }
    if (ImGui::IsItemActivated()) {
        editing.drag_value = position;
        return false;
    }
    if (!active) return false;
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    // Do not clamp here: a pointer that has passed the end must meet the bar again when it returns.
    editing.drag_value += direction * (vertical ? delta.x : delta.y) / context.scale;
    const float moved = std::clamp(static_cast<float>(editing.drag_value), min, std::max(min, max));
    if (delta.x == 0.0F && delta.y == 0.0F) return false;
    const bool changed = moved != position;
    position = moved;
    return changed;
}

}  // namespace widgets
