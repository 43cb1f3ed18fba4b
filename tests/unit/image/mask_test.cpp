// Rectangles and pictures as comparison masks, checked against pixels counted one by one.
#include "image/mask.h"

#include <gtest/gtest.h>

#include <climits>
#include <random>

#include "image/compare.h"

namespace viewing {
namespace {

Image noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    Image image{width, height, {}};
    image.rgba.resize(image.row_bytes() * static_cast<std::size_t>(height));
    for (auto& byte : image.rgba) byte = static_cast<std::uint8_t>(random());
    return image;
}

TEST(Mask, ExcludesNothingByDefault) {
    EXPECT_FALSE(Mask().leaves_out(0, 0));
    EXPECT_EQ(Mask(7, 5).pixels(), 0);
    EXPECT_EQ(compare_images(noise(9, 8, 1), noise(9, 8, 2), {}, Mask(9, 8)).left_out, 0);
}

TEST(Mask, RectanglesExcludeExactlyTheirPixelsInThePicture) {
    const std::vector<MaskRect> rects{{3, 2, 4, 5},
                                      {-2, -3, 4, 5},
                                      {18, 10, 9, 9},
                                      {5, 5, 0, 4},
                                      {6, 6, -3, 2},
                                      {40, 40, 2, 2},
                                      {-9, 7, 30, 1},
                                      {INT_MAX, 0, 9, 9},
                                      {1, INT_MIN, 2, INT_MAX},
                                      {2, 12, INT_MAX, INT_MAX}};
    for (const MaskRect& rect : rects) {
        SCOPED_TRACE(std::to_string(rect.x) + "," + std::to_string(rect.y) + " " + std::to_string(rect.width) + "x" +
                     std::to_string(rect.height));
        Mask mask(20, 13);
        mask.leave_out(rect);
        std::int64_t count = 0;
        for (int y = -1; y <= 13; ++y)
            for (int x = -1; x <= 20; ++x) {
                const bool is_in_picture = x >= 0 && y >= 0 && x < 20 && y < 13;
                const std::int64_t from_left = std::int64_t{x} - rect.x, from_top = std::int64_t{y} - rect.y;
                const bool expected = is_in_picture && from_left >= 0 && from_left < rect.width && from_top >= 0 &&
                                      from_top < rect.height;
                EXPECT_EQ(mask.leaves_out(x, y), expected) << x << ", " << y;
                count += expected;
            }
        EXPECT_EQ(mask.pixels(), count);
    }
}

TEST(Mask, APictureExcludesItsWhiteOpaquePixels) {
    Image picture{4, 2, {}};
    picture.rgba = {255, 255, 255, 255, 0,   0,   0,   255, 255, 255, 255, 0,   128, 128, 128, 128,
                    127, 127, 127, 255, 255, 255, 255, 127, 0,   255, 0,   255, 255, 0,   255, 255};
    const Mask mask(picture);
    const std::array<bool, 8> expected{true, false, false, true, false, false, true, false};
    for (int i = 0; i < 8; ++i) EXPECT_EQ(mask.leaves_out(i % 4, i / 4), expected[static_cast<std::size_t>(i)]) << i;
    EXPECT_EQ(mask.pixels(), 3);

    Mask both(4, 2);
    both.leave_out(MaskRect{1, 0, 1, 1});
    both.leave_out(mask);
    EXPECT_EQ(both.pixels(), 4);
}

TEST(Mask, ExcludedPixelsDoNotCount) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const auto up_to = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
        const Image a = noise(60, 40, seed);
        Image b = noise(60, 40, seed + 1000);
        Mask mask(60, 40);
        for (int i = 0; i < 3; ++i) mask.leave_out({up_to(60), up_to(40), up_to(30), up_to(20)});
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 60; ++x)
                if (!mask.leaves_out(x, y)) std::copy_n(a.pixel(x, y), 4, b.pixel(x, y));
        const CompareReport report = compare_images(a, b, {0, 0.0}, mask);
        EXPECT_TRUE(report.equal);
        EXPECT_EQ(report.different, 0);
        EXPECT_EQ(report.worst_found, 0);
        EXPECT_TRUE(report.boxes.empty());
        EXPECT_EQ(report.left_out, mask.pixels());

        int x = up_to(60), y = up_to(40);
        while (mask.leaves_out(x, y)) x = (x + 1) % 60, y = (y + (x == 0)) % 40;
        b.pixel(x, y)[1] ^= 0x80;
        const CompareReport one = compare_images(a, b, {0, 0.0}, mask);
        EXPECT_FALSE(one.equal);
        EXPECT_EQ(one.different, 1);
        EXPECT_EQ(one.worst_at, (std::array{x, y}));
        EXPECT_DOUBLE_EQ(one.beyond_share(), 1.0 / static_cast<double>(2400 - mask.pixels()));
    }
}

