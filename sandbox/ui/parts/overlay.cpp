#include "ui/parts/overlay.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viewing {
namespace {

constexpr double least_w = 1e-4;  ///< a smaller w counts as behind the eye
constexpr double farthest = 1e4;  ///< times the picture's half size: marks farther outside are not drawn

/// Whether every coordinate is a finite number: a V or P entered by hand may overflow.
bool is_finite(const glm::dvec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

}  // namespace

Overlay::Overlay(ImDrawList* draw, const Rect& rect, const glm::dmat4& clip_from_world)
    : draw_(draw),
      rect_(rect),
      clip_from_world_(clip_from_world),
      scale_(widgets::CurrentContext().scale),
      stroke_(widgets::CurrentContext().palette.stroke * scale_) {
    draw_->PushClipRect(rect.min, rect.max, true);
}

Overlay::~Overlay() {
    widgets::LabelPlacer placer(draw_, rect_.min, rect_.max);
    for (const Rect& taken : taken_) placer.Avoid(taken.min, taken.max);
    for (const Segment& line : lines_) placer.AvoidLine(line.from, line.to);
    const float around = 12.0F * scale_;  // radius of the largest mark, the light's ring
    for (const Label& label : labels_)
        placer.Avoid({label.place.x - around, label.place.y - around},
                     {label.place.x + around, label.place.y + around});
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    for (const Label& label : labels_) placer.Place(label.place, label.text.c_str(), label.color);
    ImGui::PopFont();
    draw_->PopClipRect();
}

ImVec2 Overlay::place_of(const glm::dvec4& clip) const {
    return {rect_.min.x + static_cast<float>((clip.x / clip.w * 0.5 + 0.5) * rect_.width()),
            rect_.min.y + static_cast<float>((0.5 - clip.y / clip.w * 0.5) * rect_.height())};
}

std::optional<ImVec2> Overlay::project(const glm::dvec3& point_world) const {
    const glm::dvec4 clip = clip_from_world_ * glm::dvec4(point_world, 1.0);
    const bool is_near = std::max(std::abs(clip.x), std::abs(clip.y)) <= farthest * clip.w;
    if (!is_finite(clip) || clip.w < least_w || !is_near) return std::nullopt;
    return place_of(clip);
}

Ray Overlay::ray_at(ImVec2 place) const {
    const glm::dvec2 ndc((place.x - rect_.min.x) / rect_.width() * 2.0 - 1.0,
                         1.0 - (place.y - rect_.min.y) / rect_.height() * 2.0);
    return ray_through_pixel(clip_from_world_, ndc);
}

std::optional<Overlay::Segment> Overlay::segment(const glm::dvec3& from, const glm::dvec3& to) const {
    glm::dvec4 a = clip_from_world_ * glm::dvec4(from, 1.0), b = clip_from_world_ * glm::dvec4(to, 1.0);
    if (!is_finite(a) || !is_finite(b)) return std::nullopt;
    // Near the plane through the eye, screen positions go to infinity: clip at three times the picture's size, out of
    // sight.
    constexpr double reach = 3.0;
    const auto cut = [&](const auto& distance) {
        const double at_a = distance(a), at_b = distance(b);
        if (at_a < 0.0 && at_b < 0.0) return false;
        if (at_a < 0.0) a = glm::mix(b, a, at_b / (at_b - at_a));
        if (at_b < 0.0) b = glm::mix(a, b, at_a / (at_a - at_b));
        return true;
    };
    const bool is_seen = cut([](const glm::dvec4& clip) { return clip.w - least_w; }) &&
                         cut([](const glm::dvec4& clip) { return reach * clip.w - clip.x; }) &&
                         cut([](const glm::dvec4& clip) { return reach * clip.w + clip.x; }) &&
                         cut([](const glm::dvec4& clip) { return reach * clip.w - clip.y; }) &&
                         cut([](const glm::dvec4& clip) { return reach * clip.w + clip.y; });
    return is_seen ? std::optional(Segment{place_of(a), place_of(b)}) : std::nullopt;
}

std::optional<Overlay::Segment> Overlay::drawn(const glm::dvec3& from, const glm::dvec3& to) {
    const auto found = segment(from, to);
    if (found) lines_.push_back(*found);
    return found;
}

void Overlay::line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness) {
    if (const auto found = drawn(from, to)) draw_->AddLine(found->from, found->to, color, thickness * stroke_);
}

