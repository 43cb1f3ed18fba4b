// Common mistakes on screen: where a wrong V puts the eye in the observer's view, the mistakes in the matrix R and in
// the lecture's code for it, display() in its own view, and a depth picture without a depth buffer.
#include "desk.h"
#include "letters.h"

namespace viewing::test {
namespace {

class MistakesOnScreenTest : public UiTest {
protected:
    /// Returns whether a text is drawn anywhere.
    bool is_drawn(const std::string& text) {
        ui.frames(2);
        const widgets::Fonts& fonts = desk.workbench.widgets.fonts;
        const Page page{fonts.text, fonts.heading, fonts.note, fonts.number, fonts.small_number};
        const ImDrawData* data = ImGui::GetDrawData();
        for (int i = 0; i < data->CmdListsCount; ++i)
            for (const Line& line : lines_of(page.letters(*data->CmdLists[i])))
                if (line.text.find(text) != std::string::npos) return true;
        return false;
    }
};

TEST_F(MistakesOnScreenTest, TheObserverShowsWhereVPutsTheEye) {
    const char* const label = "V puts the eye here";
    EXPECT_FALSE(is_drawn(label)) << "the eye is where the camera is";
    params.camera.position = {0.0, 0.9, 3.0};
    params.camera.yaw = 40.0;
    for (bool SlipParams::*slip : {&SlipParams::swapped_order, &SlipParams::camera_as_view}) {
        params.slips = {};
        params.slips.*slip = true;
        EXPECT_TRUE(is_drawn(label));
    }
    // Without a rotation there is nothing to swap.
    params.slips = {};
    params.slips.swapped_order = true;
    params.camera.yaw = params.camera.pitch = params.camera.roll = 0.0;
    EXPECT_FALSE(is_drawn(label));
}

TEST_F(MistakesOnScreenTest, RShowsItsMistakesInTheMatrixAndInTheCode) {
    params.planes.front().equation = {0.3, 1.0, 0.15, 0.5};
    params.view.lower_left = Topic::lecture_code;
    desk.settle();
    const std::string right = ui.text_of("matrices/R/r1c0");
    ASSERT_TRUE(right.starts_with("−"));
    params.slips.plus_2ab = true;
    desk.settle();
    EXPECT_EQ("−" + ui.text_of("matrices/R/r1c0"), right);
    EXPECT_NE(ui.text_of("left/code/trouble").find("lost its minus"), std::string::npos);
}

TEST_F(MistakesOnScreenTest, DisplayHasItsOwnViewAndFillsIt) {
    params.view.lower_left = Topic::display_code;
    desk.settle();
    const auto height = [&] { return ui.find("left/void display() {").max.y - ui.find("left/void display() {").min.y; };
    const float small = height();
    params.view.layout.big = ViewName::lower_left;
    desk.settle();
    EXPECT_GT(height(), 1.5F * small);
    const Rect view = desk.layout().lower_left;
    EXPECT_LE(ui.find("left/}").max.y, view.max.y);
    EXPECT_GT(ui.find("left/}").max.y, view.min.y + 0.38F * view.height());
}

TEST_F(MistakesOnScreenTest, ADepthPictureSaysThatThereIsNoBuffer) {
    const char* const words = "No depth to show: the window has no depth buffer.";
    EXPECT_FALSE(is_drawn(words));
    params.depth.buffer = false;
    EXPECT_TRUE(is_drawn(words));
}

}  // namespace
}  // namespace viewing::test
