// Finds connected blocks of pixels, with eight neighbors per pixel.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace viewing {

/// Joins runs of pixels into blocks, row by row from the top. A row that is not added counts as a row without runs.
class BlockFinder {
public:
    /// Adds the differences in row `y`, which must be below the last row added. A pixel whose difference exceeds
    /// `worst` belongs to a block.
    void add_row(int y, std::span<const std::uint8_t> difference, int worst);

    std::int64_t blocks() const;
    std::int64_t largest() const;  ///< number of pixels in the largest block; 0 if there is none

private:
    struct Run {
        int begin, end;  ///< `end` is one past the last pixel
        std::size_t block;
    };

    std::size_t root_of(std::size_t block);

    std::vector<std::size_t> parents_;
    std::vector<std::int64_t> pixels_;  ///< pixels in each block; valid only for a block that is its own parent
    std::vector<Run> above_;            ///< runs in row y_
    int y_ = -2;
};

}  // namespace viewing
