#include "image/differences.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "image/portable.h"

namespace viewing {

Differences::Differences(const Image& a, const Image& b, const CompareOptions& options, const Mask& mask)
    : a_(a),
      b_(b),
      mask_(mask),
      options_(options),
      width(std::min(a.width, b.width)),
      height(std::min(a.height, b.height)),
      channels_(4 * static_cast<std::size_t>(width)),
      pixels_(static_cast<std::size_t>(width)) {}

bool Differences::are_none(int y) const {
    return std::memcmp(a_.row(y), b_.row(y), channels_.size()) == 0;
}

std::span<const std::uint8_t> Differences::row(int y) {
    // Compilers vectorize two plain loops over bytes, but not one loop over pixels and channels.
    const std::uint8_t *a = a_.row(y), *b = b_.row(y);
    std::uint8_t* channel = channels_.data();
    for (std::size_t i = 0; i < channels_.size(); ++i)
        channel[i] = static_cast<std::uint8_t>(std::max(a[i], b[i]) - std::min(a[i], b[i]));
    std::uint8_t* pixel = pixels_.data();
    for (std::size_t x = 0; x < pixels_.size(); ++x, channel += 4)
        pixel[x] = std::max(std::max(channel[0], channel[1]), std::max(channel[2], channel[3]));
    if (y < mask_.height())
        for (int x = 0; x < std::min(width, mask_.width()); ++x)
            if (mask_.leaves_out(x, y)) pixel[x] = 0;
    if (options_.reach_px > 0)
        for (int x = 0; x < width; ++x)
            if (pixel[x] > options_.worst && has_like(a_, x, y, b_) && has_like(b_, x, y, a_))
                pixel[x] = static_cast<std::uint8_t>(options_.worst);
    found_ = pixels_;
    if (options_.profile == CompareProfile::portable)
        for (int x = 0; x < width; ++x)
            if (pixel[x] > options_.worst && is_resampled_edge(a_, b_, x, y, options_.worst))
                pixel[x] = static_cast<std::uint8_t>(options_.worst);
    return pixels_;
}

bool Differences::has_like(const Image& from, int x, int y, const Image& other) const {
    const std::uint8_t* pixel = from.pixel(x, y);
    const int reach = options_.reach_px;
    for (int v = std::max(y - reach, 0); v <= std::min(y + reach, height - 1); ++v)
        for (int u = std::max(x - reach, 0); u <= std::min(x + reach, width - 1); ++u) {
            const std::uint8_t* near = other.pixel(u, v);
            int worst = 0;
            for (int channel = 0; channel < 4; ++channel)
                worst = std::max(worst, std::abs(pixel[channel] - near[channel]));
            if (worst <= options_.worst) return true;
        }
    return false;
}

}  // namespace viewing
