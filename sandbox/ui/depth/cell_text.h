// The number in each cell of a block of depths: as short as cells are, and different where the codes are. Pure. Read
// cell_view.cpp for its use.
#pragma once

#include <string>
#include <vector>

#include "frame/pixel_report.h"

namespace viewing {

struct CellTexts {
    std::vector<std::string> texts;  ///< of each cell
    std::string note;                ///< what the numbers are: "stored code, 0 … 65,535"
};

/// `room`: how many characters a cell has, at least 4. A cell that holds the window depth `cleared` is unwritten.
/// Up to 16 bits the codes themselves where there is room for the greatest; else the window depth with as many decimals
/// as tell the codes apart where there is room for them; else how many codes a cell lies above the least one; else, in
/// a block with so wide a range, the window depth as far as there is room, which may be the same for different codes:
/// the note says so.
CellTexts cell_texts(const CellBlock& block, const DepthPrecision& precision, double cleared, int room);

}  // namespace viewing