void Overlay::dashed(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness) {
    const auto found = drawn(from, to);
    if (!found) return;
    const ImVec2 way(found->to.x - found->from.x, found->to.y - found->from.y);
    const float length = std::hypot(way.x, way.y), dash = 6.0F * scale_;
    const int dashes = std::clamp(static_cast<int>(length / (2.0F * dash)), 1, 200);
    for (int one = 0; one < dashes; ++one) {
        const float begin = static_cast<float>(one) / static_cast<float>(dashes);
        const float end = begin + 0.5F / static_cast<float>(dashes);
        draw_->AddLine({found->from.x + way.x * begin, found->from.y + way.y * begin},
                       {found->from.x + way.x * end, found->from.y + way.y * end}, color, thickness * stroke_);
    }
}

void Overlay::fill(const std::array<glm::dvec3, 4>& corners, ImU32 color) {
    ImVec2 places[4];
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::optional<ImVec2> place = project(corners[corner]);
        if (!place) return;
        places[corner] = *place;
    }
    draw_->AddQuadFilled(places[0], places[1], places[2], places[3], color);
}

void Overlay::dot(const glm::dvec3& point, ImU32 color, float radius) {
    const auto place = project(point);
    if (!place) return;
    draw_->AddCircleFilled(*place, (radius + 1.5F) * scale_, widgets::CurrentContext().palette.view_ground);
    draw_->AddCircleFilled(*place, radius * scale_, color);
}

void Overlay::ring(const glm::dvec3& point, ImU32 color, float radius) {
    if (const auto place = project(point)) draw_->AddCircle(*place, radius * scale_, color, 0, 1.5F * stroke_);
}

void Overlay::square(const glm::dvec3& point, ImU32 color, float half_size) {
    const auto place = project(point);
    if (!place) return;
    const float half = half_size * scale_;
    const ImVec2 min(place->x - half, place->y - half), max(place->x + half, place->y + half);
    draw_->AddRectFilled({min.x - scale_, min.y - scale_}, {max.x + scale_, max.y + scale_},
                         widgets::CurrentContext().palette.view_ground, 2.0F * scale_);
    draw_->AddRectFilled(min, max, color, 2.0F * scale_);
}

void Overlay::arrow(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness) {
    const auto found = drawn(from, to);
    if (!found) return;
    draw_->AddLine(found->from, found->to, color, thickness * stroke_);
    const ImVec2 way(found->to.x - found->from.x, found->to.y - found->from.y);
    const float length = std::hypot(way.x, way.y);
    if (length < 8.0F * scale_) return;
    const ImVec2 along(way.x / length * 9.0F * scale_, way.y / length * 9.0F * scale_);
    const ImVec2 across(-along.y * 0.45F, along.x * 0.45F);
    const ImVec2 tip(found->to.x + along.x, found->to.y + along.y);
    draw_->AddTriangleFilled(tip, {found->to.x + across.x, found->to.y + across.y},
                             {found->to.x - across.x, found->to.y - across.y}, color);
}

void Overlay::label(const glm::dvec3& point, const char* text, ImU32 color) {
    if (const auto place = project(point)) labels_.push_back({*place, text, color});
}

void Overlay::mark_target(const char* name, const glm::dvec3& from, const glm::dvec3& to) {
    const auto found = segment(from, to);
    if (!found) return;
    const float around = 16.0F * scale_;
    const auto [min_x, max_x] = std::minmax(found->from.x, found->to.x);
    const auto [min_y, max_y] = std::minmax(found->from.y, found->to.y);
    widgets::MarkTarget(name, {min_x - around, min_y - around}, {max_x + around, max_y + around});
}