TEST(Mask, OfAnotherSizeCoversItsOwnExtent) {
    const Image a = noise(10, 10, 1), b = noise(10, 10, 2);
    Mask larger(30, 30);
    larger.leave_out({0, 0, 30, 30});
    EXPECT_EQ(compare_images(a, b, {}, larger).left_out, 100);
    EXPECT_TRUE(compare_images(a, b, {}, larger).equal);
    EXPECT_EQ(compare_images(a, b, {}, larger).beyond_share(), 0.0);
    Mask smaller(4, 3);
    smaller.leave_out({0, 0, 4, 3});
    EXPECT_EQ(compare_images(a, b, {0, 0.0}, smaller).different, 88);
}

TEST(Mask, DifferentSizesRemainADifference) {
    Mask everything(20, 20);
    everything.leave_out({0, 0, 20, 20});
    const CompareReport report = compare_images(noise(10, 10, 1), noise(12, 10, 1), {}, everything);
    EXPECT_FALSE(report.equal);
    EXPECT_EQ(report.different, 20);
}

TEST(Mask, IsHatchedAndDimmedInTheDiffPicture) {
    Image a{24, 24, std::vector<std::uint8_t>(std::size_t{24} * 24 * 4, 200)};
    Image b{24, 24, std::vector<std::uint8_t>(std::size_t{24} * 24 * 4, 20)};
    Mask mask(24, 24);
    mask.leave_out({0, 0, 12, 24});
    const Image marked = diff_picture(a, b, {}, mask);
    int black = 0, dimmed = 0;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            const std::uint8_t* at = marked.row(y) + 4 * x;
            if (x >= 12) {
                EXPECT_EQ(at[0], 0xE4) << x << ", " << y;
                continue;
            }
            EXPECT_TRUE(at[0] == at[1] && at[1] == at[2]) << "gray, as nothing was compared";
            EXPECT_LT(at[0], 100) << "darker than equal pixels";
            (at[0] == 0 ? black : dimmed)++;
        }
    EXPECT_EQ(black, 12 * 24 / 6) << "every sixth masked pixel of a row";
    EXPECT_EQ(dimmed, 12 * 24 * 5 / 6);
}

TEST(Mask, TheSentenceAndTheJsonSayHowMuchIsExcluded) {
    const Image a = noise(10, 10, 1);
    Mask mask(10, 10);
    mask.leave_out({2, 2, 3, 4});
    const CompareReport report = compare_images(a, a, {}, mask);
    EXPECT_EQ(sentence(report), "equal: all 88 compared pixels are the same; 12 pixels are left out by the mask");
    const std::string different = sentence(compare_images(a, noise(10, 10, 2), {}, mask));
    EXPECT_NE(different.find("different: 88 of 88 pixels differ"), std::string::npos) << different;
    EXPECT_NE(as_json(report).find("\"left_out\": 12"), std::string::npos);
}

}  // namespace
}  // namespace viewing
