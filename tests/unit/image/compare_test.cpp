// Comparisons of pictures, checked against a slow and obvious implementation on seeded random edits, and on handmade
// pictures at the thresholds.
#include "image/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "text/json.h"

namespace viewing {
namespace {

Image plain(int width, int height, std::uint8_t level = 100) {
    Image image{width, height, {}};
    image.rgba.assign(image.row_bytes() * static_cast<std::size_t>(height), level);
    return image;
}

void fill(Image& image, int x, int y, int width, int height, int change) {
    for (int j = y; j < y + height; ++j)
        for (int i = x; i < x + width; ++i)
            image.pixel(i, j)[1] = static_cast<std::uint8_t>(image.pixel(i, j)[1] + change);
}

int difference_at(const Image& a, const Image& b, int x, int y) {
    int largest = 0;
    for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
    return largest;
}

/// Joins single pixels into boxes by trying all pairs repeatedly until no two are near.
std::vector<PixelBox> boxes_by_brute_force(const Image& a, const Image& b, int worst, int gap) {
    std::vector<PixelBox> boxes;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            if (difference_at(a, b, x, y) > worst) boxes.push_back({x, y, 1, 1, 1});
    const auto apart = [](int a_begin, int a_size, int b_begin, int b_size) {
        return std::max(b_begin - (a_begin + a_size), a_begin - (b_begin + b_size));
    };
    for (bool joined = true; joined;) {
        joined = false;
        for (std::size_t i = 0; i < boxes.size() && !joined; ++i) {
            for (std::size_t j = i + 1; j < boxes.size() && !joined; ++j) {
                PixelBox& p = boxes[i];
                const PixelBox q = boxes[j];
                if (apart(p.x, p.width, q.x, q.width) > gap || apart(p.y, p.height, q.y, q.height) > gap) continue;
                const int right = std::max(p.x + p.width, q.x + q.width);
                const int bottom = std::max(p.y + p.height, q.y + q.height);
                p.x = std::min(p.x, q.x);
                p.y = std::min(p.y, q.y);
                p.width = right - p.x;
                p.height = bottom - p.y;
                p.pixels += q.pixels;
                boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(j));
                joined = true;
            }
        }
    }
    std::sort(boxes.begin(), boxes.end(), [](const PixelBox& p, const PixelBox& q) {
        return std::tuple(-p.pixels, p.y, p.x) < std::tuple(-q.pixels, q.y, q.x);
    });
    return boxes;
}

TEST(Compare, AgreesWithBruteForceOnRandomEdits) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const auto up_to = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
        Image a = plain(40 + up_to(160), 30 + up_to(120));
        for (auto& byte : a.rgba) byte = static_cast<std::uint8_t>(random());
        Image b = a;
        const int edits = up_to(30);
        for (int i = 0; i < edits; ++i) {
            const int x = up_to(a.width), y = up_to(a.height);
            const int width = 1 + up_to(std::min(a.width - x, i % 3 == 0 ? 30 : 2));
            const int height = 1 + up_to(std::min(a.height - y, i % 4 == 0 ? 20 : 2));
            const int change = 1 + up_to(seed % 2 == 0 ? 5 : 200);
            for (int j = y; j < y + height; ++j)
                for (int k = x; k < x + width; ++k) {
                    auto& channel = b.pixel(k, j)[up_to(4)];
                    channel = static_cast<std::uint8_t>(channel + change);
                }
        }
        const CompareOptions options{up_to(4), up_to(3) * 0.01};

        std::int64_t different = 0, beyond = 0;
        int worst = 0;
        std::array<int, 2> worst_at{};
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                const int d = difference_at(a, b, x, y);
                different += d > 0;
                beyond += d > options.worst;
                if (d > worst) {
                    worst = d;
                    worst_at = {x, y};
                }
            }
        auto boxes = boxes_by_brute_force(a, b, options.worst, 16);
        const auto left_out = std::max<std::int64_t>(0, static_cast<std::int64_t>(boxes.size()) - 16);
        boxes.resize(boxes.size() - static_cast<std::size_t>(left_out));

        const CompareReport report = compare_images(a, b, options);
        EXPECT_EQ(report.pixels, static_cast<std::int64_t>(a.width) * a.height);
        EXPECT_EQ(report.different, different);
        EXPECT_EQ(report.beyond, beyond);
        EXPECT_EQ(report.worst_found, worst);
        EXPECT_EQ(report.worst_at, worst_at);
        EXPECT_EQ(report.boxes, boxes);
        EXPECT_EQ(report.boxes_left_out, left_out);
        EXPECT_EQ(report.equal, static_cast<double>(beyond) <= options.share * static_cast<double>(report.pixels));
        const CompareReport swapped = compare_images(b, a, options);
        EXPECT_EQ(swapped.boxes, boxes);
        EXPECT_EQ(swapped.worst_found, worst);
    }
}

