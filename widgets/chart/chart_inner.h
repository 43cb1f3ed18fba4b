// Shared by the parts of a chart: axes (log_axes.cpp), curves (chart_curves.cpp), and names (chart_labels.cpp).
#pragma once

#include "widgets/diagrams.h"
#include "widgets/inner.h"

namespace widgets::inner {

/// A logarithmic axis: maps values to pixels.
struct LogScale {
    double low, high;  ///< base-10 logarithms of its ends
    float from, to;    ///< pixel positions of its ends

    float At(double value) const;  ///< `value` must be > 0; far outside the plot, the result is clamped
    bool Holds(double value) const;
};

/// Returns whether a point is valid on logarithmic axes: finite and positive.
bool CanBeDrawn(const glm::dvec2& point);

/// The rectangle between the axes, with both scales.
struct ChartPlot {
    ImVec2 min, max;
    LogScale x, y;
};

/// Returns whether `box` overlaps none of `taken`.
bool IsFree(const Box& box, std::span<const Box> taken);

float Distance(ImVec2 a, ImVec2 b);
/// Interpolates: a at t = 0, b at t = 1.
ImVec2 Between(ImVec2 a, ImVec2 b, float t);
ImVec2 PlaceOf(const ChartPlot& plot, const glm::dvec2& point);
bool IsInPlot(const ChartPlot& plot, const glm::dvec2& point);
/// Clips a line to the plot. Returns false if nothing remains.
bool ClipToPlot(const ChartPlot& plot, ImVec2& a, ImVec2& b);

/// Draws the axes, with their ticks and titles around the plot; leaves `label_room` pixels free to the right of the
/// plot. Returns the plot.
ChartPlot DrawAxes(ImDrawList* draw, ImVec2 min, ImVec2 max, std::span<const ChartCurve> curves,
                   const LogChartStyle& style, float label_room);

/// Draws a curve; `index` selects its markers and dashes.
void DrawCurve(ImDrawList* draw, const ChartPlot& plot, const ChartCurve& curve, std::size_t index, ImU32 color);
void DrawDashedVertical(ImDrawList* draw, const ChartPlot& plot, float x, ImU32 color, float width);

struct EndLabel {
    std::size_t curve;
    ImVec2 end;  ///< of the curve
    Box box;
};
/// Places names beside the curves' ends, to the left of `right`. Nudges them so that none covers another name or
/// `taken`; also avoids curves if a small nudge suffices. Places emphasized names first and omits names that do not
/// fit.
std::vector<EndLabel> PlaceLabels(const ChartPlot& plot, std::span<const ChartCurve> curves, float right,
                                  const std::vector<Box>& taken);
void DrawEndLabel(ImDrawList* draw, const EndLabel& label, const char* name, ImU32 color);

}  // namespace widgets::inner
