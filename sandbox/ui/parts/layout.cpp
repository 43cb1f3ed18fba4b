#include "ui/parts/layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

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

/// Divides the camera's picture into two of the same size, so that corresponding pixels are in the same place: side by
/// side or one above the other, whichever brings their shape closer to 3 : 2.
void divide_camera(Layout& layout, const Arrangement& arrangement, float gap) {
    if (!arrangement.halves) return;
    const Rect whole = layout.camera;
    layout.beside = whole;
    if (whole.width() < 1.5F * whole.height()) {
        const float height = std::floor((whole.height() - layout.header_height - std::max(gap, 2.0F)) * 0.5F);
        layout.camera.max.y = whole.min.y + height;
        layout.beside.min.y = whole.max.y - height;
        return;
    }
    const float width = std::floor((whole.width() - std::max(gap, 2.0F)) * 0.5F);
    layout.camera.max.x = whole.min.x + width;
    layout.beside.min.x = std::max((whole.min.x + whole.max.x) * 0.5F, whole.max.x - width);
    layout.beside.max.x = layout.beside.min.x + width;
}

// Design pixels.
constexpr float width_of_vectors = 360.0F;  ///< wide enough for several numbers in a row
constexpr float height_of_row = 27.0F;      ///< of a control

constexpr float heading_of_controls = 20.0F;  ///< not on stage

/// The height of the listed controls without a heading, in design pixels.
float height_of_controls(const Telling& telling) {
    constexpr float padding = 14.0F;
    return static_cast<float>(telling.control_rows) * height_of_row + padding;
}

/// A part of the column on stage. Sizes are in design pixels and exclude the header.
struct StagePart {
    Rect* rect;
    ImVec2 least;       ///< a smaller part is hard to read
    float most_height;  ///< more height would not help
    float lowest;       ///< for views only: the least height on a crowded stage
    bool is_view;       ///< has a header
};

/// How well the parts of a column fit. whole: at about their least heights. tight: only with clearly shorter views.
/// cut: only with views near or below their lowest heights.
enum class Fit { whole, tight, cut };

/// Places the parts from top to bottom, the last one at the lower edge. Each part gets its least height; parts that can
/// use more share the rest. If the column is too short, the views shrink first, and then all parts by the same factor.
Fit place_column(const std::vector<StagePart>& parts, const Rect& column, float header, float scale) {
    const float gap = 10.0F * scale;
    float fixed = gap * static_cast<float>(parts.size() - 1), least = 0.0F;
    for (const StagePart& part : parts) {
        fixed += part.is_view ? header : 0.0F;
        least += part.least.y * scale;
    }
    const float available = std::max(column.height() - fixed, 0.0F);
    // A shorter view is still legible; a matrix or a control would be cut off.
    constexpr float most_taken = 0.8F, tight = 0.4F;  // of what the views can spare
    const auto spare_of = [scale](const StagePart& part) { return std::max(part.least.y - part.lowest, 0.0F) * scale; };
    float spare = 0.0F;
    for (const StagePart& part : parts) spare += spare_of(part);
    const float taken = spare > 0.0F ? std::clamp((least - available) / spare, 0.0F, 1.0F) : 0.0F;
    const float shrink = std::min(1.0F, available / std::max(least - taken * spare, 1.0F));
    std::vector<float> heights;
    for (const StagePart& part : parts) heights.push_back(shrink * (part.least.y * scale - taken * spare_of(part)));
    float rest = available - std::accumulate(heights.begin(), heights.end(), 0.0F);
    for (std::size_t round = 0; round < parts.size() && rest > 1.0F; ++round) {
        const auto can_grow = [&](std::size_t i) { return heights[i] < parts[i].most_height * scale; };
        std::size_t growing = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) growing += can_grow(i) ? 1U : 0U;
        if (growing == 0) break;
        const float share = rest / static_cast<float>(growing);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (!can_grow(i)) continue;
            const float more = std::min(share, parts[i].most_height * scale - heights[i]);
            heights[i] += more;
            rest -= more;
        }
    }
    float top = column.min.y;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i + 1 == parts.size()) top = std::max(top, column.max.y - heights[i] - (parts[i].is_view ? header : 0.0F));
        if (parts[i].is_view) top += header;
        *parts[i].rect = rounded(column.min.x, top, column.max.x, top + heights[i]);
        top += heights[i] + gap;
    }
    if (least - most_taken * spare > available) return Fit::cut;
    return least - tight * spare > available ? Fit::tight : Fit::whole;
}

