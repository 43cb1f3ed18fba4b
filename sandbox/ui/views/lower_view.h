// A lower view's entry: all that the window, the pictures and the measurements need to know about it. Each view of
// state/topic.h has one, in its own source or in ui/window/lower_view_entries.cpp.
#pragma once

#include "ui/views/views.h"

namespace viewing {

/// What a lower view is drawn from.
struct FrameContext {
    ViewState& state;
    Session& session;
    const Derived& derived;
    const FramePlan& plan;  ///< the camera's frame
    const Pictures& pictures;
    Rect rect;
    ImTextureID picture = nullptr;  ///< drawn by GL; null for a view without a picture
};

/// What GL draws for a view that has no camera of its own.
enum class LowerPicture { none, depth_buffer, after_pass, mirror_ways };

struct LowerView {
    const char* title;
    /// Draws the view below its header; may also add items to the header's line.
    void (*draw)(const FrameContext& frame);
    /// Returns the view's own camera, from which GL draws the view's picture; null for views without such a camera.
    /// `rect`: the view's rectangle.
    ObserverView (*camera)(const Params& params, const Derived& derived, const Scene& scene,
                           const Rect& rect) = nullptr;
    LowerPicture picture = LowerPicture::none;
    ImVec2 least_size{360.0F, 150.0F};  ///< the smallest that the back row can read on stage; design pixels
    float lowest = 96.0F;               ///< least height on a crowded stage; a table must still show all its content
    const char* target = nullptr;       ///< a second name, besides "view:NAME", by which lessons cover or highlight it
    bool turns = false;                 ///< a drag turns the view's camera
    bool reads_pixel = false;           ///< shows values of the pixel that is pinned or under the pointer
    bool reads_fragments = false;       ///< shows all surfaces along that pixel's ray
    bool reads_cells = false;           ///< shows a block of pixels, and the draw calls that touch it
    bool explains_pixel = false;        ///< shows where that pixel's color comes from
    bool reads_histogram = false;       ///< shows how often each depth is stored
    bool counts_fighting = false;       ///< shows the fraction of wrong pixels
    bool has_derivation = false;        ///< a figure and lines of text, which need room
    bool wants_matrices = false;        ///< when maximized, has the matrices beside it
};

namespace lower_views {
using Entry = LowerView;
VIEWING_LOWER_VIEWS(VIEWING_ENTRY, VIEWING_ENTRY)
}  // namespace lower_views

/// Returns a topic's entry. `topic` must not be `automatic`; see topic_of().
const LowerView& lower_view(Topic topic);
inline const LowerView& lower_view(const Params& params, Slot slot) {
    return lower_view(topic_of(params, slot));
}

/// Whether one of the two slots shows a view with this property.
inline bool is_any_shown(const Params& params, bool LowerView::*property) {
    return lower_view(params, Slot::left).*property || lower_view(params, Slot::right).*property;
}

/// Whether a view examines the pinned pixel.
inline bool examines_pixel(const LowerView& view) {
    return view.reads_fragments || view.reads_cells || view.explains_pixel;
}
/// Whether one of the two slots shows such a view. If so, a click in the camera view pins a pixel.
inline bool examines_pixel(const Params& params) {
    return examines_pixel(lower_view(params, Slot::left)) || examines_pixel(lower_view(params, Slot::right));
}

/// The topics' titles for the list, in the order of Topic; the first one is `automatic`.
std::span<const char* const> topic_titles();

/// Draws one of the two lower views with its header. `is_alone`: the other view does not fit, so its name is a button
/// that shows it.
void draw_lower_view(Slot slot, const FrameContext& frame, bool is_alone);

}  // namespace viewing
