#include "ui/window/window_layout.h"

#include <algorithm>
#include <array>

#include "state/fields.h"
#include "topics/matrices/shown/display_code_view.h"
#include "topics/matrices/shown/followed_point.h"
#include "ui/views/lower_view.h"

namespace viewing {
namespace {

/// Approximate number of rows that a field's control takes in the panel.
int rows_of(const Field& field) {
    if (!field.has_control) return 0;
    const bool has_buttons = field.path == "plane.equation" || field.path == "light.position";
    const bool has_long_name = field.path == "shadow.lift";  // in Korean, the name is above the number
    return field.path == "visibility.step" ? 3 : has_buttons || has_long_name ? 2 : 1;
}

int rows_of(const std::vector<std::string>& controls) {
    int rows = 0;
    for (const Field& field : fields())
        for (const std::string& path : controls)
            if (is_in(field.path, path)) {
                rows += rows_of(field);
                if (field.path == "camera.navigation") rows += rows_of_lamps;
                break;
            }
    return rows;
}

/// The rectangle around pictures with their headers; empty if all pictures are empty.
Rect around(std::initializer_list<Rect> pictures, float header_height) {
    Rect area;
    for (const Rect& picture : pictures) {
        if (picture.empty()) continue;
        const Rect whole{{picture.min.x, picture.min.y - header_height}, picture.max};
        area = area.empty() ? whole
                            : Rect{{std::min(area.min.x, whole.min.x), std::min(area.min.y, whole.min.y)},
                                   {std::max(area.max.x, whole.max.x), std::max(area.max.y, whole.max.y)}};
    }
    return area;
}

constexpr float with_numbers = 147.0F, with_symbols = 230.0F;  ///< heights of a matrix

/// Returns the height of the listed matrices, the followed point and display(), in design pixels.
float height_of(const std::vector<std::string>& matrices, const Params& params, float of_matrix) {
    constexpr float heading = 40.0F, line = 20.0F, pair = 30.0F;
    const bool has_pair =
        (is_named(matrices, "S") || is_named(matrices, "R")) && (params.planes.size() > 1 || params.lights.size() > 1);
    float height = 4.0F + (has_pair ? pair : 0.0F);
    for (const std::string& name : matrices) {
        if (name == "follow") {
            const int lines = lines_of(point_numbers(matrices, params.shadow.enabled, params.reflection.enabled));
            height += heading + line * static_cast<float>(lines);
        } else {
            height += is_matrix(name) ? of_matrix : display_code_height;
        }
    }
    return height;
}

/// Returns the height that a preset's caption and the matrices leave for the lower views on stage, in design pixels.
/// The stage always has the same height, because everything on it grows with the window.
float room_for_views(float matrices) {
    constexpr float caption = 68.0F;  // two lines
    return 30.0F * stage_type.caption - caption - matrices;
}

constexpr float header_and_gap = 36.0F;  // of a lower view on stage

/// Returns the height that both lower views need on stage: `first` is legible, the other one at its lowest.
float height_of_both(const Params& params, Slot first) {
    return lower_view(params, first).least_size.y + lower_view(params, other_than(first)).lowest +
           2.0F * header_and_gap;
}

}  // namespace

bool is_folded(const Params& params, std::string_view column) {
    return is_named(params.view.layout.folded, column);
}

void fold(Params& params, std::string_view column, bool folded) {
    std::vector<std::string>& all = params.view.layout.folded;
    if (folded == is_folded(params, column)) return;
    if (folded)
        all.emplace_back(column);
    else
        all.erase(std::find(all.begin(), all.end(), column));
    std::sort(all.rbegin(), all.rend());  // in the state file's order: panel, matrices
}

void arrange(Arrangement& arrangement, const Params& params, const std::vector<std::string>& matrices) {
    const LayoutParams& layout = params.view.layout;
    arrangement.maximized = layout.big;
    Telling& telling = arrangement.telling;
    telling.matrices = static_cast<int>(matrices.size());
    const bool has_matrix = std::any_of(matrices.begin(), matrices.end(), is_matrix);
    telling.short_matrices = height_of(matrices, params, with_numbers);
    telling.tall_matrices = height_of(matrices, params, with_symbols);
    telling.first_symbols = has_matrix ? with_symbols - with_numbers : 0.0F;
    telling.control_rows = rows_of(layout.controls);
    telling.has_vectors = std::any_of(layout.controls.begin(), layout.controls.end(), [](const std::string& path) {
        return path == "camera" || path == "camera.position" || path == "light.position" || path == "plane.equation";
    });
    const bool would_be_empty = !layout.controls.empty() && telling.control_rows == 0;
    arrangement.panel_folded = is_folded(params, "panel") || would_be_empty;
    arrangement.matrices_folded = is_folded(params, "matrices");
    const LowerView &left = lower_view(params, Slot::left), &right = lower_view(params, Slot::right);
    StageViews& stage = arrangement.stage;
    stage.least_left = left.least_size;
    stage.least_right = right.least_size;
    stage.lowest_left = left.lowest;
    stage.lowest_right = right.lowest;
}

std::vector<std::string> matrices_on_stage(const Params& params, const NamedFile* preset, Slot first) {
    std::vector<std::string> matrices = matrices_about(params, preset);
    while (!matrices.empty()) {
        const bool is_for_both = names_both_topics(params) && matrices.size() > 1;
        const float wanted =
            is_for_both ? height_of_both(params, first) : lower_view(params, first).least_size.y + header_and_gap;
        if (wanted <= room_for_views(height_of(matrices, params, with_numbers))) break;
        matrices.pop_back();
    }
    return matrices;
}

std::vector<std::string> matrices_about(const Params& params, const NamedFile* preset) {
    const std::string group = preset ? preset->group : "";
    const bool is_of_depth = group == "Depth buffer" || group == "Depth fighting";
    if (is_of_depth) return {"P"};
    if (group == "Hidden surfaces") return {};
    if (group == "Camera") return {"V", "P"};
    const bool needs_both = is_any_shown(params, &LowerView::wants_matrices);
    std::vector<std::string> matrices;
    if (params.shadow.enabled && (needs_both || group != "Mirror")) matrices.emplace_back("S");
    if (params.reflection.enabled && (needs_both || group != "Shadow")) matrices.emplace_back("R");
    return matrices.empty() ? std::vector<std::string>{"V", "P"} : matrices;
}

void open_lower_views(Arrangement& arrangement, const Params& params, Slot first) {
    StageViews& views = arrangement.stage;
    // Do not let a view make the column wider than a matrix does, so that the main view keeps its share of a narrow
    // stage.
    for (ImVec2* least : {&views.least_left, &views.least_right}) least->x = std::min(least->x, 430.0F);
    const float room = room_for_views(arrangement.matrices_folded ? 0.0F : arrangement.telling.short_matrices);
    const bool fit_both = height_of_both(params, first) <= room;
    const bool fits_first = lower_view(params, first).lowest + header_and_gap <= room;
    views.left = fit_both || (first == Slot::left && fits_first);
    views.right = fit_both || (first == Slot::right && fits_first);
}

Rect lower_views_area(const Layout& layout) {
    return around({layout.lower_left, layout.lower_right}, layout.header_height);
}

Rect views_area(const Layout& layout, const Arrangement& arrangement) {
    const float bottom = layout.strip.empty() ? layout.status_bar.min.y : layout.strip.min.y;
    const bool are_around_pictures =
        arrangement.presents || (arrangement.telling.is_on() && arrangement.maximized != ViewName::none);
    if (!are_around_pictures)
        return {{layout.panel.max.x, layout.top_bar.max.y},
                {layout.matrices.empty() ? layout.top_bar.max.x : layout.matrices.min.x, bottom}};
    const Rect none;
    const Rect area =
        around({layout.camera, layout.beside, arrangement.presents ? none : layout.caption,
                layout.lower_in_column ? none : layout.lower_left, layout.lower_in_column ? none : layout.lower_right},
               layout.header_height);
    return area.empty() ? Rect{layout.status_bar.min, layout.status_bar.min} : area;
}

}  // namespace viewing
