#include "topics/hidden/shown/order_rows.h"

#include <algorithm>

#include "topics/hidden/shown/method_words.h"
#include "topics/hidden/shown/polygon_names.h"
#include "topics/hidden/shown/step_text.h"
#include "widgets/widgets.h"

namespace viewing {

OrderRows::OrderRows(const HiddenResult& result, const TreeIndex& index) : result_(result), index_(index) {
    reached_ = count();
    if (result.step < 0) return;
    newell_step_ = newell_step(result);
    if (result.compare) {
        // Each step compares one pixel of a polygon; that polygon is the last one reached.
        current_ = place_of(result, result.compare->polygon);
        reached_ = current_ + 1;
    } else {
        reached_ = std::min(result.drawn, count());
        current_ = newell_step_ ? place_of(result, newell_step_->p) : reached_ - 1;
    }
}

OrderRow row_of_polygon(const HiddenResult& result, int fragment, int source) {
    OrderRow row;
    row.fragment = fragment;
    row.name = listed_name(result.surface.get(), source);
    row.brief_name = brief_name(result.surface.get(), source);
    row.color = polygon_color(result.surface.get(), source);
    return row;
}

OrderRow OrderRows::row(int place) const {
    if (!result_.fragments || place < 0 || place >= count()) return {};
    const int fragment = result_.order[place];
    if (fragment < 0 || fragment >= std::ssize(*result_.fragments)) return {};
    OrderRow row = row_of_polygon(result_, fragment, (*result_.fragments)[fragment].source);
    row.detail = detail_of(fragment);
    row.is_reached = place < reached_;
    row.is_current = place == current_;
    return row;
}

std::string OrderRows::detail_of(int fragment) const {
    if (result_.painter && fragment < std::ssize(result_.painter->distances))
        return number_text(result_.painter->distances[fragment], 3);
    if (newell_step_) return fragment == newell_step_->p ? "A" : fragment == newell_step_->q ? "B" : "";
    if (!result_.tree) return "";
    const int node = index_.node_of(fragment);
    if (node < 0) return "";
    const int side = index_.eye_side_of(node);
    const int number = node + 1;
    return side > 0   ? say("{node}, front", "node"_a = number)
           : side < 0 ? say("{node}, back", "node"_a = number)
                      : say("{node}, in plane", "node"_a = number);
}

const char* OrderRows::detail_title() const {
    if (result_.painter) return sort_key_names[result_.painter->key];
    if (newell_step_) return marked("pair");
    return result_.tree ? marked("node, eye side") : "";
}

int place_of(const HiddenResult& result, int fragment) {
    const auto found = std::find(result.order.begin(), result.order.end(), fragment);
    return found == result.order.end() ? -1 : static_cast<int>(found - result.order.begin());
}

}  // namespace viewing