TEST(Compare, TheWorstLevelIsAllowedAndOneMoreIsNot) {
    const Image a = plain(10, 10);
    Image b = a;
    b.pixel(3, 7)[2] = 105;
    EXPECT_TRUE(compare_images(a, b, {5, 0.0}).equal);
    const CompareReport report = compare_images(a, b, {4, 0.0});
    EXPECT_FALSE(report.equal);
    EXPECT_EQ(report.worst_found, 5);
    EXPECT_EQ(report.worst_at, (std::array{3, 7}));
    b.pixel(3, 7)[2] = 95;
    EXPECT_FALSE(compare_images(a, b, {4, 0.0}).equal);
    EXPECT_TRUE(compare_images(a, b, {5, 0.0}).equal);
}

TEST(Compare, AlphaCounts) {
    const Image a = plain(4, 4);
    Image b = a;
    b.pixel(0, 0)[3] = 0;
    EXPECT_EQ(compare_images(a, b).worst_found, 100);
}

TEST(Compare, TheShareIsAllowedAndOnePixelMoreIsNot) {
    const Image a = plain(10, 10);
    Image b = a;
    fill(b, 0, 0, 7, 1, 50);
    EXPECT_TRUE(compare_images(a, b, {2, 0.07}).equal);
    fill(b, 7, 0, 1, 1, 50);
    EXPECT_FALSE(compare_images(a, b, {2, 0.07}).equal);
    EXPECT_TRUE(compare_images(a, b, {2, 1.0}).equal);
    EXPECT_TRUE(compare_images(a, b, {255, 0.0}).equal);
}

TEST(Compare, BoxesMergeAtSixteenPixelsApartAndNotAtSeventeen) {
    const Image a = plain(200, 100);
    for (const int gap : {16, 17}) {
        Image b = a;
        fill(b, 10, 10, 5, 5, 50);
        fill(b, 15 + gap, 10, 3, 5, 50);
        EXPECT_EQ(compare_images(a, b).boxes.size(), gap == 16 ? 1U : 2U);
        b = a;
        fill(b, 10, 10, 5, 5, 50);
        fill(b, 10, 15 + gap, 5, 3, 50);
        EXPECT_EQ(compare_images(a, b).boxes.size(), gap == 16 ? 1U : 2U);
    }
}

TEST(Compare, ABoxThatGrowsSwallowsOneThatEndedLongBefore) {
    const Image a = plain(300, 300);
    Image b = a;
    fill(b, 140, 20, 4, 4, 90);   // a small square inside a U, far above the bottom bar
    fill(b, 20, 10, 4, 250, 90);  // the two sides of the U, which only the bottom bar joins
    fill(b, 260, 10, 4, 250, 90);
    fill(b, 20, 258, 244, 2, 90);
    const CompareReport report = compare_images(a, b);
    ASSERT_EQ(report.boxes.size(), 1U);  // the U includes the square inside it
    EXPECT_EQ(report.boxes[0].x, 20);
    EXPECT_EQ(report.boxes[0].y, 10);
    EXPECT_EQ(report.boxes[0].width, 244);
    EXPECT_EQ(report.boxes[0].height, 250);
    EXPECT_EQ(report.boxes[0].pixels, report.beyond);
}

TEST(Compare, AtMostSixteenBoxesLargestFirst) {
    const Image a = plain(1000, 100);
    Image b = a;
    for (int i = 0; i < 20; ++i) fill(b, 50 * i, 40, 1 + i % 7, 2, 90);
    const CompareReport report = compare_images(a, b);
    EXPECT_EQ(report.boxes.size(), 16U);
    EXPECT_EQ(report.boxes_left_out, 4);
    EXPECT_EQ(report.boxes.front().pixels, 14);
    EXPECT_EQ(report.boxes.front().x, 300);
    EXPECT_TRUE(std::is_sorted(report.boxes.begin(), report.boxes.end(),
                               [](const PixelBox& p, const PixelBox& q) { return p.pixels > q.pixels; }));
}