/// At most this many rows of controls go on a plate over the picture's lower right corner; more would cover objects.
/// The plate replaces a column that would have nothing but the controls, or relieves a column that would be too short
/// for its views or for the symbols of its first matrix.
constexpr int most_rows_on_plate = 2;

Rect plate_over(const Rect& picture, const Telling& telling, float width, float scale) {
    constexpr float margin = 10.0F;
    const ImVec2 corner(picture.max.x - margin * scale, picture.max.y - margin * scale);
    const float height = height_of_controls(telling);
    return rounded(std::max(corner.x - width * scale, picture.min.x + margin * scale), corner.y - height * scale,
                   corner.x, corner.y);
}

/// Lays out a lesson's step or a state for an audience. The main view is as large as possible. To its right, a column
/// contains everything else that the step or state shows: views, matrices, and controls, from top to bottom. The column
/// is as narrow as its parts allow. A preset's caption is below the main view and the column, like a lesson's texts.
void lay_out_stage(Layout& layout, Rect area, float scale, const Arrangement& arrangement) {
    const Telling& telling = arrangement.telling;
    const float gap = 10.0F * scale;
    if (arrangement.caption_px > 0.0F) {
        layout.caption = rounded(area.min.x, area.max.y - arrangement.caption_px, area.max.x, area.max.y);
        area.max.y = layout.caption.min.y - gap;
    }
    constexpr float endless = 1e6F;
    std::vector<StagePart> parts;
    if (const StageViews& views = arrangement.stage; arrangement.maximized == ViewName::none) {
        if (views.left) parts.push_back({&layout.lower_left, views.least_left, endless, views.lowest_left, true});
        if (views.right) parts.push_back({&layout.lower_right, views.least_right, endless, views.lowest_right, true});
        layout.lower_in_column = !parts.empty();
    }
    const bool has_matrices =
        telling.matrices > 0 && !arrangement.matrices_folded && arrangement.maximized != ViewName::matrices;
    // Without views, matrices fill the column.
    if (has_matrices)
        parts.push_back({&layout.matrices,
                         {430.0F, telling.short_matrices},
                         parts.empty() ? endless : telling.tall_matrices,
                         telling.short_matrices,
                         false});

    float hero_right = area.max.x;
    Fit fit = Fit::whole;
    const auto place = [&] {
        float width = 0.25F * area.width();
        for (const StagePart& part : parts) width = std::max(width, part.least.x * scale);
        // The main view keeps half of a wide area, and 46 % of a nearly square one.
        width = std::min(width, (area.width() > 2.0F * area.height() ? 0.5F : 0.535F) * area.width());
        hero_right = area.max.x - width - gap;
        fit = place_column(parts, {{hero_right + gap, area.min.y}, area.max}, layout.header_height, scale);
    };
    const float width_of_controls = telling.has_vectors ? width_of_vectors : arrangement.panel_width;
    if (telling.control_rows > 0 && !arrangement.panel_folded) {
        const bool is_alone = parts.empty();
        // A column that would have less than a row to spare counts as tight.
        const float height = height_of_controls(telling), with_spare = height + 20.0F;
        parts.push_back({&layout.panel, {width_of_controls, with_spare}, with_spare, with_spare, false});
        place();
        parts.back().least.y = parts.back().most_height = parts.back().lowest = height;
        const bool has_picture = arrangement.maximized == ViewName::none || arrangement.maximized == ViewName::camera;
        const float with_symbols = std::floor((telling.short_matrices + telling.first_symbols) * scale);
        const bool is_tight = fit != Fit::whole || (has_matrices && layout.matrices.height() < with_symbols);
        layout.panel_over_picture = has_picture && telling.control_rows <= most_rows_on_plate && (is_alone || is_tight);
    }
    if (layout.panel_over_picture) {
        parts.pop_back();
        hero_right = area.max.x;
    }
    if (!parts.empty()) place();
    layout.column_fits = fit != Fit::cut;
    if (layout.panel_over_picture) {
        constexpr float alone = 250.0F;  // covers less of a picture that fills the stage
        const float width = parts.empty() && !telling.has_vectors ? alone : width_of_controls;
        layout.panel = plate_over({area.min, {hero_right, area.max.y}}, telling, width, scale);
    }
    const Rect hero = rounded(area.min.x, area.min.y + layout.header_height, hero_right, area.max.y);
    switch (arrangement.maximized) {
        case ViewName::lower_left:
            layout.lower_left = hero;
            return;
        case ViewName::lower_right:
            layout.lower_right = hero;
            return;
        case ViewName::matrices:
            layout.matrices = rounded(area.min.x, area.min.y, hero_right, area.max.y);
            return;
        default:
            layout.camera = hero;
            divide_camera(layout, arrangement, gap);
    }
}

