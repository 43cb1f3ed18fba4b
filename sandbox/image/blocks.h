// Connected blocks of pixels: what belongs together when eight neighbours count.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace viewing {

/// Joins runs of pixels row by row, from the top; a row that is not told has none.
class BlockFinder {
public:
    /// Levels of row `y`, greater than that of the call before; those above `worst` belong to a block.
    void add_row(int y, std::span<const std::uint8_t> difference, int worst);

    std::int64_t blocks() const;
    std::int64_t largest() const;  ///< pixels of the largest block; 0 where there is none

private:
    struct Run {
        int begin, end;  ///< the pixel behind the last one
        std::size_t block;
    };

    std::size_t root_of(std::size_t block);

    std::vector<std::size_t> parents_;
    std::vector<std::int64_t> pixels_;  ///< of a block that is its own parent
    std::vector<Run> above_;            ///< of row y_
    int y_ = -2;
};

}  // namespace viewing
