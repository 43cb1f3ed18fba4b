// A chart with logarithmic axes: axes (log_axes.cpp), curves (chart_curves.cpp), names (chart_labels.cpp), and the
// values under the pointer.
#include <algorithm>
#include <cmath>
#include <string>

#include "widgets/area.h"
#include "widgets/chart/chart_inner.h"
#include "widgets/inner.h"

namespace widgets {

namespace {

using inner::Box;
using inner::ChartPlot;
using inner::Px;
using inner::Shown;

struct Pointed {
    int curve = -1;
    glm::dvec2 point{0.0};
    ImVec2 at;
};

Pointed PointedAt(const ChartPlot& plot, std::span<const ChartCurve> curves, ImVec2 pointer) {
    Pointed nearest;
    float nearest_distance = Px(28);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        for (const glm::dvec2& point : curves[i].points) {
            if (!inner::IsInPlot(plot, point)) continue;
            const ImVec2 at = inner::PlaceOf(plot, point);
            if (const float distance = inner::Distance(at, pointer); distance < nearest_distance) {
                nearest_distance = distance;
                nearest = {static_cast<int>(i), point, at};
            }
        }
    }
    return nearest;
}

/// Formats a value with three significant digits, after its title if it has one.
std::string ReadoutText(const char* title, double value) {
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(value))), 0, 6);
    const std::string number = viewing::number_text(value, decimals);
    return *title ? say("{name}: {value}", "name"_a = tr(title), "value"_a = number) : number;
}

/// Draws a box beside the point, inside the chart.
void DrawReadout(ImDrawList* draw, const Box& area, const ChartCurve& curve, const Pointed& pointed,
                 const LogChartStyle& style) {
    const Context& context = CurrentContext();
    const inner::Face heading = inner::FaceOf(context.fonts.heading), face = inner::FaceOf(context.fonts.note);
    const std::string x = ReadoutText(style.x.title, pointed.point.x), y = ReadoutText(style.y.title, pointed.point.y);
    const float padding = Px(7), gap = Px(3);
    const float width = std::max({heading.Measure(curve.name).x, face.Measure(x).x, face.Measure(y).x});
    const ImVec2 size(width + 2.0F * padding, heading.size + 2.0F * (face.size + gap) + 2.0F * padding);
    const bool to_left = pointed.at.x + Px(12) + size.x > area.max.x;
    const bool below = pointed.at.y - Px(10) - size.y < area.min.y;
    const ImVec2 wanted(to_left ? pointed.at.x - Px(12) - size.x : pointed.at.x + Px(12),
                        below ? pointed.at.y + Px(10) : pointed.at.y - Px(10) - size.y);
    const ImVec2 min(std::floor(std::max(std::min(wanted.x, area.max.x - size.x), area.min.x)),
                     std::floor(std::max(std::min(wanted.y, area.max.y - size.y), area.min.y)));
    const ImVec2 max(min.x + size.x, min.y + size.y);
    draw->AddRectFilled(min, max, ImGui::GetColorU32(ImGuiCol_PopupBg), Px(6));
    draw->AddRect(min, max, Shown(context.palette.border), Px(6), 0, Px(1) * context.palette.stroke);
    ImVec2 at(min.x + padding, min.y + padding);
    heading.Draw(draw, at, Shown(context.palette.text), curve.name);
    at.y += heading.size + gap;
    face.Draw(draw, at, Shown(context.palette.text), x);
    at.y += face.size + gap;
    face.Draw(draw, at, Shown(context.palette.text), y);
    inner::RecordRect("readout", min, max, std::string(tr(curve.name)) + "\n" + x + "\n" + y);
}