/// Cuts a column for the listed parts off the area of the maximized view; returns the rest.
Rect cut_small_things(Layout& layout, const Arrangement& arrangement, Rect whole, float scale) {
    const Telling& telling = arrangement.telling;
    const float gap = 10.0F * scale;
    const bool is_big_matrices = arrangement.maximized == ViewName::matrices;
    const bool has_matrices = telling.matrices > 0 && !is_big_matrices && !arrangement.matrices_folded;
    const bool has_controls = telling.control_rows > 0 && !arrangement.panel_folded;
    if (has_matrices || has_controls) {
        const bool is_wide = has_matrices || telling.has_vectors;
        const float least = is_wide ? width_of_vectors : arrangement.panel_width, share = is_wide ? 0.34F : 0.25F;
        const float width = std::min(std::max(least * scale, share * whole.width()), 0.5F * whole.width());
        const Rect column = rounded(whole.max.x - width, whole.min.y, whole.max.x, whole.max.y);
        constexpr float long_name = 18.0F;  // above its numbers
        const float wanted = (heading_of_controls + height_of_controls(telling) + long_name) * scale;
        const float controls = has_matrices ? std::min(wanted, 0.5F * column.height()) : column.height();
        const float split = column.max.y - (has_controls ? controls : 0.0F);
        if (has_controls) layout.panel = rounded(column.min.x, split, column.max.x, column.max.y);
        if (has_matrices)
            layout.matrices = rounded(column.min.x, column.min.y, column.max.x, split - (has_controls ? gap : 0.0F));
        whole.max.x = column.min.x - gap;
    }
    return whole;
}

/// Cuts the panel and the matrices off the sides, as far as the window is wide enough; returns the rest.
Rect cut_columns(Layout& layout, const Arrangement& arrangement, Rect whole, float gap, float scale) {
    const float least_view = 420.0F * scale, least_rest = 240.0F * scale;
    const float window_px = layout.top_bar.width();
    const bool is_maximized = arrangement.maximized != ViewName::none;
    bool panel = !is_maximized && !arrangement.panel_folded;
    bool matrices =
        is_maximized ? arrangement.beside_matrices && !arrangement.telling.is_on() : !arrangement.matrices_folded;
    const float panel_width = arrangement.panel_width * scale, matrices_width = arrangement.matrices_width * scale;
    layout.matrices_fit = !layout.is_short && panel_width + matrices_width + least_view + 2 * gap <= window_px;
    if (layout.is_short && layout.strip.empty() && !arrangement.prefers_column) panel = matrices = false;
    if (!layout.matrices_fit && panel && matrices) (arrangement.prefers_matrices ? panel : matrices) = false;
    if (panel && panel_width + least_rest > window_px) panel = false;
    if (matrices && matrices_width + least_rest > window_px) matrices = false;
    if (panel) {
        layout.panel = rounded(0, whole.min.y, panel_width, whole.max.y);
        whole.min.x = panel_width + gap;
    }
    if (matrices) {
        layout.matrices = rounded(window_px - matrices_width, whole.min.y, window_px, whole.max.y);
        whole.max.x = window_px - matrices_width - gap;
    }
    return whole;
}

/// Places the camera view with the preset's caption.
void place_camera(Layout& layout, const Arrangement& arrangement, const Rect& area, float gap, float scale) {
    layout.camera = area;
    cut_caption(layout, arrangement.caption_px, 3.0F * scale);
    divide_camera(layout, arrangement, gap);
}

/// Places the maximized view.
void place_one_view(Layout& layout, const Arrangement& arrangement, const Rect& area, float gap, float scale) {
    const Rect below_title = rounded(area.min.x, area.min.y + layout.header_height, area.max.x, area.max.y);
    if (arrangement.maximized == ViewName::camera) place_camera(layout, arrangement, below_title, gap, scale);
    if (arrangement.maximized == ViewName::lower_left) layout.lower_left = below_title;
    if (arrangement.maximized == ViewName::lower_right) layout.lower_right = below_title;
    if (arrangement.maximized == ViewName::matrices)
        layout.matrices = rounded(area.min.x, area.min.y, area.max.x, area.max.y);
}

