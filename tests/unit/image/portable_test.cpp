// Tests the portable profile on constructed edges with known movements, and its parts against a slow and obvious count
// on seeded random pictures.
#include "image/portable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include "image/blocks.h"
#include "image/compare.h"

namespace viewing {
namespace {

/// Draws a gray picture; `level` gives the value at a pixel's center, (x + ½, y + ½).
Image drawn_edge(int width, int height, const std::function<double(double, double)>& level) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto grey = static_cast<std::uint8_t>(std::lround(level(x + 0.5, y + 0.5)));
            image.rgba.insert(image.rgba.end(), {grey, grey, grey, 255});
        }
    return image;
}

/// Draws the half-plane x·cos + y·sin < offset at level 200 and the rest at 80, with this many samples along a pixel's
/// side.
Image half_plane(double angle_deg, double offset, int samples) {
    const double cosine = std::cos(angle_deg * 0.017453292519943295), sine = std::sin(angle_deg * 0.017453292519943295);
    return drawn_edge(48, 48, [&](double x, double y) {
        int inside = 0;
        for (int i = 0; i < samples; ++i)
            for (int j = 0; j < samples; ++j)
                inside += (x - 24 + (i + 0.5) / samples - 0.5) * cosine + (y - 24 + (j + 0.5) / samples - 0.5) * sine <
                          offset;
        return 80.0 + 120.0 * inside / (samples * samples);
    });
}

TEST(Portable, EdgesWithOtherSamplesAreEqualAtEveryAngle) {
    for (int angle = 0; angle < 180; angle += 7)
        for (const double offset : {0.0, 0.13, 0.37, 0.5}) {
            SCOPED_TRACE(std::to_string(angle) + "°, " + std::to_string(offset));
            const std::array pictures{half_plane(angle, offset, 1), half_plane(angle, offset, 2),
                                      half_plane(angle, offset, 4)};
            for (const Image& a : pictures)
                for (const Image& b : pictures) EXPECT_TRUE(compare_images(a, b, portable_options).equal);
        }
}

TEST(Portable, AnEdgeMovedByAPixelIsFoundAtEveryAngle) {
    for (int angle = 0; angle < 180; angle += 7)
        for (const int samples : {1, 2, 4}) {
            SCOPED_TRACE(std::to_string(angle) + "°, samples a side " + std::to_string(samples));
            // Move the edge by a pixel along the axis closest to its normal.
            const double along = std::max(std::abs(std::cos(angle * 0.017453292519943295)),
                                          std::abs(std::sin(angle * 0.017453292519943295)));
            const CompareReport found = compare_images(half_plane(angle, 0.2, samples),
                                                       half_plane(angle, 0.2 + along, samples), portable_options);
            EXPECT_FALSE(found.equal) << sentence(found);
        }
}

TEST(Portable, AThinnerLineIsEqualAndAMovedOneIsNot) {
    const auto line = [](double left, double width) {
        return drawn_edge(40, 30, [=](double x, double) {
            const double inside = std::min(x + 0.5, left + width) - std::max(x - 0.5, left);
            return 120.0 - 60.0 * std::clamp(inside, 0.0, 1.0);
        });
    };
    EXPECT_TRUE(compare_images(line(18.2, 3.0), line(18.6, 2.2), portable_options).equal);
    EXPECT_FALSE(compare_images(line(18.2, 3.0), line(19.2, 3.0), portable_options).equal);
    EXPECT_FALSE(compare_images(line(18.0, 1.0), line(19.0, 1.0), portable_options).equal);
    EXPECT_FALSE(compare_images(line(18.0, 1.0), line(18.0, 0.0), portable_options).equal) << "a line that is gone";
}

TEST(Portable, FlatPartsAreHeldToTheThreshold) {
    const Image flat = drawn_edge(40, 40, [](double, double) { return 50.0; });
    for (const int level : {3, 4, 28}) {
        const Image hole = drawn_edge(
            40, 40, [=](double x, double y) { return 50.0 + (x > 20 && x < 25 && y > 10 && y < 14 ? level : 0); });
        EXPECT_EQ(compare_images(hole, flat, portable_options).equal, level == 3) << level;
    }
}

TEST(Portable, ABlockOfFourIsAllowedAndOneOfFiveIsNot) {
    const Image flat = drawn_edge(64, 64, [](double, double) { return 50.0; });
    for (const int length : {4, 5}) {
        const Image dots = drawn_edge(64, 64, [=](double x, double y) {  // a diagonal, whose pixels touch at corners
            return x - 20 == y - 20 && x > 20 && x < 20 + length ? 90.0 : 50.0;
        });
        const CompareReport found = compare_images(dots, flat, portable_options);
        EXPECT_EQ(found.largest_block, length);
        EXPECT_EQ(found.blocks, 1);
        EXPECT_EQ(found.equal, length == 4) << sentence(found);
    }
}

