// How far two pictures are apart, a row at a time: what counting, marking and boxes start from.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/compare.h"

namespace viewing {

/// The largest channel difference of each pixel, a row of the part that both pictures have at a time; 0 where the mask
/// leaves a pixel out. Only pixels beyond the threshold look around for what excuses them. Pictures and mask have to
/// live as long as this.
class Differences {
public:
    Differences(const Image& a, const Image& b, const CompareOptions& options, const Mask& mask);

    /// Whether a row is the same bytes in both: the cheap question before row().
    bool are_none(int y) const;

    /// Levels of row `y`, `worst` at most where a pixel is excused; valid until the next call.
    std::span<const std::uint8_t> row(int y);

    /// The same row as it is, resampled edges with what they really differ by.
    std::span<const std::uint8_t> as_found() const { return found_; }

private:
    bool has_like(const Image& from, int x, int y, const Image& other) const;

    const Image &a_, &b_;
    const Mask& mask_;
    const CompareOptions options_;

public:
    const int width, height;  ///< of the part that both have

private:
    std::vector<std::uint8_t> channels_;
    std::vector<std::uint8_t> pixels_;
    std::vector<std::uint8_t> found_;
};

}  // namespace viewing
