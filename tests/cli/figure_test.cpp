// Snapshots of single views: as SVG and PDF, transparent, and for print. Also tests what the program refuses.
#include <gtest/gtest.h>

#include "cli/program.h"
#include "image/png.h"

namespace cli_tests {
namespace {

using Words = std::vector<std::string>;

class Figure : public Program {
protected:
    /// Returns the arguments for a figure, followed by `more`.
    static Words figure(const char* view, const std::string& output, const Words& more = {}) {
        Words words{"snapshot", "--view", view, "--size", "800x500", "-o", output};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    /// Expects that the program refuses the command and writes nothing; returns its message.
    std::string refused(const Words& words) {
        const Ended run = expect(2, words);
        EXPECT_FALSE(std::filesystem::exists(folder() / "no.png"));
        EXPECT_FALSE(std::filesystem::exists(folder() / "no.svg"));
        return run.err;
    }
};

TEST_F(Figure, IsWrittenInTheFormatOfItsName) {
    for (const char* name : {"a.svg", "a.pdf", "a.png", "again.svg", "again.pdf"}) expect(0, figure("matrices", name));
    EXPECT_EQ(read("a.svg").substr(0, 5), "<?xml");
    EXPECT_EQ(read("a.pdf").substr(0, 5), "%PDF-");
    EXPECT_EQ(read("a.svg"), read("again.svg"));
    EXPECT_EQ(read("a.pdf"), read("again.pdf"));
    EXPECT_NE(read("a.svg").find(">Shadow"), std::string::npos);
    EXPECT_NE(read("a.svg").find("@font-face"), std::string::npos);
    // A figure of a GL view contains a picture.
    expect(0, {"snapshot", "--view", "camera", "--size", "96x64", "-o", "camera.svg"});
    EXPECT_NE(read("camera.svg").find("<image"), std::string::npos);
    EXPECT_EQ(read("camera.svg").find("<text"), std::string::npos);
    expect(0, {"snapshot", "--view", "camera", "--labels", "--size", "480x320", "-o", "labelled.svg"});
    EXPECT_NE(read("labelled.svg").find("<text"), std::string::npos);
}

TEST_F(Figure, CarriesItsState) {
    const std::string setting = "light.position=[1,5,2,1]";
    for (const char* name : {"x.svg", "x.pdf", "x.png"}) {
        expect(0, figure("precision", name, {"--set", setting}));
        const std::string state = expect(0, {"state", name}).out;
        EXPECT_EQ(state, expect(0, {"state", "--set", setting, "--set", "view.lower_left=precision"}).out) << name;
    }
    write("none.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
    EXPECT_EQ(
        expect(2, {"state", "none.svg"}).err,
        "none.svg: this picture contains no state; only pictures of one state that this program has written do\n");
    write("broken.pdf", "%PDF-1.5 viewing-sandbox-state-7b22");
    EXPECT_NE(expect(2, {"state", "broken.pdf"}).err.find("broken.pdf"), std::string::npos);
}

/// In JSON, each character of these names takes two bytes, and the state in a picture also has the fields that the file
/// omits.
TEST_F(Figure, AStateTooLongToReadBackIsLeftOutWithAMessage) {
    const std::string quotes(2 * 950, '\\');  // 950 characters, each escaped
    std::string objects;
    for (int i = 0; i < 8000; ++i)
        objects += (i == 0 ? "" : ",") + (R"({"name":")" + quotes + std::to_string(i)) +
                   R"(","shape":"triangle","vertices":[[0,0,0],[1,0,0],[0,1,0]]})";
    write("long.json", R"({"scene":{"objects":[)" + objects + "]}}");
    for (const char* name : {"long.png", "long.svg"}) {
        const Ended run = this->run({"snapshot", "long.json", "--view", "camera", "--size", "32x18", "-o", name});
        EXPECT_EQ(run.status, 0) << run.told();
        EXPECT_EQ(run.err, "the picture does not carry its state, which is longer than 16 MiB\n");
        EXPECT_NE(expect(2, {"state", name}).err.find("contains no state"), std::string::npos);
    }
}

TEST_F(Figure, DrawsOnlyTheMatricesThatTheStateLists) {
    expect(0, figure("matrices", "S.svg", {"--set", R"(view.layout.matrices=["S"])"}));
    EXPECT_NE(read("S.svg").find(">Shadow"), std::string::npos);
    EXPECT_EQ(read("S.svg").find(">Reflection"), std::string::npos);
}

TEST_F(Figure, ViewsThatCannotBeShownAreReported) {
    EXPECT_EQ(refused(figure("tree", "no.png")),
              "the view tree has nothing to show: Only the BSP tree method has a tree to show.\n");
    EXPECT_EQ(refused(figure("pixel", "no.svg")),
              "the view pixel needs a pinned pixel of the camera's picture: set view.pixel=[X,Y]\n");
    EXPECT_NE(refused({"snapshot", "--view", "passes", "--size", "600x300", "-o", "no.svg"}).find("it fits in "),
              std::string::npos);
    EXPECT_NE(refused({"snapshot", "--view", "matrices", "--size", "100x100", "-o", "no.png"}).find("--size"),
              std::string::npos);
    EXPECT_NE(refused({"snapshot", "--view", "camera", "--labels", "--size", "800x450", "--dpi", "300", "-o", "no.png"})
                  .find("at least 1500x844"),
              std::string::npos);
    EXPECT_NE(refused({"snapshot", "--view", "matrices", "--labels", "-o", "no.png"}).find("--labels"),
              std::string::npos);
    EXPECT_NE(refused({"snapshot", "--dpi", "7", "-o", "no.png"}).find("--dpi"), std::string::npos);
    EXPECT_NE(refused({"snapshot", "--repeat", "2", "-o", "no.svg"}).find("--repeat"), std::string::npos);
    EXPECT_NE(refused({"snapshot", "--view", "nothing", "-o", "no.png"}).find("mirror_ways"), std::string::npos);
}

TEST_F(Figure, HasATransparentBackground) {
    using viewing::read_png;
    expect(0, {"snapshot", "--view", "camera", "--size", "96x64", "--transparent", "-o", "cut.png"});
    const auto cut = read_png(folder() / "cut.png");
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->rgba[3], 0);
    expect(0, {"snapshot", "--view", "camera", "--size", "96x64", "-o", "whole.png"});
    EXPECT_EQ(read_png(folder() / "whole.png")->rgba[3], 255);
    expect(0, figure("codes", "cut.svg", {"--transparent"}));
    expect(0, figure("codes", "whole.svg"));
    const std::string ground = "d=\"M0 0L800 0L800 500L0 500Z\"";
    EXPECT_NE(read("whole.svg").find(ground), std::string::npos);
    EXPECT_EQ(read("cut.svg").find(ground), std::string::npos);
}

TEST_F(Figure, StoresItsSizeOnPaper) {
    expect(0, figure("codes", "print.svg", {"--dpi", "200"}));
    EXPECT_NE(read("print.svg").find("width=\"4in\" height=\"2.5in\""), std::string::npos);
    expect(0, figure("codes", "print.pdf", {"--dpi", "200"}));
    EXPECT_NE(read("print.pdf").find("/MediaBox [ 0 0 288 180 ]"), std::string::npos);
    expect(0, figure("codes", "print.png", {"--dpi", "200"}));
    EXPECT_NE(read("print.png").find("pHYs"), std::string::npos);
    expect(0, figure("codes", "screen.png"));
    EXPECT_EQ(read("screen.png").find("pHYs"), std::string::npos);
}

TEST_F(Figure, ASingleViewCanBeSwept) {
    expect(0,
           {"sweep", "--vary", "projection.near=0.1:1:2", "--view", "precision", "--size", "480x320", "-o", "frames"});
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder() / "frames"), {}), 2);
}

}  // namespace
}  // namespace cli_tests
