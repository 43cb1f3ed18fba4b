// The differences between two pictures, one row at a time: the basis of counts, marks and boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/compare.h"

namespace viewing {

/// Computes the largest channel difference of each pixel, one row at a time, in the area that both pictures have; 0 for
/// pixels that the mask leaves out. Searches the neighborhood of a pixel for a match that excuses it, but only if the
/// pixel is beyond the threshold. The pictures and the mask must outlive this object.
class Differences {
public:
    Differences(const Image& a, const Image& b, const CompareOptions& options, const Mask& mask);

    /// Whether a row has the same bytes in both pictures: a fast test before row().
    bool are_none(int y) const;

    /// Returns the differences in row `y` in levels, at most `worst` for excused pixels; valid until the next call.
    std::span<const std::uint8_t> row(int y);

    /// Returns the row that row() computed last, but with the true differences on resampled edges.
    std::span<const std::uint8_t> as_found() const { return found_; }

private:
    bool has_like(const Image& from, int x, int y, const Image& other) const;

    const Image &a_, &b_;
    const Mask& mask_;
    const CompareOptions options_;

public:
    const int width, height;  ///< of the area that both pictures have

private:
    std::vector<std::uint8_t> channels_;
    std::vector<std::uint8_t> pixels_;
    std::vector<std::uint8_t> found_;
};

}  // namespace viewing
