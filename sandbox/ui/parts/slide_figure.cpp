#include "ui/parts/slide_figure.h"

#include <algorithm>
#include <cmath>

#include "ui/parts/look.h"

namespace viewing {

Figure::~Figure() {
    const Rect& rect = section_.rect();
    widgets::LabelPlacer placer(draw_, rect.min, rect.max);
    const Rect strip = section_.plane_strip();
    placer.Avoid(strip.min, strip.max);
    const Rect normal = section_.normal_area();
    placer.Avoid(normal.min, normal.max);
    for (const Rect& taken : taken_) placer.Avoid(taken.min, taken.max);
    for (const Segment& line : lines_) placer.AvoidLine(line.from, line.to);
    const float around = px(7.0F);
    for (const ImVec2& mark : marks_)
        placer.Avoid({mark.x - around, mark.y - around}, {mark.x + around, mark.y + around});
    std::vector<ImVec2> measured;
    for (const Label& label : labels_)
        if (!label.is_name) measured.push_back(label.place);
    for (const Label& label : labels_) {
        ImGui::PushFont(label.is_name ? widgets::CurrentContext().fonts.heading : number_font());
        placer.Place(label.place, label.text.c_str(), label.color, {},
                     label.is_name ? std::span<const ImVec2>() : measured);
        ImGui::PopFont();
    }
}

bool Figure::has_room(const Rect& rect) {
    return rect.width() >= px(320.0F);
}

void Figure::line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness) {
    const ImVec2 a = section_.place(from), b = section_.place(to);
    draw_->AddLine(a, b, color, px(thickness) * palette().stroke);
    lines_.push_back({a, b});
}

void Figure::dashed(const glm::dvec3& from, const glm::dvec3& to, ImU32 color) {
    const ImVec2 a = section_.place(from), b = section_.place(to);
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const int dashes = std::clamp(static_cast<int>(length / px(9.0F)), 1, 400);
    for (int one = 0; one < dashes; ++one) {
        const float begin = static_cast<float>(one) / static_cast<float>(dashes);
        const float end = begin + 0.55F / static_cast<float>(dashes);
        draw_->AddLine({a.x + (b.x - a.x) * begin, a.y + (b.y - a.y) * begin},
                       {a.x + (b.x - a.x) * end, a.y + (b.y - a.y) * end}, color, px(1.5F) * palette().stroke);
    }
    lines_.push_back({a, b});
}

void Figure::triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, ImU32 color, ImU32 alpha) {
    draw_->AddTriangleFilled(section_.place(a), section_.place(b), section_.place(c), with_alpha(color, alpha));
}

void Figure::dot(const glm::dvec3& point, ImU32 color, float radius) {
    const ImVec2 at = section_.place(point);
    draw_->AddCircleFilled(at, px(radius + 1.5F), palette().view_ground);
    draw_->AddCircleFilled(at, px(radius), color);
    marks_.push_back(at);
}

void Figure::right_angle(const glm::dvec3& foot, const glm::dvec3& across, const glm::dvec3& up) {
    const ImVec2 at = section_.place(foot), a = section_.place(foot + across), b = section_.place(foot + up);
    const auto step = [&](ImVec2 to) {
        const float length = std::max(std::hypot(to.x - at.x, to.y - at.y), 1e-3F);
        return ImVec2((to.x - at.x) / length * px(7.0F), (to.y - at.y) / length * px(7.0F));
    };
    const ImVec2 x = step(a), y = step(b);
    const ImVec2 corner[] = {{at.x + x.x, at.y + x.y}, {at.x + x.x + y.x, at.y + x.y + y.y}, {at.x + y.x, at.y + y.y}};
    draw_->AddPolyline(corner, 3, palette().quiet, 0, px(1.2F) * palette().stroke);
}

void Figure::name(const glm::dvec3& point, const char* text, ImU32 color) {
    labels_.push_back({section_.place(point), text, color, true});
}

void Figure::measure(const glm::dvec3& from, const glm::dvec3& to, const char* symbol, double value, ImU32 color) {
    labels_.push_back(
        {middle_seen(section_.place(from), section_.place(to)), measure_text(symbol, value), color, false});
}

void Figure::dimension(const glm::dvec3& from, const glm::dvec3& to, const char* symbol, double value, ImU32 color) {
    ImVec2 a = section_.place(from), b = section_.place(to);
    a.x = b.x = b.x - px(12.0F);
    const float tick = px(4.0F), thickness = px(1.2F) * palette().stroke;
    draw_->AddLine(a, b, color, thickness);
    for (const float y : {a.y, b.y}) draw_->AddLine({a.x - tick, y}, {a.x + tick, y}, color, thickness);

    const std::string text = measure_text(symbol, value);
    const ImVec2 middle = middle_seen(a, b);
    ImGui::PushFont(number_font());
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at(a.x - px(5.0F) - size.x, std::round(middle.y - size.y * 0.5F));
    const Rect normal = section_.normal_area();
    const bool meets_normal =
        at.x < normal.max.x && at.x + size.x > normal.min.x && at.y < normal.max.y && at.y + size.y > normal.min.y;
    const bool has_room_left = at.x >= section_.rect().min.x && !meets_normal;
    if (has_room_left) {
        widgets::PlateText(draw_, at, color, text.c_str());
        taken_.push_back({at, {a.x + tick, at.y + size.y}});
    } else {
        labels_.push_back({{middle.x + px(12.0F), middle.y}, text, color, false});  // to the right of the line
    }
    ImGui::PopFont();
}

void Figure::mark_target(const char* name, const glm::dvec3& from, const glm::dvec3& to) const {
    const Segment part = seen(section_.place(from), section_.place(to));
    const float around = px(16.0F);
    const auto [min_x, max_x] = std::minmax(part.from.x, part.to.x);
    const auto [min_y, max_y] = std::minmax(part.from.y, part.to.y);
    widgets::MarkTarget(name, {min_x - around, min_y - around}, {max_x + around, max_y + around});
}

Figure::Segment Figure::seen(ImVec2 from, ImVec2 to) const {
    const Rect& rect = section_.rect();
    float begin = 0.0F, end = 1.0F;
    const auto cut = [&](float start, float way, float least, float most) {
        if (way == 0.0F) return;
        const float one = (least - start) / way, other = (most - start) / way;
        begin = std::max(begin, std::min(one, other));
        end = std::min(end, std::max(one, other));
    };
    const ImVec2 way(to.x - from.x, to.y - from.y);
    cut(from.x, way.x, rect.min.x, rect.max.x);
    cut(from.y, way.y, rect.min.y, rect.max.y);
    if (begin >= end) return {from, to};
    return {{from.x + way.x * begin, from.y + way.y * begin}, {from.x + way.x * end, from.y + way.y * end}};
}

ImVec2 Figure::middle_seen(ImVec2 from, ImVec2 to) const {
    const Segment part = seen(from, to);
    return {(part.from.x + part.to.x) * 0.5F, (part.from.y + part.to.y) * 0.5F};
}

std::string Figure::measure_text(const char* symbol, double value) const {
    const std::string number = number_text(value, 2);
    return has_room() ? std::string(symbol) + " = " + number : number;
}

ImFont* Figure::number_font() const {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    return section_.rect().width() < px(480.0F) ? fonts.small_number : fonts.number;
}

}  // namespace viewing
