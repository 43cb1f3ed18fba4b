// The picture of a PrecisionChart, apart from its hands: curves without markers, vertical lines with names, the values
// under the pointer. Read precision_chart.cpp for its use.
#pragma once

#include "widgets/depth.h"
#include "widgets/depth/depth_inner.h"

namespace widgets::inner {

/// The value of a curve between its points, straight on logarithmic axes; empty where it has a gap or has ended.
std::optional<double> ValueAt(const ChartCurve& curve, double x);

/// The emphasised curve that the pointer and the marks refer to; null: none.
const ChartCurve* EmphasisedOf(std::span<const ChartCurve> curves);

/// A line without markers; dotted for terms, pale where it stands back.
void DrawPlainCurve(ImDrawList* draw, const ChartPlot& plot, const ChartCurve& curve, bool dotted);
/// What a curve that stands back is drawn in.
ImU32 FaintColor(ImU32 color);

/// A vertical line's name, wanted near the top of the plot.
struct LineName {
    float x;
    std::string text;
    ImU32 color;
    const char* recorded_as;
};
/// Beside their lines, the first first, each in the highest row where it is free and over no other line, where there is
/// one; without room it is left out. Returns what they cover.
std::vector<Box> DrawLineNames(ImDrawList* draw, const ChartPlot& plot, std::span<const LineName> names);

/// The emphasised curve's value, and the terms', at the pointer.
void DrawPrecisionReadout(ImDrawList* draw, const Box& area, const ChartPlot& plot, ImVec2 pointer,
                          std::span<const ChartCurve> curves, const PrecisionChartStyle& style);

}  // namespace widgets::inner
