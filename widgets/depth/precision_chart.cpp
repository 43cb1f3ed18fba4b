// Interaction with a PrecisionChart: dragging near and far along its axis. precision_drawing.cpp draws the chart, and
// log_axes.cpp draws its axes.
#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "text/numbers.h"
#include "widgets/area.h"
#include "widgets/depth/precision_inner.h"

namespace widgets {

namespace {

using inner::Box;
using inner::ChartPlot;
using inner::Px;
using inner::Shown;

constexpr double least_ratio = 1.001;  ///< smallest ratio of far to near after a drag

bool IsDistance(double z) {
    return z > 0.0 && std::isfinite(z);
}

/// Returns a distance's position on the axis, clamped to the axis's ends.
float PlaceOf(const ChartPlot& plot, double z) {
    return std::clamp(plot.x.At(z), plot.min.x, plot.max.x);
}

double OnAxis(const ChartPlot& plot, double pixel) {
    return inner::ValueAtPixel(plot.x, std::clamp<double>(pixel, plot.x.from, plot.x.to));
}

struct Distances {
    double near, far;
};

/// Resets `value` to its default, or both values if near < far would not hold.
void Reset(double& value, double default_value, Distances& edited, const PrecisionChartStyle& style) {
    if (!IsDistance(default_value)) return;
    value = default_value;
    if (edited.near >= edited.far) edited = {style.default_near, style.default_far};
}

inner::DragLine NearLine(const ChartPlot& plot, double near) {
    return {.id = "near",
            .x = PlaceOf(plot, near),
            .text = viewing::steady_figures(near),
            .tip_title = "Near",
            .tip = viewing::marked(
                "Drag to move the near plane; hold Alt for finer steps, right-click to reset it. Nothing nearer than "
                "this plane is drawn. The code width grows as the plane moves closer to the eye.")};
}

inner::DragLine FarLine(const ChartPlot& plot, double far) {
    return {.id = "far",
            .x = PlaceOf(plot, far),
            .text = viewing::steady_figures(far),
            .tip_title = "Far",
            .tip = viewing::marked("Drag to move the far plane; hold Alt for finer steps, right-click to reset it. "
                                   "Nothing beyond this plane is drawn.")};
}

/// Returns the distances after this frame's dragging. Ignores edits that would break near < far.
Distances UseLines(const ChartPlot& plot, const Distances& before, const PrecisionChartStyle& style,
                   inner::DragLinesUse& use) {
    const bool has_near = IsDistance(before.near), has_far = IsDistance(before.far);
    const float top = plot.min.y - Px(3);
    if (has_near && has_far) {
        use = inner::UseLines(NearLine(plot, before.near), FarLine(plot, before.far), top, plot.max.y);
    } else if (has_near) {
        use.low = inner::UseLine(NearLine(plot, before.near), top, plot.max.y);
    } else if (has_far) {
        use.high = inner::UseLine(FarLine(plot, before.far), top, plot.max.y);
    }
    Distances edited = before;
    if (use.low.x) {
        edited.near = OnAxis(plot, *use.low.x);
        if (has_far) edited.near = std::min(edited.near, before.far / least_ratio);
    }
    if (use.high.x) {
        edited.far = OnAxis(plot, *use.high.x);
        if (has_near) edited.far = std::max(edited.far, before.near * least_ratio);
    }
    if (use.low.reset) Reset(edited.near, style.default_near, edited, style);
    if (use.high.reset) Reset(edited.far, style.default_far, edited, style);
    return has_near && has_far && !(edited.near < edited.far) ? before : edited;
}

/// Dims the ranges that near and far clip away.
void DrawCutOff(ImDrawList* draw, const ChartPlot& plot, const Distances& distances) {
    const ImU32 shade = Shown(inner::WithAlpha(CurrentContext().palette.ground, 0.6F));
    if (IsDistance(distances.near)) {
        draw->AddRectFilled(plot.min, ImVec2(PlaceOf(plot, distances.near), plot.max.y), shade);
    }
    if (IsDistance(distances.far)) {
        draw->AddRectFilled(ImVec2(PlaceOf(plot, distances.far), plot.min.y), plot.max, shade);
    }
}

/// Draws the lines and their names. Returns the areas that the names cover.
std::vector<Box> DrawVerticals(ImDrawList* draw, const ChartPlot& plot, const Distances& distances,
                               std::span<const ChartCurve> curves, const PrecisionChartStyle& style,
                               const inner::DragLinesUse& use) {
    const Palette& palette = CurrentContext().palette;
    const ChartCurve* current = inner::EmphasizedOf(curves);
    std::vector<inner::LineName> names;
    const auto mark = [&](double z, ImU32 color, const std::string& text, const char* recorded_as, float width) {
        if (!IsDistance(z) || !plot.x.Holds(z)) return;
        const float x = std::floor(plot.x.At(z)) + 0.5F;
        inner::DrawDashedVertical(draw, plot, x, Shown(color), Px(width) * palette.stroke);
        inner::RecordRect((std::string("mark/") + recorded_as).c_str(), ImVec2(x, plot.min.y), ImVec2(x, plot.max.y),
                          text);
        names.push_back({x, text, color, recorded_as});
        const std::optional<double> step = current ? inner::ValueAt(*current, z) : std::nullopt;
        if (step && inner::IsInPlot(plot, {z, *step})) {
            draw->AddCircleFilled(inner::PlaceOf(plot, {z, *step}), Px(3.5F), Shown(color));
        }
    };
    const auto line = [&](double z, const char* name, const std::string& text, const inner::DragLineUse& line_use) {
        if (!IsDistance(z)) return;
        const float x = PlaceOf(plot, z);
        MarkTarget(std::string(style.target) + "." + name, ImVec2(x - Px(5), plot.min.y),
                   ImVec2(x + Px(5), plot.max.y));
        inner::DrawDragLine(draw, PlaceOf(plot, z), plot.min.y, plot.max.y, Shown(palette.camera), line_use);
        names.push_back({PlaceOf(plot, z), text, palette.camera, name});
    };
    line(distances.near, "near", say("near {z}", "z"_a = viewing::steady_figures(distances.near)), use.low);
    line(distances.far, "far", say("far {z}", "z"_a = viewing::steady_figures(distances.far)), use.high);
    mark(style.cursor_z, palette.accent, tr("pixel"), "pixel", 2.0F);
    for (const DepthMark& object : style.marks) {
        mark(object.z, object.color ? object.color : palette.quiet, object.label, object.label, 1.25F);
    }
    return inner::DrawLineNames(draw, plot, names);
}

ChartAxis AxisOrDefault(const ChartAxis& axis) {
    const bool sensible = axis.min > 0.0 && std::isfinite(axis.max) && axis.max >= 1.01 * axis.min;
    const PrecisionChartStyle standard;
    return sensible ? axis : ChartAxis{.title = axis.title, .min = standard.x.min, .max = standard.x.max};
}

}  // namespace

bool PrecisionChart(const char* id, std::span<const ChartCurve> curves, double& near, double& far,
                    const PrecisionChartStyle& style) {
    const ImVec2 size = inner::AreaSize(style.size, ImVec2(160, 120));
    const Group group(id);
    const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size.x, min.y + size.y);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const Palette& palette = CurrentContext().palette;
    std::vector<ChartCurve> all(curves.begin(), curves.end());
    all.insert(all.end(), style.terms.begin(), style.terms.end());

