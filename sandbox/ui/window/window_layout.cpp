#include "ui/window/window_layout.h"

#include <algorithm>
#include <array>

#include "state/fields.h"

namespace viewing {
namespace {

/// Approximate number of rows that a field's control takes in the panel.
int rows_of(const Field& field) {
    const bool has_buttons = field.path == "plane.equation" || field.path == "light.position";
    const bool is_step = field.path == "view.call" || field.path == "view.triangle";  // the stepping view has it
    const bool has_control = type_name(field) != "lights" && type_name(field) != "planes" && !is_step;
    return has_buttons ? 2 : has_control ? 1 : 0;
}

int rows_of(const std::vector<std::string>& controls) {
    int rows = 0;
    for (const Field& field : fields())
        for (const std::string& path : controls)
            if (is_in(field.path, path)) {
                rows += rows_of(field);
                if (field.path == "camera.navigation") rows += 2;  // for the lamps
                break;
            }
    return rows;
}

}  // namespace

bool is_folded(const Params& params, std::string_view column) {
    const std::vector<std::string>& folded = params.view.layout.folded;
    return std::find(folded.begin(), folded.end(), column) != folded.end();
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

BigView big_view(ViewName hovered) {
    switch (hovered) {
        case ViewName::lower_left:
            return BigView::lower_left;
        case ViewName::lower_right:
            return BigView::lower_right;
        case ViewName::matrices:
            return BigView::matrices;
        default:
            return BigView::camera;
    }
}

void arrange(Arrangement& arrangement, const Params& params) {
    static constexpr std::array views = {ViewName::none, ViewName::camera, ViewName::lower_left, ViewName::lower_right,
                                         ViewName::matrices};
    const LayoutParams& layout = params.view.layout;
    arrangement.maximized = views[static_cast<std::size_t>(layout.big)];
    Telling& telling = arrangement.telling;
    telling.matrices = !layout.matrices.empty();
    telling.control_rows = rows_of(layout.controls);
    telling.has_vectors = std::any_of(layout.controls.begin(), layout.controls.end(), [](const std::string& path) {
        return path == "camera" || path == "camera.position" || path == "light.position" || path == "plane.equation";
    });
    const bool would_be_empty = !layout.controls.empty() && telling.control_rows == 0;
    arrangement.panel_folded = is_folded(params, "panel") || would_be_empty;
    arrangement.matrices_folded = is_folded(params, "matrices");
}

Rect wide_lower_area(const Layout& layout) {
    const float bottom = layout.strip.empty() ? layout.status_bar.min.y : layout.strip.min.y;
    return {{layout.top_bar.min.x, layout.panel.max.y}, {layout.top_bar.max.x, bottom}};
}

Rect views_area(const Layout& layout, const Arrangement& arrangement) {
    if (layout.lower_are_wide)
        return {{layout.panel.max.x, layout.top_bar.max.y}, {layout.top_bar.max.x, layout.panel.max.y}};
    const float bottom = layout.strip.empty() ? layout.status_bar.min.y : layout.strip.min.y;
    if (!arrangement.telling.is_on() || arrangement.maximized == ViewName::none)
        return {{layout.panel.max.x, layout.top_bar.max.y},
                {layout.matrices.empty() ? layout.top_bar.max.x : layout.matrices.min.x, bottom}};
    Rect area{{layout.top_bar.max.x, layout.status_bar.min.y}, {0.0F, 0.0F}};
    for (const Rect& view : {layout.camera, layout.beside, layout.caption, layout.lower_left, layout.lower_right}) {
        if (view.empty()) continue;
        area.min = {std::min(area.min.x, view.min.x), std::min(area.min.y, view.min.y - layout.header_height)};
        area.max = {std::max(area.max.x, view.max.x), std::max(area.max.y, view.max.y)};
    }
    return area.empty() ? Rect{layout.status_bar.min, layout.status_bar.min} : area;
}

}  // namespace viewing
