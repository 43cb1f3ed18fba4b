// Compares pictures with a reach of one pixel, so that edges that moved by one pixel do not count. The pictures are
// drawn here as text; seeded random ones are checked against the definition.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "image/compare.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

constexpr CompareOptions alike{.worst = 2, .share = 0.0, .reach_px = 1};

/// Draws a picture from rows of letters: '.' is black, 'o' is gray, '#' is white, and '1' to '9' are that many levels
/// above gray.
Image drawn(const std::vector<std::string>& rows) {
    Image image{static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), {}};
    for (const std::string& row : rows)
        for (const char letter : row) {
            const int level = letter == '.' ? 0 : letter == 'o' ? 100 : letter == '#' ? 255 : 100 + letter - '0';
            const auto grey = static_cast<std::uint8_t>(level);
            image.rgba.insert(image.rgba.end(), {grey, grey, grey, 255});
        }
    return image;
}

/// Returns the differences found, as text.
std::vector<std::string> marks(const Image& a, const Image& b) {
    std::vector<std::string> rows(static_cast<std::size_t>(a.height));
    const std::vector<std::uint8_t> levels = pixel_differences(a, b, alike);
    for (std::size_t i = 0; i < levels.size(); ++i)
        rows[i / static_cast<std::size_t>(a.width)] += levels[i] > alike.worst ? 'x' : ' ';
    return rows;
}

std::int64_t beyond(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    const CompareReport found = compare_images(drawn(a), drawn(b), alike);
    EXPECT_EQ(compare_images(drawn(b), drawn(a), alike).beyond, found.beyond) << "neither picture is favored";
    return found.beyond;
}

TEST(MovedEdges, EqualPicturesDoNotDiffer) {
    const std::vector<std::string> rows{"..oo##", "..o1##", ".#.#.#"};
    EXPECT_EQ(beyond(rows, rows), 0);
    EXPECT_EQ(marks(drawn(rows), drawn(rows)), (std::vector<std::string>{"      ", "      ", "      "}));
}

TEST(MovedEdges, DifferencesBeginAboveTheThreshold) {
    EXPECT_EQ(beyond({"oooo", "oooo"}, {"2222", "2222"}), 0);
    EXPECT_EQ(beyond({"oooo", "oooo"}, {"3333", "3333"}), 8);
    EXPECT_EQ(compare_images(drawn({"oooo"}), drawn({"3333"}), alike).worst_found, 3);
}

TEST(MovedEdges, WithoutReachAreDifferences) {
    const Image a = drawn({"..####", "..####"}), b = drawn({"...###", "...###"});
    EXPECT_EQ(compare_images(a, b, alike).beyond, 0);
    EXPECT_EQ(compare_images(a, b, alike).different, 2) << "the pictures are not byte-identical";
    EXPECT_EQ(compare_images(a, b, {.worst = 2}).beyond, 2);
}

TEST(MovedEdges, ByOnePixelAreNoDifference) {
    EXPECT_EQ(beyond({"..####", "..####", "..####"}, {"...###", "...###", "...###"}), 0);
    EXPECT_EQ(beyond({"......", "######", "######"}, {"......", "......", "######"}), 0);
    EXPECT_EQ(beyond({"#.....", ".#....", "..#..."}, {".#....", "..#...", "...#.."}), 0) << "a thin line";
    EXPECT_EQ(beyond({"..####", "..####", "..####"}, {"....##", "....##", "....##"}), 6) << "moved by two pixels";
}

TEST(MovedEdges, AMissingBlockIsADifference) {
    const Image empty = drawn({"......", "......", "......", "......"});
    const Image block = drawn({"......", ".###..", ".###..", "......"});
    EXPECT_EQ(compare_images(empty, block, alike).worst_found, 255);
    EXPECT_EQ(marks(empty, block), (std::vector<std::string>{"      ", " xxx  ", " xxx  ", "      "}))
        << "top row first";
}

TEST(MovedEdges, ALonePixelAndAMissingLineAreDifferences) {
    EXPECT_EQ(beyond({".....", "..#..", "....."}, {".....", ".....", "....."}), 1);
    EXPECT_EQ(beyond({".....", "#####", "....."}, {".....", ".....", "....."}), 5);
}

TEST(MovedEdges, AreNotSearchedBeyondThePicture) {
    EXPECT_EQ(beyond({"#"}, {"#"}), 0);
    EXPECT_EQ(beyond({"#"}, {"."}), 1);
    EXPECT_EQ(beyond({"#..."}, {"...#"}), 2) << "the ends of a row are not neighbors";
    EXPECT_EQ(beyond({"..#", "...", "..."}, {"...", "#..", "..."}), 2) << "the ends of two rows are not neighbors";
    EXPECT_EQ(beyond({"#", ".", ".", "."}, {".", ".", ".", "#"}), 2);
    EXPECT_TRUE(pixel_differences({}, {}, alike).empty());
}

/// By definition, a pixel of either picture differs if no pixel in the other picture's 3 × 3 block is within two levels
/// of it.
TEST(MovedEdges, MatchTheDefinitionInRandomPictures) {
    Random random(seed);
    for (int trial = 0; trial < 300; ++trial) {
        const int width = static_cast<int>(random.number(1, 8)), height = static_cast<int>(random.number(1, 8));
        std::vector<std::string> rows[2];
        for (std::vector<std::string>& picture : rows)
            for (int y = 0; y < height; ++y) {
                picture.emplace_back();
                for (int x = 0; x < width; ++x) picture.back() += "..o159#"[static_cast<int>(random.number(0, 7))];
            }
        const Image pictures[2] = {drawn(rows[0]), drawn(rows[1])};
        const auto level = [&](int which, int x, int y) { return static_cast<int>(pictures[which].row(y)[4 * x]); };
        const auto has_like = [&](int from, int x, int y) {
            for (int v = 0; v < height; ++v)
                for (int u = 0; u < width; ++u)
                    if (std::abs(u - x) <= 1 && std::abs(v - y) <= 1 &&
                        std::abs(level(from, x, y) - level(1 - from, u, v)) <= 2)
                        return true;
            return false;
        };
        const std::vector<std::uint8_t> levels = pixel_differences(pictures[0], pictures[1], alike);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int found = levels[static_cast<std::size_t>(y * width + x)];
                const bool differs = !has_like(0, x, y) || !has_like(1, x, y);
                EXPECT_EQ(found > alike.worst, differs) << "seed " << seed << " trial " << trial;
                if (differs) {
                    EXPECT_EQ(found, std::abs(level(0, x, y) - level(1, x, y)));
                }
            }
    }
}

}  // namespace
}  // namespace viewing
