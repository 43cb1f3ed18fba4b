// A picture in memory: read back from GL, written as PNG, and compared.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace viewing {

/// Eight bits per channel: red, green, blue, alpha; rows from the top, without gaps: rgba.size() = 4 · width · height.
struct Image {
    int width = 0;   ///< pixels
    int height = 0;  ///< pixels
    std::vector<std::uint8_t> rgba;

    std::size_t row_bytes() const { return static_cast<std::size_t>(width) * 4; }
    const std::uint8_t* row(int y) const { return rgba.data() + row_bytes() * static_cast<std::size_t>(y); }
    std::uint8_t* row(int y) { return rgba.data() + row_bytes() * static_cast<std::size_t>(y); }
    const std::uint8_t* pixel(int x, int y) const { return row(y) + 4 * static_cast<std::size_t>(x); }
    std::uint8_t* pixel(int x, int y) { return row(y) + 4 * static_cast<std::size_t>(x); }
    bool operator==(const Image&) const = default;
};

/// Returns a pixel's perceived brightness, 0 … 255: the Rec. 709 luma of its stored values.
inline double luma(const std::uint8_t* pixel) {
    return 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
}

/// Returns the pixels from (left, top) up to but not including (right, bottom), clamped to the image; the result has at
/// least one pixel. The image must not be empty.
inline Image cropped(const Image& image, int left, int top, int right, int bottom) {
    left = std::clamp(left, 0, image.width - 1);
    top = std::clamp(top, 0, image.height - 1);
    Image part{std::clamp(right, left + 1, image.width) - left, std::clamp(bottom, top + 1, image.height) - top, {}};
    part.rgba.reserve(part.row_bytes() * static_cast<std::size_t>(part.height));
    for (int y = top; y < top + part.height; ++y) {
        const std::uint8_t* first = image.pixel(left, y);
        part.rgba.insert(part.rgba.end(), first, first + part.row_bytes());
    }
    return part;
}

}  // namespace viewing
