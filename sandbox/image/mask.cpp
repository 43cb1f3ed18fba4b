#include "image/mask.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace viewing {

Mask::Mask(int width, int height)
    : width_(width),
      height_(height),
      left_out_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), std::uint8_t{0}) {}

Mask::Mask(const Image& picture) : Mask(picture.width, picture.height) {
    for (std::size_t i = 0; i < left_out_.size(); ++i) {
        const std::uint8_t* pixel = picture.rgba.data() + 4 * i;
        left_out_[i] = luma(pixel) >= 128.0 && pixel[3] >= 128 ? 1 : 0;
    }
}

void Mask::leave_out(const MaskRect& rect) {
    // Add in 64 bits: a rectangle may have any four numbers, so the sum could overflow an int.
    const auto end = [](int begin, int length, int side) {
        return static_cast<int>(std::clamp<std::int64_t>(std::int64_t{begin} + length, 0, side));
    };
    const int left = std::clamp(rect.x, 0, width_), right = end(rect.x, rect.width, width_);
    const int top = std::clamp(rect.y, 0, height_), bottom = end(rect.y, rect.height, height_);
    if (right <= left) return;
    for (int y = top; y < bottom; ++y) {
        const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y) * width_;
        std::fill(left_out_.begin() + row + left, left_out_.begin() + row + right, std::uint8_t{1});
    }
}

void Mask::leave_out(const Mask& other) {
    assert(other.width_ == width_ && other.height_ == height_);
    for (std::size_t i = 0; i < left_out_.size(); ++i) left_out_[i] |= other.left_out_[i];
}

std::int64_t Mask::pixels() const {
    return std::count(left_out_.begin(), left_out_.end(), std::uint8_t{1});
}

}  // namespace viewing
