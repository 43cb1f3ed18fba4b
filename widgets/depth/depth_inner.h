// Shared by the diagrams of depth.h: draggable vertical lines, and the readout box beside the pointer.
#pragma once

#include <optional>
#include <string>

#include "widgets/chart/chart_inner.h"
#include "widgets/inner.h"

namespace widgets::inner {

/// Returns the value at a pixel of a logarithmic axis.
double ValueAtPixel(const LogScale& scale, double pixel);

/// Returns an area's size in pixels: `wanted` or, where that is 0, the available size, but at least `least` (in design
/// pixels).
ImVec2 AreaSize(ImVec2 wanted, ImVec2 least);

/// A vertical line that can be dragged sideways.
struct DragLine {
    const char* id;    ///< also its name for the recorder
    float x;           ///< in pixels
    std::string text;  ///< for the recorder
    const char* tip_title;
    const char* tip;
};
struct DragLineUse {
    bool held = false, hovered = false, reset = false;  ///< reset: right-clicked
    std::optional<double> x;                            ///< dragged position, in pixels, unclamped
};
/// Adds the ImGui item of a line from `top` to `bottom`. Moves the cursor.
DragLineUse UseLine(const DragLine& line, float top, float bottom);
struct DragLinesUse {
    DragLineUse low, high;
};
/// Adds the items of two lines. Where they overlap, the pointer grabs the nearer line.
DragLinesUse UseLines(const DragLine& low, const DragLine& high, float top, float bottom);
/// Draws a line with a grip at its top.
void DrawDragLine(ImDrawList* draw, float x, float top, float bottom, ImU32 color, const DragLineUse& use);

/// Draws a box with a heading and lines beside a point, inside the area. Recorded as "readout".
void DrawReadoutBox(ImDrawList* draw, const Box& area, ImVec2 at, const std::string& heading,
                    std::span<const std::string> lines);

}  // namespace widgets::inner