    draw->PushClipRect(min, max, true);
    draw->AddRectFilled(min, max, Shown(palette.view_ground), Px(4));
    const inner::Face face = inner::FaceOf(CurrentContext().fonts.note);
    float widest = 0.0F;
    for (const ChartCurve& curve : all) widest = std::max(widest, face.Measure(curve.name).x);
    const float label_room = std::max(std::min(widest + Px(16), 0.34F * size.x), Px(14));
    const ChartPlot plot =
        inner::DrawAxes(draw, min, max, all, {.x = AxisOrDefault(style.x), .y = style.y}, label_room);

    inner::DragLinesUse use;
    const Distances before{near, far}, edited = UseLines(plot, before, style, use);
    ImGui::SetCursorScreenPos(min);
    ImGui::InvisibleButton("chart", size);
    Record("chart");
    // ImGui reports an item as hovered even if an earlier one overlaps it.
    const bool hovered = ImGui::IsItemHovered() && !use.low.hovered && !use.high.hovered;

    DrawCutOff(draw, plot, edited);
    for (const ChartCurve& curve : curves) {
        if (!curve.emphasized) inner::DrawPlainCurve(draw, plot, curve, false);
    }
    for (const ChartCurve& term : style.terms) inner::DrawPlainCurve(draw, plot, term, true);
    for (const ChartCurve& curve : curves) {
        if (curve.emphasized) inner::DrawPlainCurve(draw, plot, curve, false);
    }
    const std::vector<Box> taken = DrawVerticals(draw, plot, edited, curves, style, use);
    for (const inner::EndLabel& label : inner::PlaceLabels(plot, all, max.x - Px(4), taken)) {
        const ChartCurve& curve = all[label.curve];
        const bool stands_back = !curve.emphasized && label.curve < curves.size();
        inner::DrawEndLabel(draw, label, curve.name, Shown(stands_back ? palette.quiet : curve.color));
        MarkLine(std::string(style.target) + "." + curve.name, label.box.min, label.box.max);
    }
    if (hovered) inner::DrawPrecisionReadout(draw, {min, max}, plot, ImGui::GetIO().MousePos, curves, style);
    draw->PopClipRect();

    const bool near_changed = IsDistance(near) && edited.near != near;
    const bool far_changed = IsDistance(far) && edited.far != far;
    if (near_changed) near = edited.near;
    if (far_changed) far = edited.far;
    return near_changed || far_changed;
}

}  // namespace widgets
