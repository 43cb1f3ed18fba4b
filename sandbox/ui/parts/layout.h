// The layout of the window for every size: in narrow windows, parts fold rather than overlap. Pure functions.
#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

#include "state/view_params.h"

namespace viewing {

struct Rect {
    ImVec2 min{0, 0}, max{0, 0};

    float width() const { return max.x - min.x; }
    float height() const { return max.y - min.y; }
    bool empty() const { return width() < 1.0F || height() < 1.0F; }
    glm::ivec2 size_px() const { return {static_cast<int>(width()), static_cast<int>(height())}; }
    bool contains(ImVec2 point) const {
        return point.x >= min.x && point.y >= min.y && point.x < max.x && point.y < max.y;
    }
};

/// The small parts that the state lists. Beside a maximized view they form a column at the right, with the matrices
/// above the controls; otherwise they are in the usual columns. Unlisted parts are hidden.
struct Telling {
    int matrices = 0;                             ///< their number, including the followed point and display()
    float short_matrices = 0, tall_matrices = 0;  ///< height without and with symbols, design pixels
    float first_symbols = 0;                      ///< extra height of the first matrix's symbols
    int control_rows = 0;                         ///< 0: no controls
    bool has_vectors = false;                     ///< several numbers in a row, which need a wider column

    bool is_on() const { return matrices > 0 || control_rows > 0; }
};

/// The lower views on stage: those that a step of a lesson names or, without a lesson, those that fit. Sizes are in
/// design pixels.
struct StageViews {
    bool left = false, right = false;
    ImVec2 least_left{0, 0}, least_right{0, 0};
    float lowest_left = 96.0F, lowest_right = 96.0F;  ///< heights to which a crowded stage may shrink them
};

/// The user's arrangement; sizes in design pixels.
struct Arrangement {
    bool panel_folded = false;
    bool matrices_folded = false;
    bool prefers_matrices = false;  ///< if only one column fits
    bool prefers_column = false;    ///< in a short window, which otherwise shows only views
    ViewName maximized = ViewName::none;
    bool beside_matrices = false;      ///< the maximized view needs the matrices beside it
    bool prefers_lower_right = false;  ///< if only one of the lower views fits
    float least_lower = 240.0F;        ///< least width of each lower view if both are shown
    float least_area = 0.0F;           ///< least area of each lower view if both are shown, in square design pixels
    bool halves = false;               ///< two pictures instead of one in the camera view
    bool bare = false;                 ///< only the maximized view: no bars, no header
    Telling telling;                   ///< the small parts beside the maximized view
    StageViews stage;                  ///< when presenting
    float panel_width = 298.0F;
    float matrices_width = 360.0F;
    float lower_height = 232.0F;
    float least_camera = 0.55F;  ///< the smallest fraction of the height that the lower views leave for the camera view
    float lower_split = 0.5F;    ///< the left view's fraction of the width
    float caption_px = 0.0F;     ///< height of the caption below the camera's picture, in pixels
    float strip_px = 0.0F;       ///< height of the lesson's strip below everything, in pixels
    bool has_strip = true;       ///< shows a lesson's strip; false for pictures without the lesson's text
    bool in_lesson = false;      ///< a lesson's steps have one scale, whichever view they maximize
    bool presents = false;       ///< in front of an audience: no bars, text legible from the back row
    bool embedded = false;       ///< part of another page: no bars, no shortcuts of its own
};

struct Layout {
    Rect top_bar, status_bar;
    Rect panel, matrices;                  ///< empty when folded
    Rect sections;                         ///< links to the panel's sections that are out of sight; may be empty
    Rect camera, lower_left, lower_right;  ///< pictures, without their headers; empty when hidden
    Rect beside;                           ///< a second picture in the right half of the camera's area
    Rect strip;                            ///< the lesson's strip; empty without a lesson
    Rect caption;                          ///< below the camera's picture and the one beside it; may be empty
    bool caption_is_folded = false;        ///< the caption shows only the preset's title
    float header_height = 0.0F;            ///< above each picture
    bool matrices_fit = true;              ///< false: the window is too narrow for both columns
    bool lower_fit = true;                 ///< false: the window is too narrow for both lower views
    bool is_short = false;                 ///< a phone held sideways: views side by side, columns on request
    bool lower_in_column = false;          ///< on stage: the lower views are to the right of the camera view
    bool panel_over_picture = false;       ///< on stage: the controls are on a plate over the camera's picture
    bool column_fits = true;               ///< on stage: no part of the column is too short
};

/// Returns the factor by which to enlarge everything when presenting or while one view fills the window. `scale`: see
/// lay_out().
float enlargement(ImVec2 window_px, float scale, const Arrangement& arrangement);

/// Sizes of type that differ for an audience, in design pixels.
struct TypeSizes {
    float small = 13.0F;    ///< notes, and numbers in tables
    float matrix = 16.0F;   ///< entries of matrices
    float caption = 19.0F;  ///< a lesson's sentences

    bool operator==(const TypeSizes&) const = default;
};
/// On stage, the type of a lesson's sentences is 1/30 of the window's height, and no number is smaller than 1/40.
constexpr TypeSizes stage_type{15.5F, 20.0F, 20.4F};
TypeSizes type_sizes(const Arrangement& arrangement);

/// `scale`: pixels per design pixel.
Layout lay_out(ImVec2 window_px, float scale, const Arrangement& arrangement);

}  // namespace viewing