void Overlay::target(const glm::dvec3& point, const char* text, ImU32 color) {
    if (arrow_at_edge(point, text, color)) return;
    const ImVec2 at = *project(point);
    const float radius = 8.0F * scale_, reach = 13.0F * scale_, gap = 3.0F * scale_;
    const ImU32 ground = widgets::CurrentContext().palette.view_ground;
    for (const auto& [ink, width] : {std::pair(ground, 4.0F), std::pair(color, 2.0F)}) {
        const float line = width * stroke_;
        draw_->AddCircle(at, radius, ink, 0, line);
        for (const float side : {-1.0F, 1.0F}) {
            draw_->AddLine({at.x + side * gap, at.y}, {at.x + side * reach, at.y}, ink, line);
            draw_->AddLine({at.x, at.y + side * gap}, {at.x, at.y + side * reach}, ink, line);
        }
    }
    if (*text == '\0') return;
    ImGui::PushFont(widgets::CurrentContext().fonts.heading);
    const ImVec2 size = ImGui::CalcTextSize(text), margin(5.0F * scale_, 2.0F * scale_);
    const bool has_room = at.x + reach + 2.0F * margin.x + size.x <= rect_.max.x;
    const float left = has_room ? at.x + reach + margin.x : at.x - reach - margin.x - size.x;
    const ImVec2 from(left, at.y - size.y * 0.5F), to(left + size.x, at.y + size.y * 0.5F);
    draw_->AddRectFilled({from.x - margin.x, from.y - margin.y}, {to.x + margin.x, to.y + margin.y}, ground,
                         4.0F * scale_);
    draw_->AddText(from, color, text);
    ImGui::PopFont();
    taken_.push_back({{at.x - reach, at.y - reach}, {at.x + reach, at.y + reach}});
    taken_.push_back({{from.x - margin.x, from.y - margin.y}, {to.x + margin.x, to.y + margin.y}});
}

bool Overlay::is_free(const Rect& part) const {
    return std::none_of(taken_.begin(), taken_.end(), [&part](const Rect& taken) {
        return part.min.x < taken.max.x && taken.min.x < part.max.x && part.min.y < taken.max.y &&
               taken.min.y < part.max.y;
    });
}

bool Overlay::arrow_at_edge(const glm::dvec3& point, const char* text, ImU32 color) {
    const std::optional<ImVec2> place = project(point);
    if (place && rect_.contains(*place)) return false;
    const glm::dvec4 clip = clip_from_world_ * glm::dvec4(point, 1.0);  // not divided by w, which may be negative
    const ImVec2 half(0.5F * rect_.width(), 0.5F * rect_.height());
    const float inset = 14.0F * scale_;
    if (half.x <= inset || half.y <= inset) return true;
    const double across = clip.x * half.x, down = -clip.y * half.y, length = std::hypot(across, down);
    ImVec2 way(0.0F, 1.0F);  // if the point is directly behind the eye
    if (length > 0.0 && std::isfinite(length))
        way = {static_cast<float>(across / length), static_cast<float>(down / length)};
    const float to_edge = std::min((half.x - inset) / std::max(std::abs(way.x), 1e-6F),
                                   (half.y - inset) / std::max(std::abs(way.y), 1e-6F));
    ImVec2 at(rect_.min.x + half.x + way.x * to_edge, rect_.min.y + half.y + way.y * to_edge);
    for (const Rect& taken : taken_)  // move below the sentences at the top
        if (taken.contains(at)) at.y = taken.max.y + inset;
    const float size = 9.0F * scale_;
    const ImVec2 tip(at.x + way.x * size, at.y + way.y * size);
    const ImVec2 left(at.x - way.x * size * 0.4F - way.y * size * 0.7F,
                      at.y - way.y * size * 0.4F + way.x * size * 0.7F);
    const ImVec2 right(at.x - way.x * size * 0.4F + way.y * size * 0.7F,
                       at.y - way.y * size * 0.4F - way.x * size * 0.7F);
    draw_->AddTriangleFilled(tip, left, right, color);
    draw_->AddTriangle(tip, left, right, widgets::CurrentContext().palette.view_ground, 1.0F * stroke_);
    labels_.push_back({at, text, color});
    return true;
}

}  // namespace viewing
