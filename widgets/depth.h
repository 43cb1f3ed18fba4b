// Diagrams of the depth buffer: its precision between near and far, the positions of its codes, the depths in a
// picture, single pixels, and a divider between two pictures. As in widgets.h, every widget edits the value it is given
// and returns whether it did. See show_depth_demo.cpp for usage.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "widgets/diagrams.h"

namespace widgets {

// ---- precision -------------------------------------------------------------------------------------

/// An object at some eye distance, marked by a vertical line.
struct DepthMark {
    const char* label;
    double z;         ///< in the chart's unit; hidden unless finite and positive
    ImU32 color = 0;  ///< 0: neutral
};

struct PrecisionChartStyle {
    /// The range over which near and far can be dragged; it does not depend on them. If it is invalid, the chart uses
    /// 10⁻³…10⁴.
    ChartAxis x{.title = "eye distance z", .min = 1e-3, .max = 1e4};
    ChartAxis y{.title = "width Δz"};              ///< without a range, spans the decades of the curves
    std::span<const ChartCurve> terms = {};        ///< parts of the step, drawn dotted; also in the readout
    std::span<const DepthMark> marks = {};         ///< the scene's objects
    double cursor_z = 0.0;                         ///< distance of the pixel pointed at in another view; ≤ 0: none
    double default_near = 0.1, default_far = 100;  ///< a right-click on a line resets to these
    const char* target = "";  ///< the chart's name as in targets.h; lines add ".near" and ".far", curves their names
    ImVec2 size{0.0F, 0.0F};  ///< in pixels; 0: the available size. At least 160×120 design pixels
};

/// Plots the step Δz of a depth buffer over the eye distance z, on logarithmic axes. Curves that are not emphasized are
/// faint; no curve has markers. Near and far are vertical lines to drag (Alt for finer steps); a right-click resets
/// one to its default, or both if near < far would not hold. 0 < near < far holds after every edit. If a distance is
/// not finite and positive, it has no line; if it is outside the axis, its line is at the axis's end. The readout shows
/// z, and Δz of the first emphasized curve. Returns true when near or far was edited.
bool PrecisionChart(const char* id, std::span<const ChartCurve> curves, double& near, double& far,
                    const PrecisionChartStyle& style);

// ---- codes -----------------------------------------------------------------------------------------

struct CodeTicksStyle {
    const char* depth_title = "depth: equal steps";
    const char* z_title = "eye distance z";
    const char* first_depth = "0";              ///< at the left end of the upper row
    const char* last_depth = "1";               ///< at its right end
    bool ends_at_far = true;                    ///< false: codes reach beyond `far`, where the axis ends
    std::span<const std::uint32_t> codes = {};  ///< the stored integer of each tick, for the readout; may be empty
    ImVec2 size{0.0F, 0.0F};                    ///< in pixels; 0: the available size. At least 180×120 design pixels
};

/// Draws stored codes between near and far as two rows of ticks joined by lines. The upper row has the codes, equally
/// spaced; the lower row has the eye distances that they represent. `eye_distances` belong to equally spaced codes,
/// from left to right; if they are too dense, only some are drawn. A distance outside near…far has no line. Without
/// distances, or unless near and far are finite and near < far, shows a sentence instead. Returns the index of the
/// tick under the pointer, otherwise −1.
int CodeTicks(const char* id, std::span<const double> eye_distances, double near, double far,
              const CodeTicksStyle& style = {});

// ---- counts ----------------------------------------------------------------------------------------

struct HistogramStyle {
    const char* title = "depth";     ///< names the values along the axis
    const char* counted = "pixels";  ///< names what the bars count
    bool logarithmic = false;        ///< bar heights show log(1 + count)
    std::uint64_t unwritten = 0;     ///< counted separately, in an extra bar at the right; 0: none
    const char* unwritten_name = "not written";
    ImVec2 size{0.0F, 0.0F};  ///< in pixels; 0: the available size. At least 200×120 design pixels
};

/// Draws counts of values between `min` and `max` as bars of equal width, and two draggable lines at the ends of the
/// range of interest (after every edit, x < y, both within min…max). "Fit" or a double-click selects the range that has
/// counts; a right-click selects the full range. An invalid range is shown as the full one. The highest of `counts`
/// sets the vertical scale; the bar of unwritten values is cut off if it is higher. Without counts or with min ≥ max,
/// shows a sentence and edits nothing. Returns true when `range` was edited.
bool Histogram(const char* id, std::span<const std::uint32_t> counts, double min, double max, glm::dvec2& range,
               const HistogramStyle& style = {});

// ---- pixels one by one -----------------------------------------------------------------------------

struct Cell {
    ImU32 color = 0;             ///< opaque; alpha 0: the neutral color of fields
    std::string_view text = {};  ///< short: a number
    bool accent = false;         ///< just changed: outlined in the accent color
    bool unwritten = false;      ///< crossed by a diagonal
};

struct CellGridStyle {
    int lit = -1;             ///< the cell under the pointer in another view
    int* hovered = nullptr;   ///< receives the cell under the pointer, or −1
    ImVec2 size{0.0F, 0.0F};  ///< in pixels; 0: the available size. At least 40×40 design pixels
};

/// The maximum number of cells that a grid can draw, and the maximum number for which it still draws their text.
constexpr int most_cells = 4096, most_cells_with_text = 1024;

/// Draws a block of pixels as large squares in the middle of the area. Each square has its text in black or white,
/// whichever has more contrast; pointing at a cell shows text that does not fit. `cells`: row by row, top row first;
/// missing cells stay empty. A click selects a cell. A click on the selected cell or outside the cells, or a
/// right-click, clears the selection. With too many cells or none, shows a sentence instead. Returns true when
/// `selected` (−1: none) changed.
bool CellGrid(const char* id, std::span<const Cell> cells, int columns, int rows, int& selected,
              const CellGridStyle& style = {});

// ---- two pictures in one area ----------------------------------------------------------------------

struct DividerStyle {
    const char* left = "";  ///< names of the two sides, shown beside the line at the top if they fit
    const char* right = "";
    bool names_at_bottom = false;  ///< when something else covers the top
    float default_share = 0.5F;    ///< a right-click resets to it
};

/// Draws a line from top to bottom over the picture in min…max; the user drags it sideways. `share`: the fraction of
/// the width to the left of the line, 0…1. Call after drawing the picture and before the item that handles the
/// picture's mouse input, since the first item has priority. Leaves the cursor in place. A NaN share counts as the
/// default. Returns true when `share` was edited.
bool Divider(const char* id, ImVec2 min, ImVec2 max, float& share, const DividerStyle& style = {});

}  // namespace widgets
