// The drawing order as a list has it: one row for a place in the order, made when it is looked at. Read
// order_view.cpp for its use.
#pragma once

#include <imgui.h>

#include <string>

#include "ui/hidden/tree_index.h"

namespace viewing {

struct OrderRow {
    int fragment = -1;       ///< index into the result's fragments; −1 where the place is not in the order
    std::string name;        ///< "box, polygon 12"
    std::string brief_name;  ///< "box 12"
    std::string detail;      ///< what the method goes by: a distance, a node and its side, A or B
    ImU32 color = 0;         ///< the object's
    bool is_reached = true;  ///< by the step
    bool is_current = false;
};

/// Of a fragment that is a piece of this polygon: what it is called and its colour; the rest is left to be set.
OrderRow row_of_polygon(const HiddenResult& result, int fragment, int source);

/// The rows of one result, which outlives them. `index` follows the result where it has a tree.
class OrderRows {
public:
    OrderRows(const HiddenResult& result, const TreeIndex& index);

    int count() const { return static_cast<int>(result_.order.size()); }
    OrderRow row(int place) const;            ///< `place` counts from 0
    int current() const { return current_; }  ///< the place that the step is at; −1: none
    /// What `detail` is: a column's title, not yet looked up; empty where the method has none.
    const char* detail_title() const;

private:
    std::string detail_of(int fragment) const;

    const HiddenResult& result_;
    const TreeIndex& index_;
    const NewellStep* newell_step_ = nullptr;
    int current_ = -1;
    int reached_ = 0;  ///< places
};

/// Where a fragment is in the order; −1: nowhere.
int place_of(const HiddenResult& result, int fragment);

}  // namespace viewing
