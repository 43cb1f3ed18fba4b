// Tests `compare` and `snapshot --compare`: profiles, masks, a picture from standard input, and the picture that shows
// the differences.
#include <gtest/gtest.h>

#include <algorithm>

#include "cli/program.h"
#include "image/png.h"

namespace cli_tests {
namespace {

using Words = std::vector<std::string>;
using viewing::Image;

class Comparison : public Program {
protected:
    Words with(Words words, const Words& more) const {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    Words snapshot(const Words& more) const {
        return with({"snapshot", "--view", "camera", "--size", "160x90", "--samples", "0"}, more);
    }
    Image picture(const std::string& name) const { return *viewing::read_png(folder() / name); }
    void write_picture(const std::string& name, const Image& image) const {
        ASSERT_TRUE(viewing::write_png(folder() / name, image));
    }
    /// Returns a black picture with this rectangle in white.
    static Image rectangle(int width, int height, int x, int y, int w, int h) {
        Image image{width, height, {}};
        image.rgba.resize(image.row_bytes() * static_cast<std::size_t>(height));
        for (int v = 0; v < height; ++v)
            for (int u = 0; u < width; ++u) {
                std::uint8_t* const pixel = image.row(v) + static_cast<std::ptrdiff_t>(4) * u;
                const bool is_white = u >= x && u < x + w && v >= y && v < y + h;
                std::fill(pixel, pixel + 4, is_white ? 255 : 0);
                pixel[3] = 255;
            }
        return image;
    }
    int status(const Words& words, const Surroundings& surroundings = {}) const {
        return run(words, surroundings).status;
    }
};

TEST_F(Comparison, TheProfileDecides) {
    expect(0, snapshot({"-o", "a.png"}));
    expect(0, {"snapshot", "--view", "camera", "--size", "160x90", "--samples", "4", "-o", "b.png"});
    const Words compared{"compare", "a.png", "b.png"};
    EXPECT_EQ(status(compared), 1);
    EXPECT_EQ(status(with(compared, {"--profile", "strict"})), 1);
    EXPECT_EQ(status(with(compared, {"--profile", "portable"})), 0);
    EXPECT_EQ(status(with(compared, {"--profile", "portable", "--worst", "0", "--share", "0"})), 1);
    EXPECT_EQ(status(snapshot({"--compare", "b.png"})), 1);
    EXPECT_EQ(status(snapshot({"--compare", "b.png", "--profile", "portable"})), 0);
    const auto report = run(with(compared, {"--profile", "portable", "--worst", "7", "--json", "-"})).json();
    EXPECT_EQ(report.at("profile"), "portable");
    EXPECT_EQ(report.at("thresholds").at("worst"), 7);
    EXPECT_EQ(report.at("thresholds").at("share"), 0.002);
    refused(with(compared, {"--profile", "portabel"}), {"--profile", "portable"});
    refused(snapshot({"-o", "x.png", "--profile", "portable"}), {"--compare"});
}

TEST_F(Comparison, AMaskExcludesPixels) {
    expect(0, snapshot({"-o", "a.png"}));
    Image other = picture("a.png");
    for (int y = 20; y < 30; ++y)
        for (int x = 40; x < 60; ++x) other.row(y)[4 * x] ^= 0x80;
    write_picture("b.png", other);
    write_picture("mask.png", rectangle(160, 90, 40, 20, 20, 10));
    write_picture("small.png", rectangle(80, 90, 40, 20, 20, 10));
    const Words compared{"compare", "a.png", "b.png"};
    const Words drawn = snapshot({"--compare", "b.png"});
    for (const Words& words : {compared, drawn}) {
        EXPECT_EQ(status(words), 1);
        EXPECT_EQ(status(with(words, {"--mask", "40,20,20,10"})), 0);
        EXPECT_EQ(status(with(words, {"--mask", "40,20,20,9"})), 1);
        EXPECT_EQ(status(with(words, {"--mask", "40,20,20,9", "--mask", "0,29,160,61"})), 0);
        EXPECT_EQ(status(with(words, {"--mask", "mask.png"})), 0);
        refused(with(words, {"--mask", "small.png"}), {"small.png", "80 × 90", "160 × 90"});
        refused(with(words, {"--mask", "missing.png"}), {"missing.png"});
        refused(with(words, {"--mask", "40,20,20"}), {"--mask", "X,Y,WIDTH,HEIGHT"});
        refused(with(words, {"--mask", "40,20,20,0"}), {"--mask", "from 1 to 16384"});
        refused(with(words, {"--mask", "mask.png", "--json", "mask.png"}), {"--mask", "--json", "same file"});
    }
    const auto report = run(with(compared, {"--mask", "40,20,20,10", "--json", "-"})).json();
    EXPECT_EQ(report.at("left_out"), 200);
    refused(snapshot({"-o", "x.png", "--mask", "0,0,1,1"}), {"--compare"});
}

/// The depths differ by less than 1/256: the answer says which bits it is about.
TEST_F(Comparison, OfSixteenBitsItSaysWhichOnesCount) {
    for (const char* const x : {"3.9", "3.9003"})
        expect(0, {"snapshot", "--view", "depth", "--size", "40x20", "--set", std::string("camera.position[0]=") + x,
                   "-o", std::string(x) + "z16.png"});
    EXPECT_NE(read("3.9z16.png"), read("3.9003z16.png"));
    const std::string said = expect(0, {"compare", "3.9z16.png", "3.9003z16.png", "--worst", "0"}).out;
    EXPECT_TRUE(has(said, "only the upper 8 bits count")) << said;
    expect(0, {"snapshot", "--view", "camera", "--size", "40x20", "-o", "plain.png"});
    EXPECT_FALSE(has(expect(0, {"compare", "plain.png", "plain.png"}).out, "16-bit"));
}

TEST_F(Comparison, OnePictureMayComeFromStandardInput) {
    expect(0, snapshot({"-o", "a.png"}));
    expect(0, snapshot({"-o", "b.png", "--set", "camera.yaw=20"}));
    const std::string a = read("a.png"), b = read("b.png");
    EXPECT_EQ(status({"compare", "-", "a.png"}, {.input = a}), 0);
    EXPECT_EQ(status({"compare", "a.png", "-"}, {.input = a}), 0);
    EXPECT_EQ(status({"compare", "-", "a.png"}, {.input = b}), 1);
    const auto by_pipe = run({"compare", "-", "a.png", "-o", "-"}, {.input = b}).out;
    run({"compare", "b.png", "a.png", "-o", "difference.png"});
    EXPECT_EQ(by_pipe, read("difference.png"));
    refused({"compare", "-", "-"}, {"standard input"}, {.input = a});
    refused({"compare", "-", "a.png"}, {"standard input", "not a PNG"}, {.input = ""});
    refused({"compare", "a.png", "-"}, {"standard input", "cut off"}, {.input = a.substr(0, a.size() / 2)});
    expect(8, {"compare", "a.png", "-", "--timeout", "0.2"}, {.input_stays_open = true});
}

TEST_F(Comparison, SnapshotWritesTheDifferencesInTheSameRun) {
    expect(0, snapshot({"-o", "a.png"}));
    const Words moved{"--set", "camera.yaw=20"};
    const Words comparing{"--compare", "a.png", "--mask", "0,0,20,20", "--worst", "9"};
    run(with(snapshot(with(comparing, moved)), {"-o", "b.png", "--diff", "difference.png"}));
    run({"compare", "b.png", "a.png", "--mask", "0,0,20,20", "--worst", "9", "-o", "expected.png"});
    EXPECT_EQ(read("difference.png"), read("expected.png"));
    EXPECT_EQ(run(snapshot(with(with(comparing, moved), {"--diff", "-"}))).out, read("expected.png"));
    EXPECT_EQ(status(snapshot({"--compare", "a.png", "--diff", "equal.png"})), 0);
    EXPECT_TRUE(exists("equal.png"));
    EXPECT_EQ(status(snapshot({"--compare", "missing.png", "--diff", "none.png", "-o", "c.png"})), 6);
    EXPECT_TRUE(exists("c.png") && !exists("none.png"));
    refused(snapshot({"-o", "x.png", "--diff", "y.png"}), {"--diff", "--compare"});
    refused(snapshot({"--compare", "a.png", "--diff", "y.jpg"}), {"--diff", ".png"});
    refused(snapshot({"--compare", "a.png", "--diff", "a.png"}), {"--diff", "--compare", "same file"});
    refused(snapshot({"--compare", "a.png", "--diff", "x.png", "-o", "x.png"}), {"--diff", "-o", "same file"});
}

}  // namespace
}  // namespace cli_tests
