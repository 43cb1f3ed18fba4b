// Pixels that a comparison leaves out: a clock, a frame rate, a part that is drawn at random.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace viewing {

/// A rectangle in pixels, (0, 0) at the top left; it may reach beyond the picture.
struct MaskRect {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const MaskRect&) const = default;
};

/// What a mask does not have is compared, so an empty one leaves nothing out.
class Mask {
public:
    Mask() = default;
    /// Of this size, with nothing left out yet. Sides 0 or more.
    Mask(int width, int height);
    /// White is left out: pixels whose luma (Rec. 709 on the stored values) and alpha are both 128 or more.
    explicit Mask(const Image& picture);

    /// Leaves out the part of the rectangle that the mask has; none of it when a side is 0 or less.
    void leave_out(const MaskRect& rect);
    /// Leaves out what the other one does. Sizes alike.
    void leave_out(const Mask& other);

    int width() const { return width_; }
    int height() const { return height_; }
    bool leaves_out(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_ && y < height_ &&
               left_out_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                         static_cast<std::size_t>(x)] != 0;
    }
    /// How many pixels are left out.
    std::int64_t pixels() const;

private:
    int width_ = 0, height_ = 0;
    std::vector<std::uint8_t> left_out_;  ///< 1 or 0, row by row from the top
};

}  // namespace viewing
