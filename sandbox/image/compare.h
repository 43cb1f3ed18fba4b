// Two pictures compared by two thresholds: how far a channel may be off, and which share of the pixels may be off by
// more. A worst difference alone fails on one stray edge pixel; a share alone lets a small wrong thing pass. For
// pictures of another driver there is a profile of its own.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/mask.h"

namespace viewing {

/// strict is for pictures of one machine and one driver. portable lets pass what another driver or another number of
/// samples does to edges (is_resampled_edge in portable.h), and finds what strict cannot: a shift of one level.
enum class CompareProfile { strict, portable };
inline constexpr std::array profile_names{"strict", "portable"};

/// strict: equal ⇔ same size, and the pixels of which a channel (red, green, blue or alpha) differs by more than
/// `worst` are at most `share` of what is compared. portable: resampled edges do not count among these pixels, and no
/// block of them that hang together has more than `block_px`, and no square of 16 x 16 pixels is shifted by more than
/// `shift`.
struct CompareOptions {
    /// Levels of 255 that a channel may be off. 2: the renderer's rounding between kinds of processors; one level
    /// cannot be seen, a wrong light or normal changes tens.
    int worst = 2;
    /// 0 … 1. 0: no pixel may be beyond `worst`.
    double share = 0.0;
    /// A pixel that has a like in the other picture, at most so many pixels away in x and y and as seen from either
    /// picture, is not beyond `worst`: with 1, edges that moved by a pixel are no difference.
    int reach_px = 0;
    CompareProfile profile = CompareProfile::strict;
    /// portable alone. 4: other samples leave single pixels at corners and at faces thinner than a pixel, four in a
    /// block with 16 samples against 4; an edge that moved over five rows leaves five.
    std::int64_t block_px = 4;
    /// portable alone. Levels. 0.6: noise of two levels up or down shifts the mean of 256 pixels by 0.48 at most in a
    /// picture of 640 x 360 (seven standard deviations are 0.62); one level more in a shadow's interior shifts it by
    /// 0.75.
    double shift = 0.6;
};

/// The thresholds of the portable profile. worst 3: noise of two levels and the rounding of one. share 0.002: other
/// samples leave 0.0006 at most where the picture is full of lines; more, though far apart, is no rounding.
constexpr CompareOptions portable_options{.worst = 3, .share = 0.002, .profile = CompareProfile::portable};

/// The thresholds of a profile.
constexpr CompareOptions options_of(CompareProfile profile) {
    return profile == CompareProfile::portable ? portable_options : CompareOptions{};
}

/// A rectangle of the picture, pixel (0, 0) at the top left.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
    std::int64_t pixels = 0;  ///< how many beyond the threshold lie in it
    bool operator==(const PixelBox&) const = default;
};

struct CompareReport {
    bool equal = false;
    bool sizes_differ = false;      ///< then never equal; the part that both have, from the top left, is compared
    std::array<int, 2> size_a{};    ///< width, height
    std::array<int, 2> size_b{};    ///< width, height
    std::int64_t pixels = 0;        ///< of the larger width times the larger height
    std::int64_t left_out = 0;      ///< of these the mask's, which are not compared
    std::int64_t different = 0;     ///< any channel by any amount; with them all that not both pictures have
    std::int64_t beyond = 0;        ///< a channel by more than options.worst; with them all that not both have
    std::int64_t resampled = 0;     ///< portable: by more as well, but an edge seen with other samples
    double mean = 0.0;              ///< of all channels' differences without their sign, levels
    std::array<double, 4> shift{};  ///< mean of A minus B: red, green, blue, alpha, levels
    std::array<double, 4>
        local_shift{};        ///< portable: the largest in a square of 16 x 16 pixels, of those within worst
    std::int64_t blocks = 0;  ///< into which the pixels beyond the threshold fall, each with its eight neighbours
    std::int64_t largest_block = 0;   ///< pixels of the largest
    int worst_found = 0;              ///< the largest difference of a channel, levels
    std::array<int, 2> worst_at{};    ///< x, y of the first pixel that has it; 0, 0 when nothing differs
    std::vector<PixelBox> boxes;      ///< around the pixels beyond the threshold, most pixels first; at most 16
    std::int64_t boxes_left_out = 0;  ///< further ones
    CompareOptions options;

    double beyond_share() const;  ///< beyond / (pixels − left_out); 0 where nothing is compared
};

/// How far each pixel of the part that both pictures have is from the other picture's, row by row from the top: the
/// largest difference of a channel, in levels; `worst` at most where the reach finds a like or an edge is resampled.
std::vector<std::uint8_t> pixel_differences(const Image& a, const Image& b, const CompareOptions& options);

/// Options: worst 0 … 255, share 0 … 1, reach 0 or more. Boxes that are at most 16 pixels apart (or 1/80 of the larger
/// side, if that is more) are one box. What the mask leaves out of the part that both pictures have differs by nothing
/// and counts nowhere; a mask of another size covers what it has, from the top left.
CompareReport compare_images(const Image& a, const Image& b, const CompareOptions& options = {}, const Mask& mask = {});

/// One line for a person, starting with "equal" or "different".
std::string sentence(const CompareReport& report);

/// The whole report with its thresholds and sentence as a JSON object, two spaces a level.
std::string as_json(const CompareReport& report);

/// A in faint grey; pixels within the threshold but not equal tinted blue, resampled edges yellow, pixels beyond the
/// threshold orange-red (#e4572e). When
/// sizes differ it has the larger width and height, and what not both pictures have is tinted violet. What the mask
/// leaves out is dimmed and hatched.
Image diff_picture(const Image& a, const Image& b, const CompareOptions& options = {}, const Mask& mask = {});

}  // namespace viewing
