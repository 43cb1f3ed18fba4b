// The step bar under real input: its buttons, its track and its number, and playing when frames take unequal times.
#include <cmath>
#include <random>

#include "widget_test.h"
#include "widgets/diagrams.h"

namespace widgets::test {
namespace {

class StepBarTest : public WidgetTest {
protected:
    int step = -1, count = 12;
    StepPlayer player{.steps_per_s = 10.0F};
    double dt_s = 0.0;

    void start_bar() {
        start([this] { return StepBar("steps", step, count, player, dt_s); });
    }
    void wheel(float notches) {
        ImGui::GetIO().MouseWheel = notches;
        ui.frame();
        ui.frame();
    }
};

TEST_F(StepBarTest, Buttons) {
    start_bar();
    EXPECT_EQ(ui.text_of("steps/text"), "all 12 steps");
    EXPECT_FALSE(ui.find("steps/All").enabled);
    EXPECT_FALSE(ui.find("steps/Forward").enabled);
    ui.click("steps/Back");
    EXPECT_EQ(step, 11);
    EXPECT_EQ(ui.text_of("steps/text"), "step 11 of 12");
    ui.click("steps/Forward");
    EXPECT_EQ(step, 12);
    ui.click("steps/First");
    EXPECT_EQ(step, 0);
    EXPECT_FALSE(ui.find("steps/Back").enabled);
    ui.click("steps/Forward");
    EXPECT_EQ(step, 1);
    ui.click("steps/All");
    EXPECT_EQ(step, -1);
    EXPECT_EQ(changes, 5);
    ui.frames(10);
    EXPECT_EQ(changes, 5);
}

TEST_F(StepBarTest, WithoutRoomForWordsItShowsOnlyNumbers) {
    float wide = 0.0F;
    for (const float width : {400.0F, 230.0F}) {
        start([&] {
            ImGui::BeginChild("narrow", ImVec2(width, 100));
            StepBar("steps", step, count, player, dt_s);
            ImGui::EndChild();
            return false;
        });
        const RecordedItem text = ui.find("steps/text");
        EXPECT_LE(text.max.x, ui.find("steps/First").min.x + width);
        if (wide > 0.0F) {
            EXPECT_LT(text.max.x - text.min.x, wide);
        }
        wide = text.max.x - text.min.x;
    }
}

TEST_F(StepBarTest, HeldButtonsRepeat) {
    count = 1000;
    step = 0;
    start_bar();
    ui.hover("steps/Forward");
    ui.press();
    for (int i = 0; i < 120; ++i) ui.frame();
    ui.release();
    EXPECT_GT(step, 10);
    const int reached = step;
    ui.frames(30);
    EXPECT_EQ(step, reached);
}

TEST_F(StepBarTest, TheTrackIsLinearAndPrecise) {
    start_bar();
    for (int wanted = 0; wanted <= count; ++wanted) {
        const RecordedItem track = ui.find("steps/track");
        const float begin = track.min.x + 8.0F, end = track.max.x - 8.0F;
        ui.frame(1.0F);
        ui.move_to(ImVec2(begin + (end - begin) * static_cast<float>(wanted) / static_cast<float>(count),
                          0.5F * (track.min.y + track.max.y)));
        ui.press();
        ui.release();
        EXPECT_EQ(step < 0 ? count : step, wanted);
    }
    ui.drag("steps/track", -5000);
    EXPECT_EQ(step, 0);
    count = 100'000;
    ui.drag("steps/track", 5000);
    EXPECT_EQ(step, 100'000);
}

TEST_F(StepBarTest, TheWheelStepsWithoutScrolling) {
    step = 5;
    float scrolled = 0.0F;
    start([&] {
        ImGui::BeginChild("panel", ImVec2(580, 200));
        const bool changed = StepBar("steps", step, count, player, 0.0);
        ImGui::Dummy(ImVec2(10, 2000));
        scrolled = ImGui::GetScrollY();
        ImGui::EndChild();
        return changed;
    });
    ui.hover("steps/track");
    wheel(1.0F);
    EXPECT_EQ(step, 6);
    wheel(-1.0F);
    wheel(-1.0F);
    EXPECT_EQ(step, 4);
    for (int i = 0; i < 9; ++i) wheel(-1.0F);
    EXPECT_EQ(step, 0);
    EXPECT_EQ(scrolled, 0.0F);
}

TEST_F(StepBarTest, TheNumberCanBeTypedThereOrByCtrlClickOnTheTrack) {
    count = 340;
    start_bar();
    ui.double_click("steps/step");
    ui.type("17");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(step, 17);
    EXPECT_EQ(ui.text_of("steps/text"), "step 17 of 340");
    ui.ctrl_click("steps/track");
    EXPECT_EQ(step, 17) << "a Ctrl-click does not jump";
    ui.type("9999");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(step, 340);
    EXPECT_EQ(changes, 2);
}

TEST_F(StepBarTest, PlaysExactStepsOverUnevenFrames) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> frame_s(0.0, 0.05);
    count = 1000;
    step = 0;
    start_bar();
    player.steps_per_s = 37.5F;
    player.playing = true;
    double played_s = 0.0;
    while (player.playing && played_s < 100.0) {
        dt_s = frame_s(random);
        played_s += dt_s;
        ui.frame();
        const double due = std::min(played_s * 37.5, 1000.0);
        ASSERT_NEAR(step + (player.playing ? player.carry_steps : 0.0), due, 1e-6);
        ASSERT_LE(step, due + 1e-6);
    }
    EXPECT_EQ(step, 1000);
    EXPECT_FALSE(player.playing) << "stops at the end";
    EXPECT_NEAR(played_s, 1000.0 / 37.5, 0.05);
    dt_s = 1.0;
    ui.frames(5);
    EXPECT_EQ(step, 1000);
}

TEST_F(StepBarTest, FramesThatAddUpToWholeStepsPlayThem) {
    count = 100;
    step = 0;
    start_bar();
    player.playing = true;
    dt_s = 0.01;  // ten of these make a step of 0.1 s, though neither is exact in binary
    ui.frames(300);
    EXPECT_EQ(step, 30);
}

TEST_F(StepBarTest, PlayRestartsAtTheEndAndAnyInputStopsIt) {
    start_bar();
    ui.click("steps/Play");
    EXPECT_TRUE(player.playing);
    EXPECT_EQ(step, 0);
    dt_s = 0.35;
    ui.frame();
    EXPECT_EQ(step, 3);
    dt_s = 0.0;
    ui.click("steps/Pause");
    EXPECT_FALSE(player.playing);
    EXPECT_EQ(step, 3);
    ui.click("steps/Play");
    ui.click("steps/Back");
    EXPECT_FALSE(player.playing);
    EXPECT_EQ(step, 2);
    step = -1;
    player.playing = true;  // as a key would
    ui.frame();
    EXPECT_EQ(step, 0);
    dt_s = 1e9;
    ui.frame();
    EXPECT_EQ(step, 12);
    EXPECT_FALSE(player.playing);
}

TEST_F(StepBarTest, RequestsTheFrameOfTheNextStep) {
    step = 0;
    start_bar();
    EXPECT_LT(RedrawIn(context), 0.0F) << "no frame is due at rest";
    player.playing = true;
    ui.frame();
    EXPECT_NEAR(RedrawIn(context), 0.1F, 1e-4F);
}

TEST_F(StepBarTest, AHeldButtonRepeatsWithoutMovement) {
    step = 0;
    start_bar();
    const RecordedItem forward = ui.find("steps/Forward");
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(0.5F * (forward.min.x + forward.max.x), 0.5F * (forward.min.y + forward.max.y));
    ui.frame();
    io.MouseDown[0] = true;
    ui.frame();
    for (double held_s = 0.0; held_s < 0.6;) {  // as in a window that draws only on request
        const float in_s = RedrawIn(context);
        ASSERT_GE(in_s, 0.0F) << "asleep after " << held_s << " s";
        held_s += std::max(static_cast<double>(in_s), 0.01);
        ui.frame(std::max(in_s, 0.01F));
    }
    EXPECT_GE(step, 4);
    io.MouseDown[0] = false;
    ui.frame();
    EXPECT_LT(RedrawIn(context), 1.0F);
}

TEST_F(StepBarTest, WithoutStepsItIsDisabledAndSaysWhy) {
    for (const int none : {0, -5}) {
        count = none;
        step = -1;
        player.playing = true;
        dt_s = 1.0;
        start_bar();
        EXPECT_FALSE(player.playing);
        EXPECT_EQ(step, -1);
        for (const char* name : {"First", "Back", "Play", "Forward", "All", "track"}) {
            EXPECT_FALSE(ui.find("steps/" + std::string(name)).enabled) << name;
            ui.click("steps/" + std::string(name));
        }
        EXPECT_EQ(step, -1);
        ui.hover("steps/Play");
        ui.frames(60);
        EXPECT_EQ(ui.text_of("steps/tooltip"), "\nNo steps to go through.");
    }
    EXPECT_EQ(changes, 0);
}

TEST_F(StepBarTest, AStepPastTheEndIsShownAsTheEndAndKept) {
    step = 50;
    start_bar();
    EXPECT_EQ(ui.text_of("steps/text"), "step 12 of 12");
    EXPECT_EQ(step, 50);
    player.steps_per_s = NAN;
    player.playing = true;
    dt_s = 1.0;
    ui.frames(3);
    EXPECT_TRUE(std::isfinite(player.carry_steps));
    EXPECT_GE(step, 0);
    EXPECT_LE(step, 12);
}

TEST_F(StepBarTest, TheSpeedIsALogarithmicSlider) {
    start_bar();
    ui.double_click("steps/speed");
    ui.type("250");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(player.steps_per_s, 250.0F);
    EXPECT_EQ(changes, 0) << "no step changed";
    ui.drag("steps/speed", 500);
    EXPECT_EQ(player.steps_per_s, 5000.0F);
}

}  // namespace
}  // namespace widgets::test
