// Two pictures compared pixel by pixel, on pictures that are drawn here as text, and the parameters of each way of
// mirroring.
#include "frame/planes/mirror_ways.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "unit/geometry/random.h"

namespace viewing {
namespace {

/// A picture of rows of letters: '.' is black, 'o' is grey, '#' is white, and '1' to '9' are so many levels above grey.
struct Drawn {
    glm::ivec2 size_px;
    std::vector<std::uint8_t> bytes;

    explicit Drawn(const std::vector<std::string>& rows)
        : size_px(static_cast<int>(rows.front().size()), static_cast<int>(rows.size())) {
        for (const std::string& row : rows)
            for (const char letter : row) {
                const int level = letter == '.' ? 0 : letter == 'o' ? 100 : letter == '#' ? 255 : 100 + letter - '0';
                bytes.insert(bytes.end(), {static_cast<std::uint8_t>(level), static_cast<std::uint8_t>(level),
                                           static_cast<std::uint8_t>(level), 255});
            }
    }
};

PictureDifference difference(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    const Drawn first(a), second(b);
    EXPECT_EQ(first.size_px, second.size_px);
    return picture_difference(first.bytes, second.bytes, first.size_px);
}

std::int64_t different(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    const PictureDifference found = difference(a, b);
    EXPECT_EQ(difference(b, a).report.different, found.report.different) << "neither picture is favoured";
    return found.report.different;
}

/// Where the drawing marks a difference, as text.
std::vector<std::string> marks(const PictureDifference& found) {
    const DifferenceDrawing& drawing = found.drawing;
    std::vector<std::string> rows(static_cast<std::size_t>(drawing.size_px.y));
    for (std::size_t i = 0; i < drawing.pixels.size(); ++i)
        rows[i / static_cast<std::size_t>(drawing.size_px.x)] += drawing.pixels[i].a == 255 ? 'x' : ' ';
    return rows;
}

TEST(PictureDifference, OfEqualPicturesIsNothing) {
    const std::vector<std::string> rows{"..oo##", "..o1##", ".#.#.#"};
    const PictureDifference found = difference(rows, rows);
    EXPECT_EQ(found.report.different, 0);
    EXPECT_EQ(found.report.worst, 0);
    EXPECT_EQ(found.report.compared, 18);
    EXPECT_EQ(found.drawing.compared, 18);
    EXPECT_EQ(found.drawing.different, 0);
    EXPECT_EQ(found.drawing.size_px, glm::ivec2(6, 3));
    EXPECT_EQ(marks(found), (std::vector<std::string>{"      ", "      ", "      "}));
}

TEST(PictureDifference, BeginsAboveTwoLevels) {
    EXPECT_EQ(different({"oooo", "oooo"}, {"2222", "2222"}), 0);
    const PictureDifference three = difference({"oooo", "oooo"}, {"3333", "3333"});
    EXPECT_EQ(three.report.different, 8);
    EXPECT_EQ(three.report.worst, 3);
}

TEST(PictureDifference, IsTheWorstChannels) {
    for (int channel = 0; channel < 4; ++channel) {
        const Drawn reference({"o"});
        Drawn picture({"o"});
        picture.bytes[static_cast<std::size_t>(channel)] -= 40;
        const PictureDifference found = picture_difference(reference.bytes, picture.bytes, {1, 1});
        EXPECT_EQ(found.report.different, channel < 3 ? 1 : 0) << channel;
        EXPECT_EQ(found.report.worst, channel < 3 ? 40 : 0) << "alpha is nothing that is seen";
    }
}

TEST(PictureDifference, IsNotAnEdgeThatMovedByAPixel) {
    EXPECT_EQ(different({"..####", "..####", "..####"}, {"...###", "...###", "...###"}), 0);
    EXPECT_EQ(different({"......", "######", "######"}, {"......", "......", "######"}), 0);
    EXPECT_EQ(different({"#.....", ".#....", "..#..."}, {".#....", "..#...", "...#.."}), 0) << "a thin line";
    EXPECT_EQ(different({"..####", "..####", "..####"}, {"....##", "....##", "....##"}), 6) << "by two pixels";
}

TEST(PictureDifference, IsABlockThatIsNotThere) {
    const PictureDifference found =
        difference({"......", "......", "......", "......"}, {"......", ".###..", ".###..", "......"});
    EXPECT_EQ(found.report.different, 6);
    EXPECT_EQ(found.report.worst, 255);
    EXPECT_EQ(marks(found), (std::vector<std::string>{"      ", " xxx  ", " xxx  ", "      "})) << "the top row first";
    EXPECT_EQ(found.drawing.different, 6);
}

TEST(PictureDifference, IsAlsoOneLonePixelAndALineThatIsGone) {
    EXPECT_EQ(different({".....", "..#..", "....."}, {".....", ".....", "....."}), 1);
    EXPECT_EQ(different({".....", "#####", "....."}, {".....", ".....", "....."}), 5);
}

TEST(PictureDifference, LooksNowhereBeyondTheEdge) {
    EXPECT_EQ(different({"#"}, {"#"}), 0);
    EXPECT_EQ(different({"#"}, {"."}), 1);
    EXPECT_EQ(different({"#..."}, {"...#"}), 2) << "the ends of a row are no neighbours";
    EXPECT_EQ(different({"..#", "...", "..."}, {"...", "#..", "..."}), 2) << "nor are the ends of two";
    EXPECT_EQ(different({"#", ".", ".", "."}, {".", ".", ".", "#"}), 2);
    EXPECT_EQ(picture_difference({}, {}, {0, 0}).report.compared, 0);
}

/// Against the definition: nothing in the other picture's 3 × 3 block is within two levels, one way or the other.
TEST(PictureDifference, IsAsDefinedInRandomPictures) {
    Random random(seed);
    for (int trial = 0; trial < 300; ++trial) {
        const int width = static_cast<int>(random.number(1, 8)), height = static_cast<int>(random.number(1, 8));
        std::vector<std::string> rows[2];
        for (std::vector<std::string>& picture : rows)
            for (int y = 0; y < height; ++y) {
                picture.emplace_back();
                for (int x = 0; x < width; ++x) picture.back() += "..o159#"[static_cast<int>(random.number(0, 7))];
            }
        const Drawn drawn[2] = {Drawn(rows[0]), Drawn(rows[1])};
        const auto level = [&](int which, int x, int y) {
            return static_cast<int>(drawn[which].bytes[static_cast<std::size_t>(4 * (y * width + x))]);
        };
        const auto has_like = [&](int from, int x, int y) {
            for (int v = 0; v < height; ++v)
                for (int u = 0; u < width; ++u)
                    if (std::abs(u - x) <= 1 && std::abs(v - y) <= 1 &&
                        std::abs(level(from, x, y) - level(1 - from, u, v)) <= 2)
                        return true;
            return false;
        };
        const PictureDifference found = picture_difference(drawn[0].bytes, drawn[1].bytes, {width, height});
        std::int64_t count = 0;
        int worst = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool differs = !has_like(0, x, y) || !has_like(1, x, y);
                const auto index = static_cast<std::size_t>(y * width + x);
                EXPECT_EQ(found.drawing.pixels[index].a == 255, differs) << "seed " << seed << " trial " << trial;
                count += differs ? 1 : 0;
                if (differs) worst = std::max(worst, std::abs(level(0, x, y) - level(1, x, y)));
            }
        EXPECT_EQ(found.report.different, count);
        EXPECT_EQ(found.report.worst, worst);
    }
}

TEST(MirrorWay, SaysHowTheImageIsMadeAndNothingElse) {
    struct Expected {
        MirrorWay way;
        MirrorClip clip;
        MirroredThing mirrored;
    };
    Params odd;
    odd.reflection.clip = MirrorClip::oblique;
    odd.reflection.mirrored = MirroredThing::camera;
    odd.reflection.reflectance = 0.7;
    odd.reflection.same_projection = false;
    odd.reflection.enabled = false;
    odd.lights.front().position.x = 3.5;
    for (const Expected& expected :
         {Expected{MirrorWay::clip_distance, MirrorClip::clip_distance, MirroredThing::scene},
          Expected{MirrorWay::none, MirrorClip::none, MirroredThing::scene},
          Expected{MirrorWay::oblique, MirrorClip::oblique, MirroredThing::scene},
          Expected{MirrorWay::camera, MirrorClip::clip_distance, MirroredThing::camera}}) {
        for (const Params& before : {Params{}, odd}) {
            Params wanted = before;
            wanted.reflection.clip = expected.clip;
            wanted.reflection.mirrored = expected.mirrored;
            EXPECT_EQ(mirrored_in(before, expected.way), wanted) << name_of(expected.way);
        }
    }
    EXPECT_EQ(mirrored_in(Params{}, MirrorWay::clip_distance), Params{}) << "the way that is right by default";
}

TEST(MirrorWay, HasAName) {
    EXPECT_STREQ(name_of(MirrorWay::clip_distance), "clip distance");
    EXPECT_STREQ(name_of(MirrorWay::none), "no clipping");
    EXPECT_STREQ(name_of(MirrorWay::oblique), "oblique near plane");
    EXPECT_STREQ(name_of(MirrorWay::camera), "mirrored camera");
    std::set<std::string> names;
    for (std::size_t way = 0; way < mirror_way_count; ++way) names.insert(name_of(static_cast<MirrorWay>(way)));
    EXPECT_EQ(names.size(), mirror_way_count);
}

}  // namespace
}  // namespace viewing
