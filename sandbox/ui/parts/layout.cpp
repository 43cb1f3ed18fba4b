#include "ui/parts/layout.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

Rect rounded(float left, float top, float right, float bottom) {
    return {{std::round(left), std::round(top)},
            {std::round(std::max(left, right)), std::round(std::max(top, bottom))}};
}

/// Cuts the caption off the bottom of the camera's picture.
void cut_caption(Layout& layout, float height, float gap) {
    if (height <= 0.0F) return;
    layout.caption = layout.camera;
    layout.caption.min.y = layout.camera.max.y - std::ceil(height);
    layout.camera.max.y = layout.caption.min.y - std::round(gap);
}

void divide_camera(Layout& layout, const Arrangement& arrangement, float gap) {
    if (!arrangement.halves) return;
    layout.beside = layout.camera;
    const float middle = (layout.camera.min.x + layout.camera.max.x) * 0.5F;
    // Make both the same size, so that corresponding pixels are in the same place.
    const float width = std::floor((layout.camera.width() - std::max(gap, 2.0F)) * 0.5F);
    layout.camera.max.x = layout.camera.min.x + width;
    layout.beside.min.x = std::max(middle, layout.beside.max.x - width);
    layout.beside.max.x = layout.beside.min.x + width;
}

constexpr float width_of_vectors = 360.0F;  ///< design pixels; wide enough for several numbers in a row

/// The height of the listed controls with their headings.
float height_of_controls(const Telling& telling, float scale) {
    return (static_cast<float>(telling.control_rows) * 27.0F + 34.0F) * scale;
}

/// Cuts a column for the listed parts off the area of the maximized view; returns the rest.
Rect cut_small_things(Layout& layout, const Arrangement& arrangement, Rect whole, float scale) {
    const Telling& telling = arrangement.telling;
    const float gap = 10.0F * scale;
    const bool is_big_matrices = arrangement.maximized == ViewName::matrices;
    const bool has_matrices = telling.matrices && !is_big_matrices && !arrangement.matrices_folded;
    const bool has_controls = telling.control_rows > 0 && !arrangement.panel_folded;
    if (has_matrices || has_controls) {
        const bool is_wide = has_matrices || telling.has_vectors;
        const float least = is_wide ? width_of_vectors : arrangement.panel_width, share = is_wide ? 0.34F : 0.25F;
        const float width = std::min(std::max(least * scale, share * whole.width()), 0.5F * whole.width());
        const Rect column = rounded(whole.max.x - width, whole.min.y, whole.max.x, whole.max.y);
        const float wanted = height_of_controls(telling, scale);
        const float controls = has_matrices ? std::min(wanted, 0.5F * column.height()) : column.height();
        const float split = column.max.y - (has_controls ? controls : 0.0F);
        if (has_controls) layout.panel = rounded(column.min.x, split, column.max.x, column.max.y);
        if (has_matrices)
            layout.matrices = rounded(column.min.x, column.min.y, column.max.x, split - (has_controls ? gap : 0.0F));
        whole.max.x = column.min.x - gap;
    }
    return whole;
}

}  // namespace

float enlargement(ImVec2 window_px, float scale, const Arrangement& arrangement) {
    // When presenting, the lesson's text is 1/36 of the window's height, and numbers are at least 1/48 of it.
    constexpr float text_px = 17.0F, number_px = 14.0F;  // design pixels
    if (arrangement.presents && !arrangement.bare)
        return std::max(window_px.y / (36.0F * text_px), window_px.y / (48.0F * number_px)) / scale;
    if (arrangement.maximized == ViewName::none || arrangement.bare) return 1.0F;
    // Enlarge only as long as the bar above still fits.
    const float room = std::min(window_px.x / (1060.0F * scale), window_px.y / (600.0F * scale));
    return std::clamp(room, 1.0F, 1.5F);
}

float small_type(const Arrangement& arrangement) {
    return arrangement.presents && !arrangement.bare ? small_type_for_a_room : usual_small_type;
}

