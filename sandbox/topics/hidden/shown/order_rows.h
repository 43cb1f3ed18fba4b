// The drawing order as rows of a list, one for each place in the order, created on demand. See order_view.cpp for
// usage.
#pragma once

#include <imgui.h>

#include <string>

#include "topics/hidden/shown/tree_index.h"

namespace viewing {

struct OrderRow {
    int fragment = -1;       ///< index into the result's fragments; −1 if the place is not in the order
    std::string name;        ///< "box, polygon 12"
    std::string brief_name;  ///< "box 12"
    std::string detail;      ///< a distance (painter), A or B (Newell), or a node and the eye's side (BSP tree)
    ImU32 color = 0;         ///< the object's color
    bool is_reached = true;  ///< whether the step has reached this place
    bool is_current = false;
};

/// Returns a row with the polygon's names and color; the caller sets the rest.
OrderRow row_of_polygon(const HiddenResult& result, int fragment, int source);

/// The rows of one result, which must outlive this object. If the result has a tree, `index` must be up to date with
/// that result.
class OrderRows {
public:
    OrderRows(const HiddenResult& result, const TreeIndex& index);

    int count() const { return static_cast<int>(result_.order.size()); }
    OrderRow row(int place) const;            ///< `place` is counted from 0
    int current() const { return current_; }  ///< the step's place; −1 if it has none
    /// The column title of `detail`, untranslated; empty if the method has none.
    const char* detail_title() const;

private:
    std::string detail_of(int fragment) const;

    const HiddenResult& result_;
    const TreeIndex& index_;
    const NewellStep* newell_step_ = nullptr;
    int current_ = -1;
    int reached_ = 0;  ///< number of places that the step has reached
};

/// Returns a fragment's place in the order, or −1 if it has none.
int place_of(const HiddenResult& result, int fragment);

}  // namespace viewing
