#include "ui/parts/cross_section.h"

#include <algorithm>

#include "ui/parts/look.h"

namespace viewing {

CrossSection::CrossSection(const Rect& rect, const glm::dvec3& foot_world, const glm::dvec3& across,
                           const glm::dvec3& up, bool upright)
    : rect_(rect), foot_world_(foot_world), across_(across), up_(up), upright_(upright) {}

glm::dvec2 CrossSection::flat(const glm::dvec3& point_world) const {
    const glm::dvec3 from_foot = point_world - foot_world_;
    const double along = glm::dot(from_foot, across_), above = glm::dot(from_foot, up_);
    return upright_ ? glm::dvec2(above, along) : glm::dvec2(along, above);
}

void CrossSection::fit(std::span<const glm::dvec3> points_world, const Margins& margins_px) {
    glm::dvec2 least(0.0), most(0.0);  // both start at 0, so that the foot is always visible
    for (const glm::dvec3& point : points_world) {
        least = glm::min(least, flat(point));
        most = glm::max(most, flat(point));
    }
    const Rect inner{{rect_.min.x + margins_px.left, rect_.min.y + margins_px.top},
                     {rect_.max.x - margins_px.right, rect_.max.y - margins_px.bottom}};
    const glm::dvec2 size = glm::max(most - least, glm::dvec2(1e-6));
    const glm::dvec2 room(std::max(inner.width(), 4.0F), std::max(inner.height(), 4.0F));
    scale_ = std::min(room.x / size.x, room.y / size.y);
    middle_ = (least + most) * 0.5;
    middle_px_ = {(inner.min.x + inner.max.x) * 0.5F, (inner.min.y + inner.max.y) * 0.5F};
}

ImVec2 CrossSection::place(const glm::dvec2& flat) const {
    // Points farther away than this are never visible. Clamping their distance keeps the direction of lines.
    constexpr double farthest_px = 1e6;
    glm::dvec2 offset = (flat - middle_) * scale_;
    const double length = glm::length(offset);
    if (length > farthest_px) offset *= farthest_px / length;
    return {middle_px_.x + static_cast<float>(offset.x), middle_px_.y - static_cast<float>(offset.y)};
}

ImVec2 CrossSection::place(const glm::dvec3& point_world) const {
    return place(flat(point_world));
}

Rect CrossSection::plane_strip() const {
    const ImVec2 foot = place(glm::dvec2(0.0));
    const float half = px(2.0F) * palette().stroke;
    if (upright_) return {{foot.x - half, rect_.min.y}, {foot.x + half, rect_.max.y}};
    return {{rect_.min.x, foot.y - half}, {rect_.max.x, foot.y + half}};
}

Rect CrossSection::normal_area() const {
    const ImVec2 foot = place(glm::dvec2(0.0));
    if (upright_) return {{foot.x - px(26.0F), rect_.max.y - px(36.0F)}, {foot.x + px(42.0F), rect_.max.y - px(9.0F)}};
    return {{rect_.min.x + px(7.0F), foot.y - px(35.0F)}, {rect_.min.x + px(30.0F), foot.y + px(35.0F)}};
}

void CrossSection::draw_plane(ImDrawList* draw, bool along_up) const {
    const ImVec2 foot = place(glm::dvec2(0.0));
    const ImU32 color = palette().plane, shade = with_alpha(color, 30);
    const float thickness = px(2.0F) * palette().stroke, head = px(7.0F), towards = along_up ? 1.0F : -1.0F;
    const float above = upright_ ? rect_.max.x - foot.x : foot.y - rect_.min.y;
    const float below = upright_ ? foot.x - rect_.min.x : rect_.max.y - foot.y;
    const float arrow = std::clamp((along_up ? above : below) - px(4.0F), head, px(26.0F));
    ImVec2 root, tip, side;  // of the normal's arrow; `side` runs across its head
    if (upright_) {
        draw->AddRectFilled(rect_.min, {foot.x, rect_.max.y}, shade);
        draw->AddLine({foot.x, rect_.min.y}, {foot.x, rect_.max.y}, color, thickness);
        root = {foot.x, rect_.max.y - px(16.0F)};
        tip = {root.x + towards * arrow, root.y};
        side = {0.0F, head * 0.5F};
    } else {
        draw->AddRectFilled({rect_.min.x, foot.y}, rect_.max, shade);
        draw->AddLine({rect_.min.x, foot.y}, {rect_.max.x, foot.y}, color, thickness);
        root = {rect_.min.x + px(14.0F), foot.y};
        tip = {root.x, root.y - towards * arrow};
        side = {head * 0.5F, 0.0F};
    }
    const ImVec2 along((tip.x - root.x) / arrow * head, (tip.y - root.y) / arrow * head);
    draw->AddLine(root, {tip.x - along.x, tip.y - along.y}, color, thickness);
    draw->AddTriangleFilled(tip, {tip.x - along.x + side.x, tip.y - along.y + side.y},
                            {tip.x - along.x - side.x, tip.y - along.y - side.y}, color);
    const float beside = upright_ ? -px(20.0F) : -px(9.0F);
    const float lowest = rect_.max.y - ImGui::GetFontSize() - px(2.0F);
    widgets::PlateText(draw, {tip.x + px(6.0F), std::min(tip.y + beside, lowest)}, color, "n");
}

}  // namespace viewing