Layout lay_out(ImVec2 window_px, float scale, const Arrangement& arrangement) {
    const auto px = [scale](float design) { return design * scale; };
    const bool bare = arrangement.bare && arrangement.maximized != ViewName::none;
    const bool has_bars = !bare && !arrangement.presents && !arrangement.embedded;
    const bool is_short = has_bars && window_px.y < px(420.0F);
    const bool has_status = has_bars && !(is_short && arrangement.strip_px > 0.0F);
    const float bar = has_bars ? px(40.0F) : 0.0F, status = has_status ? px(26.0F) : 0.0F,
                gap = bare ? 0.0F : px(10.0F);
    const float margin = bare ? 0.0F : px(4.0F);
    // When presenting, both lower views must be visible, because no button switches between them.
    const float least_view = px(420.0F), least_lower = px(arrangement.presents ? 160.0F : 240.0F);

    Layout layout;
    layout.is_short = is_short;
    layout.header_height = bare ? 0.0F : px(26.0F);
    layout.top_bar = rounded(0, 0, window_px.x, bar);
    layout.status_bar = rounded(0, window_px.y - status, window_px.x, window_px.y);
    // Keep space for the views: a taller strip is cut off at its lower edge.
    const float strip = std::min(bare ? 0.0F : arrangement.strip_px, 0.62F * window_px.y);
    if (strip > 0.0F) layout.strip = rounded(0, window_px.y - status - strip, window_px.x, window_px.y - status);
    const float top = bar + margin, bottom = window_px.y - status - strip - margin;

    bool panel = !arrangement.panel_folded, matrices = !arrangement.matrices_folded;
    if (arrangement.maximized != ViewName::none) {
        panel = false;
        matrices = arrangement.beside_matrices && !arrangement.telling.is_on();
    }
    const float least_panel = arrangement.presents && arrangement.telling.has_vectors ? width_of_vectors : 0.0F;
    const float panel_width = px(std::max(arrangement.panel_width, least_panel)),
                matrices_width = px(arrangement.matrices_width);
    layout.matrices_fit = !is_short && panel_width + matrices_width + least_view + 2 * gap <= window_px.x;
    if (is_short && strip <= 0.0F && !arrangement.prefers_column) panel = matrices = false;
    if (!layout.matrices_fit && panel && matrices) (arrangement.prefers_matrices ? panel : matrices) = false;
    if (panel && panel_width + px(240.0F) > window_px.x) panel = false;
    if (matrices && matrices_width + px(240.0F) > window_px.x) matrices = false;

    float left = gap, right = window_px.x - gap;
    if (panel) {
        layout.panel = rounded(0, top, panel_width, bottom);
        left = panel_width + gap;
    }
    if (matrices) {
        layout.matrices = rounded(window_px.x - matrices_width, top, window_px.x, bottom);
        right = window_px.x - matrices_width - gap;
    }

    Rect outer{{left, top}, {right, bottom}};
    if (arrangement.telling.is_on() && arrangement.maximized != ViewName::none)
        outer = cut_small_things(layout, arrangement, outer, scale);
    const Rect whole = rounded(outer.min.x, outer.min.y + layout.header_height, outer.max.x, outer.max.y);
    switch (arrangement.maximized) {
        case ViewName::camera:
            layout.camera = whole;
            cut_caption(layout, arrangement.caption_px, px(3.0F));
            divide_camera(layout, arrangement, gap);
            return layout;
        case ViewName::lower_left:
            layout.lower_left = whole;
            return layout;
        case ViewName::lower_right:
            layout.lower_right = whole;
            return layout;
        case ViewName::matrices:
            layout.matrices = rounded(outer.min.x, outer.min.y, outer.max.x, outer.max.y);
            return layout;
        case ViewName::none:
            break;
    }
    if (is_short) {  // one of the lower views, beside the camera view
        layout.lower_fit = false;
        const float split = left + 0.6F * (right - left);
        layout.camera = rounded(left, top + layout.header_height, split - gap * 0.5F, bottom);
        cut_caption(layout, arrangement.caption_px, px(3.0F));
        divide_camera(layout, arrangement, gap);
        (arrangement.prefers_lower_right ? layout.lower_right : layout.lower_left) =
            rounded(split + gap * 0.5F, top + layout.header_height, right, bottom);
        return layout;
    }
    // The lower views shrink first: the camera keeps at least 55 % of the height, or a little less when presenting,
    // since an audience must be able to read the lower views.
    const float share = arrangement.presents ? 0.52F : 0.45F;
    const float lower = std::min(px(arrangement.lower_height), (bottom - top) * share - layout.header_height);
    const float split_y = bottom - lower;
    // When presenting with few controls, the panel ends at the lower edge of the camera's picture, so that tables in
    // the views below get the width they need.
    const float controls = height_of_controls(arrangement.telling, scale);
    layout.lower_are_wide = arrangement.presents && panel && !matrices && arrangement.telling.control_rows > 0 &&
                            controls <= split_y - layout.header_height - top;
    layout.camera = rounded(left, top + layout.header_height, right, split_y - layout.header_height - px(6.0F));
    if (layout.lower_are_wide) {
        layout.panel.max.y = layout.camera.max.y;
        left = gap;
    }
    cut_caption(layout, arrangement.caption_px, px(3.0F));
    divide_camera(layout, arrangement, gap);
    layout.lower_fit = right - left >= 2.0F * least_lower + gap;
    if (!layout.lower_fit) {
        (arrangement.prefers_lower_right ? layout.lower_right : layout.lower_left) =
            rounded(left, split_y, right, bottom);
        return layout;
    }
    const float least = least_lower + gap * 0.5F;
    const float split_x = std::clamp(left + (right - left) * arrangement.lower_split, left + least, right - least);
    layout.lower_left = rounded(left, split_y, split_x - gap * 0.5F, bottom);
    layout.lower_right = rounded(split_x + gap * 0.5F, split_y, right, bottom);
    return layout;
}

}  // namespace viewing
