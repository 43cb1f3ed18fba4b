#include "ui/parts/view_parts.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "text/catalogue.h"
#include "ui/parts/look.h"

namespace viewing {
void draw_picture(const Rect& rect, ImTextureID picture) {
    if (picture)
        ImGui::GetWindowDrawList()->AddImage(picture, rect.min, rect.max, {0, 1}, {1, 0});  // GL's bottom row is first
}

void picture_item(const char* name, const Rect& rect, ImTextureID picture) {
    ImGui::SetCursorScreenPos(rect.min);
    draw_picture(rect, picture);
    ImGui::InvisibleButton(
        name, {rect.width(), rect.height()},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    widgets::Record(name);
}

void view_header(const Rect& rect, const char* title) {
    const widgets::Context& context = widgets::CurrentContext();
    const bool is_plain = widgets::HasPlainTitles();
    ImGui::SetCursorScreenPos({rect.min.x, rect.min.y - px(25.0F)});
    if (*title == '\0') return;
    if (!is_plain) ImGui::AlignTextToFramePadding();
    ImGui::PushFont(is_plain ? context.fonts.caption : context.fonts.heading);
    ImGui::TextUnformatted(tr(title));
    ImGui::PopFont();
    ImGui::SameLine(0.0F, px(12.0F));
}

bool have_room(std::span<const char* const> names, float right) {
    float end = ImGui::GetCursorScreenPos().x;
    for (const char* name : names) end += ImGui::CalcTextSize(tr(name)).x + px(2.0F * 8.0F + 2.0F);
    return end <= right;
}

bool words(const char* id, int& index, std::span<const char* const> names, std::span<const char* const> explanations,
           int default_index, float right) {
    if (!have_room(names, right)) return widgets::Choice(id, index, names, default_index);  // a list has no tooltips
    bool changed = false;
    ImGui::PushID(id);
    for (int one = 0; one < std::ssize(names); ++one) {
        if (one > 0) ImGui::SameLine(0.0F, px(2.0F));
        const bool chosen = one == index;
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? palette().field_active : 0U);
        ImGui::PushStyleColor(ImGuiCol_Text, chosen ? palette().text : palette().quiet);
        if (widgets::SmallButton(names[one]) && !chosen) {
            index = one;
            changed = true;
        }
        ImGui::PopStyleColor(2);
        widgets::Tooltip(names[one], explanations[one]);
    }
    ImGui::PopID();
    return changed;
}

void header_note(const char* text, float right) {
    const widgets::Context& context = widgets::CurrentContext();
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(context.fonts.note);
    ImGui::PushStyleColor(ImGuiCol_Text, context.palette.quiet);
    if (ImGui::GetCursorScreenPos().x + ImGui::CalcTextSize(tr(text)).x <= right) {
        ImGui::TextUnformatted(tr(text));
        widgets::Record("note");
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void draw_plate(ImDrawList* draw, const Rect& rect, ImVec2 margin_px) {
    draw->AddRectFilled({rect.min.x - margin_px.x, rect.min.y - margin_px.y},
                        {rect.max.x + margin_px.x, rect.max.y + margin_px.y}, palette().view_ground, px(4.0F));
}

Rect draw_legend(ImDrawList* draw, const Rect& rect, std::span<const LegendEntry> entries) {
    const widgets::Context& context = widgets::CurrentContext();
    ImGui::PushFont(context.fonts.note);
    const float swatch = px(11.0F), gap = px(6.0F), between = px(14.0F), margin = px(8.0F);
    const float height = ImGui::GetTextLineHeight(), pitch = height + px(4.0F);

    // Place the entries in lines from the top, on a plate that keeps them legible over any picture.
    std::vector<ImVec2> places;
    ImVec2 next(0.0F, 0.0F), size(0.0F, height);
    for (const LegendEntry& entry : entries) {
        const float width = swatch + gap + ImGui::CalcTextSize(tr(entry.meaning)).x;
        if (next.x > 0.0F && next.x + width > rect.width() - 4.0F * margin) next = {0.0F, next.y + pitch};
        places.push_back(next);
        size = {std::max(size.x, next.x + width), next.y + height};
        next.x += width + between;
    }
    const ImVec2 corner(rect.min.x + 2.0F * margin, rect.max.y - 2.0F * margin - size.y);
    const Rect covered{{corner.x - margin, corner.y - margin * 0.5F},
                       {corner.x + size.x + margin, corner.y + size.y + margin * 0.5F}};
    if (entries.empty() || covered.max.x > rect.max.x || covered.min.y < rect.min.y) {
        ImGui::PopFont();
        return {};
    }
    draw_plate(draw, covered, {});
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const LegendEntry& entry = entries[i];
        const ImVec2 at(corner.x + places[i].x, corner.y + places[i].y);
        const float top = std::round(at.y + (height - swatch) * 0.5F);
        const ImVec2 end(at.x + swatch, top + swatch);
        draw->AddRectFilled({at.x, top}, end, IM_COL32(entry.color.r, entry.color.g, entry.color.b, 255), px(2.0F));
        draw->AddRect({at.x, top}, end, context.palette.quiet, px(2.0F));
        draw->AddText({end.x + gap, at.y}, context.palette.text, tr(entry.meaning));
    }
    ImGui::PopFont();
    return covered;
}

Rect sentence_over_picture(ImDrawList* draw, const Rect& rect, ImU32 color, const char* whole, const char* brief) {
    const float room = rect.width() - px(20.0F);
    const bool fits = ImGui::CalcTextSize(whole).x < room;
    const std::string shown = fits ? whole : widgets::BrokenAtBlanks(brief, room);
    const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
    const ImVec2 at(rect.min.x + px(10.0F), rect.max.y - px(24.0F) + ImGui::GetTextLineHeight() - size.y);
    const Rect covered{at, {at.x + size.x, at.y + size.y}};
    draw_plate(draw, covered, {px(5.0F), px(2.0F)});
    draw->AddText(at, color, shown.c_str());
    return covered;
}

bool is_image_covered() {
    return widgets::IsCovered("label:mirrored") || widgets::IsCovered("follow:mirrored");
}

void draw_followed(Overlay& overlay, const Params& params, const Derived& derived) {
    if (!derived.followed) return;
    const FollowedPoint& followed = *derived.followed;
    const glm::dvec3& p = followed.point_world;
    const glm::dvec4& light = derived.chosen_light();
    if (params.shadow.enabled && followed.shadow_world && !widgets::IsCovered("follow:shadow")) {
        if (light.w > 1e-3) overlay.line(glm::dvec3(light) / light.w, p, palette().light);
        overlay.line(p, *followed.shadow_world, palette().light);
        overlay.dot(*followed.shadow_world, palette().light);
        overlay.label(*followed.shadow_world, "s = S p", palette().light);
    }
    if (params.reflection.enabled) {
        overlay.dashed(p, followed.foot_world, palette().mirror);
        overlay.mark_target("label:mirrored", followed.mirrored_world, followed.mirrored_world);
        overlay.dot(followed.foot_world, palette().plane, 3.0F);
    }
    if (params.reflection.enabled && !is_image_covered()) {
        overlay.dashed(followed.foot_world, followed.mirrored_world, palette().mirror);
        overlay.dot(followed.mirrored_world, palette().mirror);
        overlay.label(followed.mirrored_world, "R p", palette().mirror);
    }
    overlay.dot(p, palette().point, 5.0F);
    overlay.label(p, "p", palette().point);
}

}  // namespace viewing
