// Where everything is in the window, for every size: narrow windows fold before they overlap. Pure.
#pragma once

#include <imgui.h>

#include <glm/glm.hpp>

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

enum class ViewName { none, camera, lower_left, lower_right, matrices };

/// The small things that the state lists: beside a maximised view a column of matrices above controls at the right; in
/// the columns else. What is not listed is not there.
struct Telling {
    bool matrices = false;
    int control_rows = 0;      ///< 0: no controls
    bool has_vectors = false;  ///< several numbers in a row, whose digits want a wider column

    bool is_on() const { return matrices || control_rows > 0; }
};

/// What a person has arranged; sizes in design pixels.
struct Arrangement {
    bool panel_folded = false;
    bool matrices_folded = false;
    bool prefers_matrices = false;  ///< where there is room for one column only
    bool prefers_column = false;    ///< in a short window, where the views come first
    ViewName maximised = ViewName::none;
    bool beside_matrices = false;      ///< what is maximised is read together with the matrices
    bool prefers_lower_right = false;  ///< where there is room for one of the lower views only
    bool halves = false;               ///< two pictures in the place of the camera's
    bool bare = false;                 ///< the maximised view and nothing else: no bars, no header
    Telling telling;                   ///< what stands beside the maximised view for what is being told
    float panel_width = 298.0F;
    float matrices_width = 360.0F;
    float lower_height = 232.0F;
    float lower_split = 0.5F;  ///< share of the left one's width
    float caption_px = 0.0F;   ///< what the caption needs below the camera's picture, in pixels
    float strip_px = 0.0F;     ///< what the lesson's strip needs below everything, in pixels
    bool has_strip = true;     ///< of a lesson: false for pictures without its texts
    bool presents = false;     ///< a lesson in front of a room: no bars, and type to be read from the back row
    bool embedded = false;     ///< a part of somebody else's page: no bars, no keys of its own
};

struct Layout {
    Rect top_bar, status_bar;
    Rect panel, matrices;                  ///< empty when folded
    Rect camera, lower_left, lower_right;  ///< pictures, without their header lines; empty when hidden
    Rect beside;                           ///< a second picture right of the camera's, which then has the other half
    Rect strip;                            ///< of the lesson; empty without one
    Rect caption;                          ///< below the camera's picture and the one beside it; empty without one
    bool caption_is_folded = false;        ///< it is the preset's title alone
    float header_height = 0.0F;            ///< above each picture
    bool matrices_fit = true;              ///< false: the window is too narrow for both columns
    bool lower_fit = true;                 ///< false: it is too narrow for both of the lower views
    bool is_short = false;                 ///< a telephone held across: the views side by side, columns on request
    bool lower_are_wide = false;           ///< the panel ends above the lower views, which have the whole width
};

/// How much larger everything is drawn while one view has the whole window, so that its text grows with it; `scale` as
/// below.
float enlargement(ImVec2 window_px, float scale, const Arrangement& arrangement);

/// The size of notes and of numbers in tables, in design pixels: what a room reads is nowhere so small as what one
/// reads alone.
constexpr float usual_small_type = 13.0F, small_type_for_a_room = 15.0F;
float small_type(const Arrangement& arrangement);

/// `scale`: pixels per design pixel.
Layout lay_out(ImVec2 window_px, float scale, const Arrangement& arrangement);

}  // namespace viewing
