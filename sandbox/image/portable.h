// The portable rule: what another driver or another number of samples may change in a picture, and nothing else. Read
// CompareProfile in compare.h first.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

namespace viewing {

/// Whether a pixel that differs by more than `worst` in a channel is an edge seen with other samples. It is when
/// - both pictures have an edge there (some channel's range in the 3 x 3 pixels around is more than `worst`),
/// - in each channel it has a value that lies between its neighbours in the other picture, in both directions, or
///   beyond them by no more than half of what the edge's step is (a line thinner than a pixel fades), and
/// - the edge has not moved by a pixel.
/// (x, y) lies in both pictures. After the idea of V. Vysniauskas, "Anti-aliased Pixel and Intensity Slope Detector",
/// 2009, that an anti-aliased pixel lies between its neighbours; how far the edge moved is this program's own.
bool is_resampled_edge(const Image& a, const Image& b, int x, int y, int worst);

/// The largest mean shift of A against B in any square of 16 x 16 pixels, for red, green, blue and alpha by itself.
/// Rows come from the top, one by one; a picture that is smaller than the square is one square.
class LocalShift {
public:
    LocalShift(int width, int height);

    /// Row `y` of A minus B, in levels, four channels a pixel.
    void add_row(int y, std::span<const std::int16_t> difference);

    /// With its sign, levels.
    const std::array<double, 4>& largest() const { return largest_; }

private:
    int width_, side_x_, side_y_;
    std::vector<std::int16_t> rows_;     ///< the last side_y_ of them, as a ring
    std::vector<std::int32_t> columns_;  ///< their sum
    std::array<double, 4> largest_{};
};

}  // namespace viewing