TEST(Portable, ManyScatteredPixelsAreADifference) {
    const Image flat = drawn_edge(100, 100, [](double, double) { return 50.0; });
    for (const int count : {20, 21}) {
        Image dots = flat;
        for (int i = 0; i < count; ++i) dots.row(4 * (i / 20) + 2)[4 * (5 * (i % 20) + 2)] = 200;
        EXPECT_EQ(compare_images(dots, flat, portable_options).equal, count == 20);
    }
}

TEST(Portable, NoiseIsEqualAndAShiftBelowItIsNot) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        std::mt19937 random(seed);
        Image a = drawn_edge(160, 120, [](double x, double y) { return 60 + x / 2 + y / 3; });
        Image b = a;
        for (std::size_t i = 0; i < b.rgba.size(); ++i)
            if (i % 4 != 3) b.rgba[i] = static_cast<std::uint8_t>(b.rgba[i] + static_cast<int>(random() % 5) - 2);
        EXPECT_TRUE(compare_images(a, b, portable_options).equal) << seed;
        Image shifted = a;
        for (int y = 50; y < 70; ++y)
            for (int x = 50; x < 70; ++x) --shifted.row(y)[4 * x + 1];
        const CompareReport found = compare_images(shifted, a, portable_options);
        EXPECT_FALSE(found.equal);
        EXPECT_EQ(found.local_shift, (std::array{0.0, -1.0, 0.0, 0.0}));
        EXPECT_NEAR(found.shift[1], -400.0 / (160 * 120), 1e-12);
        EXPECT_NEAR(found.mean, 400.0 / (160 * 120) / 4, 1e-12);
    }
}

TEST(Portable, TheLocalShiftIsTheLargestOfAllSquares) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int width = 5 + static_cast<int>(random() % 40), height = 5 + static_cast<int>(random() % 40);
        std::vector<std::int16_t> levels(static_cast<std::size_t>(4 * width * height));
        for (std::int16_t& level : levels) level = static_cast<std::int16_t>(static_cast<int>(random() % 9) - 4);
        LocalShift shift(width, height);
        for (int y = 0; y < height; ++y)
            shift.add_row(y, std::span(levels).subspan(static_cast<std::size_t>(4 * width * y),
                                                       static_cast<std::size_t>(4 * width)));
        const int side_x = std::min(16, width), side_y = std::min(16, height);
        for (int c = 0; c < 4; ++c) {
            double largest = 0.0;
            for (int top = 0; top + side_y <= height; ++top)
                for (int left = 0; left + side_x <= width; ++left) {
                    int sum = 0;
                    for (int y = top; y < top + side_y; ++y)
                        for (int x = left; x < left + side_x; ++x)
                            sum += levels[static_cast<std::size_t>(4 * (y * width + x) + c)];
                    largest = std::max(largest, std::abs(static_cast<double>(sum)) / (side_x * side_y));
                }
            EXPECT_DOUBLE_EQ(std::abs(shift.largest()[static_cast<std::size_t>(c)]), largest);
        }
    }
}

TEST(Portable, BlocksMatchAFloodFill) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int width = 1 + static_cast<int>(random() % 30), height = 1 + static_cast<int>(random() % 30);
        const auto density = 10 + random() % 70;
        std::vector<std::uint8_t> levels(static_cast<std::size_t>(width * height));
        std::set<std::pair<int, int>> left;
        BlockFinder finder;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x)
                if (random() % 100 < density) {
                    levels[static_cast<std::size_t>(y * width + x)] = 9;
                    left.insert({x, y});
                }
            finder.add_row(
                y, std::span(levels).subspan(static_cast<std::size_t>(y * width), static_cast<std::size_t>(width)), 8);
        }
        std::int64_t blocks = 0, largest = 0;
        while (!left.empty()) {
            ++blocks;
            std::int64_t pixels = 0;
            std::vector<std::pair<int, int>> open{*left.begin()};
            left.erase(left.begin());
            while (!open.empty()) {
                const auto [x, y] = open.back();
                open.pop_back();
                ++pixels;
                for (int v = y - 1; v <= y + 1; ++v)
                    for (int u = x - 1; u <= x + 1; ++u)
                        if (left.erase({u, v}) > 0) open.push_back({u, v});
            }
            largest = std::max(largest, pixels);
        }
        EXPECT_EQ(finder.blocks(), blocks);
        EXPECT_EQ(finder.largest(), largest);
    }
}

TEST(Portable, DifferentSizesRemainADifferenceAndNothingIsReadBeyond) {
    const Image a = half_plane(30, 0.1, 1), b = half_plane(30, 0.1, 4);
    EXPECT_FALSE(compare_images(cropped(a, 0, 0, 20, 30), b, portable_options).equal);
    EXPECT_FALSE(compare_images(a, cropped(b, 0, 0, 47, 5), portable_options).equal);
    EXPECT_TRUE(compare_images({}, {}, portable_options).equal);
    EXPECT_TRUE(compare_images(cropped(a, 3, 3, 4, 4), cropped(a, 3, 3, 4, 4), portable_options).equal);
}

}  // namespace
}  // namespace viewing
