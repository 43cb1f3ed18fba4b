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
    constexpr float with_numbers = 147.0F, with_symbols = 230.0F, heading = 40.0F, line = 20.0F, pair = 30.0F;
    const int lines = lines_of(point_numbers(matrices, params.shadow.enabled, params.reflection.enabled));
    const float follow = heading + line * static_cast<float>(lines);
    const bool has_pair =
        (is_named(matrices, "S") || is_named(matrices, "R")) && (params.planes.size() > 1 || params.lights.size() > 1);
    telling.short_matrices = telling.tall_matrices = 4.0F + (has_pair ? pair : 0.0F);
    telling.first_symbols = 0.0F;
    for (const std::string& name : matrices) {
        telling.short_matrices += is_matrix(name) ? with_numbers : name == "follow" ? follow : display_code_height;
        telling.tall_matrices += is_matrix(name) ? with_symbols : name == "follow" ? follow : display_code_height;
        if (is_matrix(name)) telling.first_symbols = with_symbols - with_numbers;
    }
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

std::vector<std::string> matrices_about(const Params& params, const NamedFile* preset) {
    const std::string group = preset ? preset->group : "";
    const bool is_of_depth = group == "Depth buffer" || group == "Depth fighting";
    if (is_of_depth) return {"P"};
    if (group == "Hidden surfaces") return {};
    if (group == "Camera") return {"V", "P"};
    std::vector<std::string> matrices;
    if (params.shadow.enabled && group != "Mirror") matrices.emplace_back("S");
    if (params.reflection.enabled && group != "Shadow") matrices.emplace_back("R");
    return matrices.empty() ? std::vector<std::string>{"V", "P"} : matrices;
}

void open_lower_views(Arrangement& arrangement, Slot first) {
    // The stage always has this height in design pixels, because everything on it grows with the window.
    constexpr float height = 30.0F * stage_type.caption, least_view = 170.0F;
    const float room = height - (arrangement.matrices_folded ? 0.0F : arrangement.telling.short_matrices);
    // Do not let a view make the column wider than a matrix does, so that the main view keeps its share of a narrow
    // stage.
    for (ImVec2* least : {&arrangement.stage.least_left, &arrangement.stage.least_right})
        least->x = std::min(least->x, 430.0F);
    const int fitting = std::clamp(static_cast<int>(room / least_view), 0, 2);
    arrangement.stage.left = fitting == 2 || (fitting == 1 && first == Slot::left);
    arrangement.stage.right = fitting == 2 || (fitting == 1 && first == Slot::right);
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
