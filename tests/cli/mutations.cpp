#include "cli/mutations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "image/compare.h"

namespace cli_tests {

using viewing::Image;

namespace {

double light_of(double level) {
    const double v = level / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

double level_of(double light) {
    return 255.0 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055);
}

}  // namespace

Area all_of(const Image& image) {
    return {0, 0, image.width, image.height};
}

Image changed(Image image, const Area& area, const std::function<double(int, double)>& change) {
    for (int y = area.y; y < area.y + area.height; ++y)
        for (int x = area.x; x < area.x + area.width; ++x)
            for (int c = 0; c < 3; ++c) {
                std::uint8_t& level = image.pixel(x, y)[c];
                level = static_cast<std::uint8_t>(std::lround(std::clamp(change(c, level), 0.0, 255.0)));
            }
    return image;
}

Image shifted(Image image, const Area& area) {
    for (int y = area.y; y < area.y + area.height; ++y) {
        std::uint8_t* const first = image.pixel(area.x, y);
        std::copy_backward(first, first + 4 * static_cast<std::ptrdiff_t>(area.width - 1),
                           first + 4 * static_cast<std::ptrdiff_t>(area.width));
    }
    return image;
}

Image noisy(const Image& image, int levels, unsigned seed) {
    std::mt19937 random(seed);
    const auto range = static_cast<unsigned>(2 * levels + 1);
    return changed(image, all_of(image),
                   [&](int, double level) { return level + static_cast<int>(random() % range) - levels; });
}

Image with_gamma(const Image& image, double gamma) {
    return changed(image, all_of(image),
                   [gamma](int, double level) { return 255.0 * std::pow(level / 255.0, 1.0 / gamma); });
}

Image resolved(const Image& image, int k) {
    Image small{image.width / k, image.height / k, {}};
    std::array<double, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = light_of(static_cast<double>(i));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            std::array<double, 3> sum{};
            for (int v = 0; v < k; ++v)
                for (int u = 0; u < k; ++u)
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += light[image.row(k * y + v)[4 * static_cast<std::size_t>(k * x + u) + c]];
            for (const double all : sum)
                small.rgba.push_back(static_cast<std::uint8_t>(std::lround(level_of(all / (k * k)))));
            small.rgba.push_back(255);
        }
    return small;
}

Area inside_of_difference(const Image& a, const Image& b, int worst, int width, int height, int margin) {
    const std::vector<std::uint8_t> levels = viewing::pixel_differences(a, b, {.worst = 255});
    const auto all_differ = [&](const Area& area) {
        for (int y = area.y; y < area.y + area.height; ++y)
            for (int x = area.x; x < area.x + area.width; ++x)
                if (levels[static_cast<std::size_t>(y * a.width + x)] <= worst) return false;
        return true;
    };
    std::vector<Area> found;
    for (int y = margin; y + height + margin <= a.height; ++y)
        for (int x = margin; x + width + margin <= a.width; ++x)
            if (all_differ({x - margin, y - margin, width + 2 * margin, height + 2 * margin}))
                found.push_back({x, y, width, height});
    return found.empty() ? Area{} : found[found.size() / 2];
}

}  // namespace cli_tests
