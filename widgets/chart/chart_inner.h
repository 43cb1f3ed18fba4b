// What the parts of a chart share: axes (log_axes.cpp), curves (chart_curves.cpp), names (chart_labels.cpp).
#pragma once

#include "widgets/diagrams.h"
#include "widgets/inner.h"

namespace widgets::inner {

/// A logarithmic axis: from a value to a pixel and to a label.
struct LogScale {
    double low, high;  ///< decimal logarithms of its ends
    float from, to;    ///< pixels of its ends

    float At(double value) const;  ///< for a value > 0; far outside stays far outside
    bool Holds(double value) const;
};

/// Whether it has a place on logarithmic axes: finite and positive.
bool CanBeDrawn(const glm::dvec2& point);

/// The rectangle between the axes, with both scales.
struct ChartPlot {
    ImVec2 min, max;
    LogScale x, y;
};

/// Whether it overlaps none of them.
bool IsFree(const Box& box, std::span<const Box> taken);

float Distance(ImVec2 a, ImVec2 b);
/// a where t = 0, b where t = 1.
ImVec2 Between(ImVec2 a, ImVec2 b, float t);
ImVec2 PlaceOf(const ChartPlot& plot, const glm::dvec2& point);
bool IsInPlot(const ChartPlot& plot, const glm::dvec2& point);
/// Leaves of a line what is inside the plot; false where that is nothing.
bool ClipToPlot(const ChartPlot& plot, ImVec2& a, ImVec2& b);

/// Leaves room for ticks and titles around the plot, and `label_room` at its right; draws them.
ChartPlot DrawAxes(ImDrawList* draw, ImVec2 min, ImVec2 max, std::span<const ChartCurve> curves,
                   const LogChartStyle& style, float label_room);

/// `index` chooses marker and dash.
void DrawCurve(ImDrawList* draw, const ChartPlot& plot, const ChartCurve& curve, std::size_t index, ImU32 color);
void DrawDashedVertical(ImDrawList* draw, const ChartPlot& plot, float x, ImU32 color, float width);

struct EndLabel {
    std::size_t curve;
    ImVec2 end;  ///< of the curve
    Box box;
};
/// Beside the ends, left of `right`, nudged until none covers another or what is `taken`, nor a curve where that takes
/// little; without room a name is left out, an emphasised one last.
std::vector<EndLabel> PlaceLabels(const ChartPlot& plot, std::span<const ChartCurve> curves, float right,
                                  std::vector<Box> taken);
void DrawEndLabel(ImDrawList* draw, const EndLabel& label, const char* name, ImU32 color);

}  // namespace widgets::inner
