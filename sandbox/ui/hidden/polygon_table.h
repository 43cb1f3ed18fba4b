// A list of polygons in columns: number, name, what the method goes by. Rows are linked with the pictures, both ways.
#pragma once

#include "ui/hidden/order_rows.h"
#include "ui/hidden/polygon_links.h"

namespace viewing {

/// Open from its construction to its end; rows are drawn in between, those in view are enough.
class PolygonTable {
public:
    /// `detail` is the last column's title, not yet looked up; an empty one leaves the column out. `count` is the
    /// largest number.
    PolygonTable(PolygonLinks& links, const HiddenResult& result, const char* id, const char* detail, int count,
                 ImVec2 size);
    ~PolygonTable();
    PolygonTable(const PolygonTable&) = delete;
    PolygonTable& operator=(const PolygonTable&) = delete;

    bool is_open() const { return is_open_; }  ///< otherwise nothing may be drawn
    static float row_height();

    /// Moves as little as it takes to show a row.
    void scroll_to(int place) const;
    /// True when its polygon was selected by a click, or let go.
    bool row(int number, const OrderRow& row);

private:
    bool select(const OrderRow& row, const std::string& digits);

    PolygonLinks& links_;
    bool has_tree_, has_detail_;
    bool is_open_ = false;
};

}  // namespace viewing
