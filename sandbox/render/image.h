// A picture in memory: what a readback gives, what is written as PNG and compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace viewing {

/// Eight bits a channel, red green blue alpha, rows from the top without gaps: rgba.size() = 4 · width · height.
struct Image {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    std::vector<std::uint8_t> rgba;

    std::size_t row_bytes() const { return static_cast<std::size_t>(width) * 4; }
    const std::uint8_t* row(int y) const { return rgba.data() + row_bytes() * static_cast<std::size_t>(y); }
    std::uint8_t* row(int y) { return rgba.data() + row_bytes() * static_cast<std::size_t>(y); }
    bool operator==(const Image&) const = default;
};

}  // namespace viewing