TEST(Compare, DifferentSizesAreReportedInASentence) {
    const Image a = plain(20, 10);
    const Image b = plain(15, 12);
    const CompareReport report = compare_images(a, b, {255, 1.0});
    EXPECT_FALSE(report.equal);
    EXPECT_TRUE(report.sizes_differ);
    EXPECT_EQ(report.pixels, 20 * 12);
    EXPECT_EQ(report.different, 20 * 12 - 15 * 10);
    EXPECT_EQ(report.beyond, 20 * 12 - 15 * 10);
    EXPECT_EQ(report.worst_found, 0);
    EXPECT_NE(sentence(report).find("A is 20 × 10 and B is 15 × 12"), std::string::npos) << sentence(report);

    const Image marked = diff_picture(a, b);
    EXPECT_EQ(marked.width, 20);
    EXPECT_EQ(marked.height, 12);
    const auto is_grey = [&](int x, int y) {
        const std::uint8_t* p = marked.pixel(x, y);
        return p[0] == p[1] && p[1] == p[2];
    };
    EXPECT_TRUE(is_grey(14, 9));
    EXPECT_FALSE(is_grey(15, 9));   // only A has this pixel
    EXPECT_FALSE(is_grey(14, 10));  // only B has this pixel
    EXPECT_FALSE(is_grey(19, 11));  // neither has this pixel
}

TEST(Compare, EmptyPicturesAreEqual) {
    EXPECT_TRUE(compare_images({}, {}).equal);
    EXPECT_FALSE(compare_images({}, plain(1, 1)).equal);
    EXPECT_EQ(diff_picture({}, {}).rgba.size(), 0U);
}

TEST(Compare, TheDiffPictureMarksBeyondInOrangeRedAndWithinInBlue) {
    const Image a = plain(10, 10);
    Image b = a;
    b.pixel(2, 3)[0] = 200;
    b.pixel(4, 5)[0] = 102;
    const Image marked = diff_picture(a, b, {2, 0.0});
    EXPECT_EQ(marked.pixel(2, 3)[0], 0xE4);
    EXPECT_EQ(marked.pixel(2, 3)[1], 0x57);
    EXPECT_EQ(marked.pixel(2, 3)[2], 0x2E);
    EXPECT_GT(marked.pixel(4, 5)[2], marked.pixel(4, 5)[0]);
    EXPECT_EQ(marked.pixel(0, 0)[0], marked.pixel(0, 0)[2]);
    for (std::size_t i = 3; i < marked.rgba.size(); i += 4) ASSERT_EQ(marked.rgba[i], 255);
}

TEST(Compare, TheSentenceSaysHowManyHowMuchWhereAndAgainstWhat) {
    const Image a = plain(1000, 100);
    Image b = a;
    EXPECT_EQ(sentence(compare_images(a, b)), "equal: all 1000 × 100 pixels are the same");
    fill(b, 100, 20, 10, 5, 1);
    EXPECT_EQ(sentence(compare_images(a, b)).rfind("equal within the thresholds: 50 of 100000 pixels differ", 0), 0U)
        << sentence(compare_images(a, b));
    fill(b, 100, 20, 10, 5, 40);
    fill(b, 500, 20, 1, 1, 60);
    const std::string text = sentence(compare_images(a, b, {2, 0.0001}));
    EXPECT_EQ(text,
              "different: 51 of 100000 pixels differ, at worst by 60 of 255 at (500, 20); 51 (0.051%) by more than 2, "
              "limit 0.01%; where: x 100 … 109, y 20 … 24 and 1 more place");
    EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(Compare, TheJsonContainsTheReport) {
    const Image a = plain(100, 50);
    Image b = a;
    fill(b, 10, 20, 30, 5, 40);
    const CompareReport report = compare_images(a, b, {3, 0.001});
    const auto json = nlohmann::json::parse(as_json(report));
    EXPECT_EQ(json["equal"], false);
    EXPECT_EQ(json["sizes_differ"], false);
    EXPECT_EQ(json["size_a"], (std::array{100, 50}));
    EXPECT_EQ(json["pixels"], 5000);
    EXPECT_EQ(json["different"], 150);
    EXPECT_EQ(json["beyond"], 150);
    EXPECT_EQ(json["share"], 0.03);
    EXPECT_EQ(json["worst"], 40);
    EXPECT_EQ(json["worst_at"], (std::array{10, 20}));
    EXPECT_EQ(json["boxes"], nlohmann::json::parse(R"([{"x":10,"y":20,"width":30,"height":5,"pixels":150}])"));
    EXPECT_EQ(json["boxes_left_out"], 0);
    EXPECT_EQ(json["thresholds"], nlohmann::json::parse(R"({"worst":3,"share":0.001})"));
    EXPECT_EQ(json["sentence"], sentence(report));
}

}  // namespace
}  // namespace viewing
