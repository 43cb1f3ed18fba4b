// A list of polygons in columns: number, name, what the method goes by. Rows are linked with the pictures, both ways.
#pragma once

#include "ui/hidden/laboratory.h"
#include "ui/hidden/order_rows.h"

namespace viewing {

/// The start of a text that fits into so many pixels, with "…" where something was left out.
std::string shortened(std::string text, float width);

/// Open from its construction to its end; rows are drawn in between, those in view are enough.
class PolygonTable {
public:
    /// `detail` is the last column's title; an empty one leaves the column out. `count` is the largest number.
    PolygonTable(LaboratoryState& state, const HiddenResult& result, const char* id, const char* detail, int count,
                 ImVec2 size);
    ~PolygonTable();
    PolygonTable(const PolygonTable&) = delete;
    PolygonTable& operator=(const PolygonTable&) = delete;

    bool is_open() const { return is_open_; }  ///< otherwise nothing may be drawn
    static float row_height();

    /// Moves as little as it takes to show a row.
    void scroll_to(int place) const;
    void row(int number, const OrderRow& row);

private:
    void select(const OrderRow& row, const std::string& digits);

    LaboratoryState& state_;
    bool has_tree_, has_detail_;
    bool is_open_ = false;
};

}  // namespace viewing
