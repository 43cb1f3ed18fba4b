// Drawing of a PrecisionChart, apart from its interaction: curves without markers, the names of vertical lines, and the
// readout. See precision_chart.cpp for usage.
#pragma once

#include "widgets/depth.h"
#include "widgets/depth/depth_inner.h"

namespace widgets::inner {

/// Interpolates a curve linearly on logarithmic axes. Returns nullopt in gaps and beyond the curve's ends.
std::optional<double> ValueAt(const ChartCurve& curve, double x);

/// Returns the first emphasized curve, which the readout and the marks use; null if there is none.
const ChartCurve* EmphasizedOf(std::span<const ChartCurve> curves);

/// Draws a curve without markers: as dots if `dotted`, otherwise as a line, which is faint unless the curve is
/// emphasized.
void DrawPlainCurve(ImDrawList* draw, const ChartPlot& plot, const ChartCurve& curve, bool dotted);
/// Returns the color of a curve that is not emphasized.
ImU32 FaintColor(ImU32 color);

/// A vertical line's name, preferably near the top of the plot.
struct LineName {
    float x;
    std::string text;
    ImU32 color;
    const char* recorded_as;
};
/// Draws names beside their lines, in order: each in the highest free row, crossing no other line if possible. Omits
/// names that do not fit. Returns the covered areas.
std::vector<Box> DrawLineNames(ImDrawList* draw, const ChartPlot& plot, std::span<const LineName> names);

/// Draws the values of the emphasized curve and of the terms at the pointer.
void DrawPrecisionReadout(ImDrawList* draw, const Box& area, const ChartPlot& plot, ImVec2 pointer,
                          std::span<const ChartCurve> curves, const PrecisionChartStyle& style);

}  // namespace widgets::inner