/// Places the camera view and, beside it, one of the lower views.
void place_side_by_side(Layout& layout, const Arrangement& arrangement, const Rect& area, float gap, float scale) {
    const float half_gap = gap * 0.5F, top = area.min.y + layout.header_height;
    const float split = area.min.x + 0.6F * area.width();
    layout.lower_fit = false;
    place_camera(layout, arrangement, rounded(area.min.x, top, split - half_gap, area.max.y), gap, scale);
    (arrangement.prefers_lower_right ? layout.lower_right : layout.lower_left) =
        rounded(split + half_gap, top, area.max.x, area.max.y);
}

/// Places the camera view above the lower views: both, or one if the window is narrow. The lower views shrink first.
void place_three_views(Layout& layout, const Arrangement& arrangement, const Rect& area, float gap, float scale) {
    const float least_lower = arrangement.least_lower * scale;
    const float lower = std::min(arrangement.lower_height * scale,
                                 area.height() * (1.0F - arrangement.least_camera) - layout.header_height);
    const float split_y = area.max.y - lower;
    place_camera(layout, arrangement,
                 rounded(area.min.x, area.min.y + layout.header_height, area.max.x,
                         split_y - layout.header_height - 6.0F * scale),
                 gap, scale);
    const float width_of_two = std::max(least_lower, arrangement.least_area * scale * scale / std::max(lower, 1.0F));
    layout.lower_fit = area.width() >= 2.0F * width_of_two + gap;
    if (!layout.lower_fit) {
        (arrangement.prefers_lower_right ? layout.lower_right : layout.lower_left) =
            rounded(area.min.x, split_y, area.max.x, area.max.y);
        return;
    }
    const float least = least_lower + gap * 0.5F;
    const float split_x =
        std::clamp(area.min.x + area.width() * arrangement.lower_split, area.min.x + least, area.max.x - least);
    layout.lower_left = rounded(area.min.x, split_y, split_x - gap * 0.5F, area.max.y);
    layout.lower_right = rounded(split_x + gap * 0.5F, split_y, area.max.x, area.max.y);
}

}  // namespace

float enlargement(ImVec2 window_px, float scale, const Arrangement& arrangement) {
    if (arrangement.presents && !arrangement.bare) return window_px.y / (30.0F * stage_type.caption) / scale;
    if (arrangement.maximized == ViewName::none || arrangement.bare || arrangement.in_lesson) return 1.0F;
    // Enlarge only as far as the bar above still fits.
    const float room = std::min(window_px.x / (1060.0F * scale), window_px.y / (600.0F * scale));
    return std::clamp(room, 1.0F, 1.5F);
}

TypeSizes type_sizes(const Arrangement& arrangement) {
    return arrangement.presents && !arrangement.bare ? stage_type : TypeSizes{};
}

Layout lay_out(ImVec2 window_px, float scale, const Arrangement& arrangement) {
    const auto px = [scale](float design) { return design * scale; };
    const bool bare = arrangement.bare && arrangement.maximized != ViewName::none;
    const bool has_bars = !bare && !arrangement.presents && !arrangement.embedded;
    const bool is_short = has_bars && window_px.y < px(420.0F);
    const bool has_status = has_bars && !(is_short && arrangement.strip_px > 0.0F);
    const float bar = has_bars ? px(40.0F) : 0.0F, status = has_status ? px(26.0F) : 0.0F;
    const float gap = bare ? 0.0F : px(10.0F), margin = bare ? 0.0F : px(4.0F);

    Layout layout;
    layout.is_short = is_short;
    layout.header_height = bare ? 0.0F : px(26.0F);
    layout.top_bar = rounded(0, 0, window_px.x, bar);
    layout.status_bar = rounded(0, window_px.y - status, window_px.x, window_px.y);
    // Keep space for the views: a taller strip is cut off at its lower edge.
    const float strip = std::min(bare ? 0.0F : arrangement.strip_px, 0.62F * window_px.y);
    if (strip > 0.0F) layout.strip = rounded(0, window_px.y - status - strip, window_px.x, window_px.y - status);
    const Rect between{{gap, bar + margin}, {window_px.x - gap, window_px.y - status - strip - margin}};
    if (arrangement.presents && !bare) {
        lay_out_stage(layout, between, scale, arrangement);
        return layout;
    }

    Rect area = cut_columns(layout, arrangement, between, gap, scale);
    const bool is_maximized = arrangement.maximized != ViewName::none;
    if (is_maximized && arrangement.telling.is_on()) area = cut_small_things(layout, arrangement, area, scale);
    if (is_maximized)
        place_one_view(layout, arrangement, area, gap, scale);
    else if (is_short)
        place_side_by_side(layout, arrangement, area, gap, scale);
    else
        place_three_views(layout, arrangement, area, gap, scale);
    return layout;
}

}  // namespace viewing
