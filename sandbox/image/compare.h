// Compares two pictures with two thresholds: how far a channel may be off, and what fraction of the pixels may be off
// by more. The first alone would fail on one stray edge pixel; the second alone would let a small error pass. Pictures
// from another driver are compared with a separate profile.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/mask.h"

namespace viewing {

/// strict is for pictures from the same machine and driver. portable accepts edges that another driver or a different
/// number of samples has changed (is_resampled_edge in portable.h), and detects a shift by one level, which strict
/// cannot detect.
enum class CompareProfile { strict, portable };
inline constexpr std::array profile_names{"strict", "portable"};

/// strict: pictures are equal if they have the same size, and at most `share` of the compared pixels have a channel
/// (red, green, blue or alpha) that differs by more than `worst`. portable: resampled edges do not count among these
/// pixels; in addition, no connected block of them may have more than `block_px` pixels, and the mean of any square of
/// 16 x 16 pixels may shift by at most `shift`.
struct CompareOptions {
    /// How far a channel may be off, in levels from 0 to 255. The default is 2, because the renderer rounds differently
    /// on different processors. One level is invisible; a wrong light or normal changes a channel by tens of levels.
    int worst = 2;
    /// From 0 to 1; with 0, no pixel may differ by more than `worst`.
    double share = 0.0;
    /// A pixel does not count as beyond `worst` if each picture has a match for the other's pixel at most this many
    /// pixels away in x and y. With 1, edges that moved by a pixel do not count.
    int reach_px = 0;
    CompareProfile profile = CompareProfile::strict;
    /// Only for portable. The default is 4, because a different number of samples changes single pixels at corners and
    /// on faces thinner than a pixel, and even blocks of four pixels if there are 16 samples instead of 4. An edge that
    /// has moved in five rows changes five pixels.
    std::int64_t block_px = 4;
    /// Only for portable, in levels. The default is 0.6: noise of two levels up or down shifts the mean of 256 pixels
    /// by at most 0.48 in a picture of 640 x 360 (seven standard deviations are 0.62), while a shadow that is one level
    /// brighter or darker shifts it by 0.75.
    double shift = 0.6;
};

/// The thresholds of the portable profile. worst is 3: two levels of noise and one of rounding. share is 0.002: a
/// different number of samples changes at most 0.0006 of the pixels, in a picture full of lines; a larger fraction
/// cannot come from rounding, even if the pixels are far apart.
constexpr CompareOptions portable_options{.worst = 3, .share = 0.002, .profile = CompareProfile::portable};

/// Returns the thresholds of a profile.
constexpr CompareOptions options_of(CompareProfile profile) {
    return profile == CompareProfile::portable ? portable_options : CompareOptions{};
}

/// A rectangle in the picture; pixel (0, 0) is at the top left.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
    std::int64_t pixels = 0;  ///< number of pixels inside it that are beyond the threshold
    bool operator==(const PixelBox&) const = default;
};

struct CompareReport {
    bool equal = false;
    bool sizes_differ = false;      ///< if so, equal is false; only the common area from the top left is compared
    std::array<int, 2> size_a{};    ///< width, height
    std::array<int, 2> size_b{};    ///< width, height
    std::int64_t pixels = 0;        ///< the larger width times the larger height
    std::int64_t left_out = 0;      ///< number of pixels that the mask leaves out
    std::int64_t different = 0;     ///< pixels with any channel different, or that only one picture has
    std::int64_t beyond = 0;        ///< pixels off by more than options.worst, or that only one picture has
    std::int64_t resampled = 0;     ///< portable: pixels off by more than worst that count as resampled edges
    double mean = 0.0;              ///< mean absolute difference over all channels, in levels
    std::array<double, 4> shift{};  ///< mean of A − B for red, green, blue, alpha, in levels
    std::array<double, 4>
        local_shift{};                ///< portable: the largest such mean in a 16 x 16 square, over pixels within worst
    std::int64_t blocks = 0;          ///< blocks of pixels beyond the threshold, connected across eight neighbors
    std::int64_t largest_block = 0;   ///< number of pixels in the largest block
    int worst_found = 0;              ///< the largest difference in a channel, in levels
    std::array<int, 2> worst_at{};    ///< x, y of the first pixel that differs by worst_found; 0, 0 if none differs
    std::vector<PixelBox> boxes;      ///< around the pixels beyond the threshold, most pixels first; at most 16
    std::int64_t boxes_left_out = 0;  ///< number of further boxes
    CompareOptions options;

    double beyond_share() const;  ///< beyond / (pixels − left_out); 0 if nothing is compared
};

/// Returns the largest channel difference of each pixel in the area that both pictures have, in levels, row by row from
/// the top; at most `worst` if a match is within reach or the pixel is on a resampled edge.
std::vector<std::uint8_t> pixel_differences(const Image& a, const Image& b, const CompareOptions& options);

/// Compares two pictures. In the options, worst must be 0 … 255, share 0 … 1, and reach_px 0 or more. Boxes that are at
/// most 16 pixels apart (or 1/80 of the larger side, if that is more) are merged. In the area that both pictures have,
/// pixels that the mask leaves out count as equal. A mask of another size covers only its own area, from the top left.
CompareReport compare_images(const Image& a, const Image& b, const CompareOptions& options = {}, const Mask& mask = {});

/// Returns one line of text for people to read, starting with "equal" or "different".
std::string sentence(const CompareReport& report);

/// Returns the whole report with its thresholds and the sentence as a JSON object, indented by two spaces.
std::string as_json(const CompareReport& report);

/// Returns picture A in faint gray, with tints: blue for pixels that differ within the threshold, yellow for resampled
/// edges, orange-red (#e4572e) for pixels beyond the threshold. If the sizes differ, the result has the larger width
/// and height, and areas that only one picture has are tinted violet. Pixels that the mask leaves out are dimmed and
/// hatched.
Image diff_picture(const Image& a, const Image& b, const CompareOptions& options = {}, const Mask& mask = {});

}  // namespace viewing
