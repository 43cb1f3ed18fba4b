// Pixels that a comparison leaves out, such as a clock, a frame rate, or an area that is drawn at random.
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

/// The pixels to leave out. Pixels outside the mask's area are compared, so an empty mask leaves nothing out.
class Mask {
public:
    Mask() = default;
    /// Makes a mask of this size that leaves nothing out yet. Both sides must be 0 or more.
    Mask(int width, int height);
    /// Leaves out the white pixels of a picture: those whose luma (Rec. 709 on the stored values) and alpha are both
    /// 128 or more.
    explicit Mask(const Image& picture);

    /// Leaves out the part of the rectangle that is inside the mask; does nothing if a side is 0 or less.
    void leave_out(const MaskRect& rect);
    /// Also leaves out the pixels that the other mask leaves out. Both must have the same size.
    void leave_out(const Mask& other);

    int width() const { return width_; }
    int height() const { return height_; }
    bool leaves_out(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_ && y < height_ &&
               left_out_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                         static_cast<std::size_t>(x)] != 0;
    }
    /// Returns the number of pixels left out.
    std::int64_t pixels() const;

private:
    int width_ = 0, height_ = 0;
    std::vector<std::uint8_t> left_out_;  ///< 1 for pixels left out, else 0; row by row from the top
};

}  // namespace viewing