/// Draws the vertical line. Returns the area that its label covers.
std::vector<Box> DrawVerticalMarker(ImDrawList* draw, const ChartPlot& plot, const LogChartStyle& style) {
    if (!(style.marker_x > 0.0) || !std::isfinite(style.marker_x) || !plot.x.Holds(style.marker_x)) return {};
    const Palette& palette = CurrentContext().palette;
    const float x = std::floor(plot.x.At(style.marker_x)) + 0.5F;
    inner::DrawDashedVertical(draw, plot, x, Shown(palette.accent), Px(1.5F) * palette.stroke);
    inner::RecordRect("marker", ImVec2(x, plot.min.y), ImVec2(x, plot.max.y), style.marker_label);
    if (!*style.marker_label) return {};
    const ImVec2 size = inner::FaceOf(CurrentContext().fonts.note).Measure(style.marker_label);
    const bool to_left = x + Px(6) + size.x > plot.max.x;
    const ImVec2 at(std::floor(to_left ? x - Px(6) - size.x : x + Px(6)), plot.min.y + Px(3));
    PlateText(draw, at, Shown(palette.accent), style.marker_label, CurrentContext().fonts.note);
    return {{at, ImVec2(at.x + size.x, at.y + size.y)}};
}

}  // namespace

int DrawLogChart(ImDrawList* draw, ImVec2 min, ImVec2 max, std::span<const ChartCurve> curves,
                 const LogChartStyle& style, const ImVec2* pointer) {
    const Palette& palette = CurrentContext().palette;
    const inner::Face face = inner::FaceOf(CurrentContext().fonts.note);
    float widest = 0.0F;
    for (const ChartCurve& curve : curves) widest = std::max(widest, face.Measure(curve.name).x);
    const float label_room = std::min(widest + Px(16), 0.34F * (max.x - min.x));

    draw->PushClipRect(min, max, true);
    draw->AddRectFilled(min, max, Shown(palette.view_ground), Px(4));
    const ChartPlot plot = inner::DrawAxes(draw, min, max, curves, style, std::max(label_room, Px(14)));
    const Pointed pointed = pointer ? PointedAt(plot, curves, *pointer) : Pointed{};
    const auto color_of = [&](std::size_t curve) {
        const bool stands_back = pointed.curve >= 0 && pointed.curve != static_cast<int>(curve);
        return Shown(stands_back ? inner::Mix(palette.view_ground, curves[curve].color, 0.4F) : curves[curve].color);
    };
    const std::vector<Box> taken = DrawVerticalMarker(draw, plot, style);
    for (std::size_t i = 0; i < curves.size(); ++i) inner::DrawCurve(draw, plot, curves[i], i, color_of(i));
    const std::vector<inner::EndLabel> labels = inner::PlaceLabels(plot, curves, max.x - Px(4), taken);
    for (const inner::EndLabel& label : labels)
        inner::DrawEndLabel(draw, label, curves[label.curve].name, color_of(label.curve));
    if (pointed.curve >= 0) {
        const ChartCurve& curve = curves[pointed.curve];
        draw->AddCircle(pointed.at, Px(7), Shown(palette.text), 0, Px(1.5F) * palette.stroke);
        DrawReadout(draw, {min, max}, curve, pointed, style);
    }
    draw->PopClipRect();
    return pointed.curve;
}

int LogChart(const char* id, std::span<const ChartCurve> curves, const LogChartStyle& style) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 size(std::max(style.size.x > 0.0F ? style.size.x : room.x, Px(160)),
                      std::max(style.size.y > 0.0F ? style.size.y : room.y, Px(120)));
    const Group group(id);
    ImGui::InvisibleButton("chart", size);
    Record("chart");
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const int hovered = DrawLogChart(draw, min, max, curves, style, ImGui::IsItemHovered() ? &pointer : nullptr);
    const bool has_points = std::any_of(curves.begin(), curves.end(), [](const ChartCurve& curve) {
        return std::any_of(curve.points.begin(), curve.points.end(), inner::CanBeDrawn);
    });
    if (!has_points) inner::DrawHint(draw, min, max, "Nothing has been measured yet.");
    return hovered;
}

}  // namespace widgets
