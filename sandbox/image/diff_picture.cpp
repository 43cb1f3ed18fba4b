// Draws the differences that a comparison finds.
#include <cmath>

#include "image/compare.h"
#include "image/differences.h"

namespace viewing {

namespace {

/// Blends `tint` over a color; `amount` is from 0 to 1.
void blend(std::uint8_t* pixel, const std::array<std::uint8_t, 3>& tint, double amount) {
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(std::lround(pixel[c] * (1.0 - amount) + tint[c] * amount));
}

/// Writes a pixel in a faint gray, so that the marks stand out.
void faint_gray(const std::uint8_t* from, std::uint8_t* to) {
    const auto gray = static_cast<std::uint8_t>(24.0 + 0.6 * luma(from));
    to[0] = to[1] = to[2] = gray;
    to[3] = 255;
}

}  // namespace

Image diff_picture(const Image& a, const Image& b, const CompareOptions& options, const Mask& mask) {
    constexpr std::array<std::uint8_t, 3> beyond_color{0xE4, 0x57, 0x2E};
    constexpr std::array<std::uint8_t, 3> within_color{0x56, 0xB4, 0xE9};
    constexpr std::array<std::uint8_t, 3> resampled_color{0xF0, 0xE4, 0x42};
    constexpr std::array<std::uint8_t, 3> uncovered_color{0xCC, 0x79, 0xA7};
    constexpr std::array<std::uint8_t, 3> dimmed_color{0, 0, 0};
    constexpr int hatch_px = 6;  // distance between hatching lines
    Image out{std::max(a.width, b.width), std::max(a.height, b.height), {}};
    out.rgba.resize(out.row_bytes() * static_cast<std::size_t>(out.height));
    const auto has = [](const Image& image, int x, int y) { return x < image.width && y < image.height; };
    Differences rows(a, b, options, mask);
    std::span<const std::uint8_t> difference;
    for (int y = 0; y < out.height; ++y) {
        if (y < rows.height) difference = rows.row(y);
        for (int x = 0; x < out.width; ++x) {
            constexpr std::array<std::uint8_t, 4> nothing{};
            std::uint8_t* pixel = out.pixel(x, y);
            faint_gray(has(a, x, y) ? a.pixel(x, y) : has(b, x, y) ? b.pixel(x, y) : nothing.data(), pixel);
            if (!has(a, x, y) || !has(b, x, y)) {
                blend(pixel, uncovered_color, 0.4);
            } else if (mask.leaves_out(x, y)) {
                blend(pixel, dimmed_color, (x + y) % hatch_px == 0 ? 1.0 : 0.5);
            } else if (const int d = difference[x]; d > options.worst) {
                blend(pixel, beyond_color, 1.0);
            } else if (rows.as_found()[x] > options.worst) {
                blend(pixel, resampled_color, 0.6);
            } else if (d > 0) {
                blend(pixel, within_color, 0.4);
            }
        }
    }
    return out;
}

}  // namespace viewing
