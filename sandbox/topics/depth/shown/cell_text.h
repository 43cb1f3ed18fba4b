// The numbers shown in the cells of a block of depths. They are short enough for a cell and, if possible, differ where
// the codes differ. Pure functions. See cell_view.cpp for usage.
#pragma once

#include <string>
#include <vector>

#include "frame/pixel_report.h"

namespace viewing {

struct CellTexts {
    std::vector<std::string> texts;  ///< one per cell
    std::string note;                ///< the meaning of the numbers: "stored code, 0 … 65,535"
};

/// Returns the numbers in the first form that fits: the codes themselves, if they are integers of at most 16 bits; the
/// window depth, with enough decimals to distinguish the codes; or the difference between each code and the smallest
/// written one. If none of these fits, rounds the window depth. Different codes may then look the same, and the note
/// says "rounded". `room`: the number of characters that fit in a cell, at least 4.
/// `cleared`: the window depth of unwritten cells.
CellTexts cell_texts(const CellBlock& block, const DepthPrecision& precision, double cleared, int room);

}  // namespace viewing
