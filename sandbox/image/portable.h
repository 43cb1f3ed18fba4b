// The portable rule: accepts the changes that another driver or a different number of samples may cause in a picture,
// and nothing else. Read CompareProfile in compare.h first.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

namespace viewing {

/// Whether a pixel that differs by more than `worst` in a channel is on an edge drawn with different samples. This is
/// the case if
/// - both pictures have an edge at the pixel: in the 3 x 3 pixels around it, some channel varies by more than `worst`,
/// - in each channel, the pixel's value in either picture is between its neighbors' values in the other picture, or
///   outside them by at most half of the edge's step (a line thinner than a pixel fades), and
/// - the edge has not moved by a pixel.
/// (x, y) must be inside both pictures. The idea that an anti-aliased pixel is between its neighbors is from V.
/// Vysniauskas, "Anti-aliased Pixel and Intensity Slope Detector", 2009; the test of how far the edge has moved is our
/// own.
bool is_resampled_edge(const Image& a, const Image& b, int x, int y, int worst);

/// The largest mean shift of A relative to B in any square of 16 x 16 pixels, for red, green, blue and alpha
/// separately. Add rows one by one from the top. A picture smaller than the square counts as one square.
class LocalShift {
public:
    LocalShift(int width, int height);

    /// Adds row `y` of A − B, in levels, four channels per pixel.
    void add_row(int y, std::span<const std::int16_t> difference);

    /// Returns the shift with its sign, in levels.
    const std::array<double, 4>& largest() const { return largest_; }

private:
    int width_, side_x_, side_y_;
    std::vector<std::int16_t> rows_;     ///< the last side_y_ rows, as a ring buffer
    std::vector<std::int32_t> columns_;  ///< sum of each column over these rows
    std::array<double, 4> largest_{};
};

}  // namespace viewing
