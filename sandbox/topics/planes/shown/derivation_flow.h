// The layout of a derivation's figure, controls, and lines in a view. Lines that do not fit beside the figure become
// smaller and form columns, the first of which begins below the figure. derivation_views.h draws them.
#pragma once

#include "topics/planes/shown/derivation_lines.h"
#include "ui/parts/layout.h"

namespace viewing {

struct DerivationFlow {
    ImVec2 figure;              ///< size in pixels, from the view's upper left corner; height 0: no figure
    bool is_wide = false;       ///< the figure is at the left, not at the top
    bool has_controls = false;  ///< the controls are below the figure, not above the lines
    int control_rows = 0;       ///< how many rows there is space for
    bool is_short = false;      ///< there is space for the results, but not for every step toward them
    float font_scale = 1.0F;    ///< of the lines; no digit becomes smaller than 9 pixels at the user's scale
    /// Each column's first line; the first column is below the figure. Empty: one column beside or below the figure.
    std::vector<std::size_t> columns;
    ImVec2 column;  ///< size of a column in pixels; the first one includes the figure

    static constexpr float least_bar = 215.0F;  ///< width of a step bar, in design pixels
    static constexpr float gap = 10.0F;         ///< between figure and lines, and between columns; design pixels
    static constexpr float padding = 2.0F;      ///< at both sides of the lines, for letters that extend past them
    static constexpr float foot = 12.0F;        ///< free space below the columns; design pixels
    static constexpr float control_gap = 3.0F;  ///< above each row of controls; design pixels
    float line_gap() const { return columns.empty() && font_scale == 1.0F ? 3.0F : 1.0F; }  ///< pixels
};

/// Returns how these lines fill a view of this size in pixels. The result depends on all lines, not only on those
/// written so far, so that nothing moves from step to step. Needs a current ImGui window. If space is short, first
/// keeps only two rows of controls, since the panel has the others, and then omits the figure, which the camera view
/// also has. `may_be_short`: no step is chosen, so the controls, too, may be omitted and, if that is not enough, every
/// line that is not a result.
DerivationFlow flow_of(const std::vector<DerivationLine>& lines, ImVec2 room, int control_rows, bool may_be_short);

/// Draws one line in the current window's font scale, small if the flow has columns.
void write_line(const DerivationLine& line, bool is_small);

}  // namespace viewing
