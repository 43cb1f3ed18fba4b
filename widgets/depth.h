// Diagrams of the depth buffer: how precise it is along the way from near to far, where its codes fall, which depths a
// picture holds, what stands in its pixels one by one, and a divider between two pictures. As in widgets.h, every one
// edits the value it is given and says whether it did. Read show_depth_demo.cpp for their use.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "widgets/diagrams.h"

namespace widgets {

// ---- precision -------------------------------------------------------------------------------------

/// A thing at an eye distance, marked by a vertical line.
struct DepthMark {
    const char* label;
    double z;         ///< in the unit of the chart; one that is not finite and positive is not shown
    ImU32 color = 0;  ///< 0: neutral
};

struct PrecisionChartStyle {
    /// Its range is what near and far can be dragged over, and does not follow them; without a sensible one 10⁻³…10⁴.
    ChartAxis x{.title = "eye distance z", .min = 1e-3, .max = 1e4};
    ChartAxis y{.title = "step Δz"};               ///< without a range: the whole decades of what is shown
    std::span<const ChartCurve> terms = {};        ///< what the step is made of: dotted; the pointer tells them, too
    std::span<const DepthMark> marks = {};         ///< the scene's objects
    double cursor_z = 0.0;                         ///< of the pixel under the pointer elsewhere; ≤ 0: none
    double default_near = 0.1, default_far = 100;  ///< what a right-click on a line resets it to
    const char* target = "";  ///< its name as in targets.h; then its lines are its ".near" and ".far", curves as named
    ImVec2 size{0.0F, 0.0F};  ///< in pixels; 0: what is there. From 160×120 design pixels on
};

/// The step Δz of a depth buffer against the eye distance z, on logarithmic axes: the emphasised curves strong, the
/// others faint, without markers. Near and far are vertical lines to drag (Alt for finer); a right-click resets one, or
/// both where the other is in its way. 0 < near < far holds after every edit; a distance that is not finite and
/// positive has no line, one outside the axis stands at its end. The pointer shows z and the Δz of the first emphasised
/// curve. True when near or far was edited.
bool PrecisionChart(const char* id, std::span<const ChartCurve> curves, double& near, double& far,
                    const PrecisionChartStyle& style);

// ---- codes -----------------------------------------------------------------------------------------

struct CodeTicksStyle {
    const char* depth_title = "depth: equal steps";
    const char* z_title = "eye distance z";
    const char* first_depth = "0";              ///< at the left end of the upper row
    const char* last_depth = "1";               ///< and at its right end
    std::span<const std::uint32_t> codes = {};  ///< the stored integer of each tick, for its readout; or empty
    ImVec2 size{0.0F, 0.0F};                    ///< in pixels; 0: what is there. From 200×120 design pixels on
};

/// Where stored codes fall between near and far: two rows of ticks, above the codes at equal distances, below the eye
/// distances that they mean, a line from each to its own. `eye_distances`: of codes that are equally far apart, from
/// left to right; as many are drawn as can be told apart. One that is not within near…far has no line. Without finite
/// near < far, a sentence. Returns the index of the tick under the pointer, else −1.
int CodeTicks(const char* id, std::span<const double> eye_distances, double near, double far,
              const CodeTicksStyle& style = {});

// ---- counts ----------------------------------------------------------------------------------------

struct HistogramStyle {
    const char* title = "depth";     ///< of what is counted
    const char* counted = "pixels";  ///< what there is so and so many of
    bool logarithmic = false;        ///< heights by log(1 + count)
    std::uint64_t unwritten = 0;     ///< counted apart, in a bar of its own at the right; 0: none
    const char* unwritten_name = "not written";
    ImVec2 size{0.0F, 0.0F};  ///< in pixels; 0: what is there. From 200×120 design pixels on
};

/// How often each value between `min` and `max` occurs: equally wide bars, and two lines to drag around the range that
/// is of interest (x < y holds after every edit, within min…max). "fit", or a double-click, takes the range that has
/// counts, a right-click all of it; a range that is none is shown as all. Bars are as high as the highest among
/// `counts`; that of what is unwritten is cut where it is higher. Without counts or with min ≥ max, a sentence and no
/// edit. True when `range` was edited.
bool Histogram(const char* id, std::span<const std::uint32_t> counts, double min, double max, glm::dvec2& range,
               const HistogramStyle& style = {});

// ---- pixels one by one -----------------------------------------------------------------------------

struct Cell {
    ImU32 color = 0;             ///< opaque; alpha 0: the neutral colour of fields
    std::string_view text = {};  ///< short: a number
    bool accent = false;         ///< outlined in the accent colour: it has just changed
    bool unwritten = false;      ///< crossed by a diagonal
};

struct CellGridStyle {
    int lit = -1;             ///< a cell that the pointer is on elsewhere
    int* hovered = nullptr;   ///< receives the cell under the pointer, or −1
    ImVec2 size{0.0F, 0.0F};  ///< in pixels; 0: what is there. From 40×40 design pixels on
};

/// The most cells that are drawn, and the most that have text.
constexpr int most_cells = 4096, most_cells_with_text = 1024;

/// A block of pixels as large squares in the middle of the area, each with its text in black or white, whichever can
/// be read; text that has no room is left out and told by the pointer instead. `cells` row by row, the top row first;
/// missing ones stay empty. A click selects a cell; a click on it again or beside the cells, or a right-click, none.
/// Too many cells, or none: a sentence. True when `selected` (−1: none) changed.
bool CellGrid(const char* id, std::span<const Cell> cells, int columns, int rows, int& selected,
              const CellGridStyle& style = {});

// ---- two pictures in one area ----------------------------------------------------------------------

struct DividerStyle {
    const char* left = "";  ///< what is left of it and right of it: shown beside it at the top, where there is room
    const char* right = "";
    float default_share = 0.5F;  ///< a right-click resets to it
    bool* held = nullptr;        ///< receives whether the pointer is on the line or drags it, and so not at the picture
};

/// A line from top to bottom over a picture in min…max, to be dragged sideways: `share` is the part left of it, 0…1.
/// Call it after the picture was drawn and before the item that takes the picture's mouse, since the first item comes
/// first. The cursor stays where it was. A share that is no number counts as the default. True when it was edited.
bool Divider(const char* id, ImVec2 min, ImVec2 max, float& share, const DividerStyle& style = {});

}  // namespace widgets
