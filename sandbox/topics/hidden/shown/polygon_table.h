// A table of polygons: number, name, and the method's criterion. A row and its polygon in the pictures highlight each
// other.
#pragma once

#include "topics/hidden/shown/order_rows.h"
#include "topics/hidden/shown/polygon_links.h"

namespace viewing {

/// A table that is open from construction to destruction. Draw its rows in between; it is enough to draw the visible
/// ones.
class PolygonTable {
public:
    /// `detail`: the untranslated title of the last column; if empty, the column is omitted. `count`: the largest row
    /// number.
    PolygonTable(PolygonLinks& links, const HiddenResult& result, const char* id, const char* detail, int count,
                 ImVec2 size);
    ~PolygonTable();
    PolygonTable(const PolygonTable&) = delete;
    PolygonTable& operator=(const PolygonTable&) = delete;

    bool is_open() const { return is_open_; }  ///< if false, draw no rows
    float row_height() const;

    /// Scrolls to a row if it is out of view.
    void scroll_to(int place) const;
    /// Draws a row. Returns whether a click selected or deselected its polygon.
    bool row(int number, const OrderRow& row);

private:
    bool select(const OrderRow& row, const std::string& digits);

    PolygonLinks& links_;
    bool has_tree_, has_detail_;
    bool is_open_ = false;
    float padding_px_ = 0.0F;  ///< above and below a row
};

}  // namespace viewing
