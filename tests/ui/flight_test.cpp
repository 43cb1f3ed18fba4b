// Flights in the window: F9 and the menu record a flight, opening its file plays it, and Escape or any edit ends the
// playback.
#include <filesystem>

#include "desk.h"
#include "platform/file.h"
#include "unit/state/scratch_folder.h"

namespace viewing::test {
namespace {

namespace fs = std::filesystem;

/// Works in its own folder, where flights are written.
class FlightTest : public testing::ScratchFolder {
protected:
    FlightTest() { fs::current_path(folder_); }
    ~FlightTest() override { fs::current_path(start_); }
    void fly() {
        desk.hold(Key::w);
        ui.frames(20);
        desk.let_go(Key::w);
        desk.settle();
    }
    std::vector<fs::path> flights() const { return files_in(folder_, ".json"); }
    /// Returns the flight from the only file that was written.
    Flight written() {
        desk.session.finish_loading();
        ui.frame();
        EXPECT_EQ(flights().size(), 1U);
        const Result<LoadedState> loaded = load_state(flights().front().string());
        EXPECT_TRUE(loaded && loaded->flight) << (loaded ? "no flight" : loaded.error());
        return *loaded->flight;
    }
    std::string sign() const {
        for (const RecordedItem& item : desk.recorded())
            if (item.label.find("REC") != std::string::npos) return item.label;
        return "";
    }

    fs::path start_ = fs::current_path();
    Desk desk;
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;
};

TEST_F(FlightTest, F9RecordsTheShownStatesWithTheirTimes) {
    const Params before = params;
    desk.press(Key::f9);
    ASSERT_TRUE(desk.workbench.recorder.is_recording());
    fly();
    const Params flown = params;
    params.planes[0].equation.w = 0.25;
    params.projection.near = 0.7;
    ui.frames(2);
    desk.press(Key::f9);
    EXPECT_FALSE(desk.workbench.recorder.is_recording());
    const Flight flight = written();
    EXPECT_NE(desk.session.message.text.find("written to"), std::string::npos) << desk.session.message.text;
    EXPECT_FALSE(desk.session.message.is_error);
    EXPECT_EQ(flight.start, before);
    EXPECT_GT(flight.frames.size(), 20U);
    EXPECT_GT(flight.seconds, 0.3);
    FlightWalk walk(std::make_shared<const Flight>(flight));
    EXPECT_EQ(*walk.at(flight.frames.size()), params);
    EXPECT_EQ(*walk.at(flight.frames.size() - 1), flown) << "camera, plane and near: every change is recorded";
    for (std::size_t i = 0; i + 1 < flight.frames.size(); ++i)
        for (const std::string& setting : flight.frames[i].settings) EXPECT_TRUE(setting.starts_with("camera."));
}

TEST_F(FlightTest, TheMenuAlsoRecordsIncludingPresetsAndUndo) {
    desk.choose("top/File", "top/Record a flight");
    desk.session.open("walkthrough");
    desk.settle();
    const Params walkthrough = params;
    desk.undo();
    ui.frames(2);
    const Params after = params;
    desk.choose("top/File", "top/Stop recording");
    const Flight flight = written();
    FlightWalk walk(std::make_shared<const Flight>(flight));
    bool was_there = false;
    for (std::size_t i = 0; i < flight.picture_count(); ++i) was_there |= *walk.at(i) == walkthrough;
    EXPECT_TRUE(was_there);
    EXPECT_EQ(*walk.at(flight.frames.size()), after);
}

TEST_F(FlightTest, ShowsThatItIsRecording) {
    EXPECT_EQ(sign(), "");
    for (const ImVec2 size : {ImVec2{1600, 900}, ImVec2{800, 600}})
        for (const Theme theme : {Theme::dark, Theme::projector}) {
            params.ui.theme = theme;
            ImGui::GetIO().DisplaySize = size;
            desk.apply_looks();
            ui.frames(3);
            desk.press(Key::f9);
            ui.frames(40);
            ASSERT_EQ(sign(), "● REC 00:00");
            const RecordedItem item = ui.find(sign());
            const Rect bar = desk.layout().status_bar;
            EXPECT_GE(item.min.x, bar.min.x);
            EXPECT_LE(item.max.x, bar.max.x);
            EXPECT_LE(item.max.y, bar.max.y + 1.0F);
            for (int i = 0; i < 65; ++i) ui.frame(1.0F);
            EXPECT_EQ(sign().substr(0, 11), "● REC 01:");
            desk.press(Key::f9);
            desk.session.finish_loading();
            EXPECT_EQ(sign(), "");
        }
}

TEST_F(FlightTest, TwoFlightsThatEndInOneSecondAreTwoFiles) {
    for (int i = 0; i < 2; ++i) {
        desk.press(Key::f9);
        ui.frames(2);
        desk.press(Key::f9);
        desk.session.finish_loading();
    }
    EXPECT_EQ(flights().size(), 2U);
}

class ReplayTest : public FlightTest {
protected:
    /// Records a flight, undoes it and opens its file.
    void open_a_flight() {
        before = params;
        desk.press(Key::f9);
        fly();
        desk.press(Key::f9);
        flown = params;
        flight = written();
        desk.undo();
        EXPECT_EQ(params, before);
        params.shadow.opacity = 0.125;
        desk.settle();
        before = params;
        desk.input.dropped_files = {flights().front()};
        ui.frame();
        desk.session.finish_loading();
    }
    void play() {
        for (int i = 0; i < 2000 && desk.workbench.replay.is_playing(); ++i) ui.frame();
        ui.frames(2);
    }

    Params before, flown;
    Flight flight;
};

TEST_F(ReplayTest, PlaysADroppedFlightOnceAndUndoRestoresTheState) {
    open_a_flight();
    ui.frame();
    ASSERT_TRUE(desk.workbench.replay.is_playing()) << desk.session.message.text;
    std::vector<Params> shown;
    for (int i = 0; i < 2000 && desk.workbench.replay.is_playing(); ++i) {
        if (shown.empty() || shown.back() != params) shown.push_back(params);
        ui.frame();
    }
    EXPECT_GT(shown.size(), flight.frames.size() / 2);
    EXPECT_EQ(params, flown);
    FlightWalk walk(std::make_shared<const Flight>(flight));
    std::vector<Params> recorded;
    for (std::size_t i = 0; i < flight.picture_count(); ++i) recorded.push_back(*walk.at(i));
    for (const Params& one : shown) EXPECT_NE(std::ranges::find(recorded, one), recorded.end());
    ui.frames(3);
    desk.undo();
    EXPECT_EQ(params, before);
    desk.redo();
    EXPECT_EQ(params, flown);
}

TEST_F(ReplayTest, EscapeEndsIt) {
    open_a_flight();
    ui.frames(5);
    ASSERT_TRUE(desk.workbench.replay.is_playing());
    desk.press(Key::escape);
    EXPECT_FALSE(desk.workbench.replay.is_playing());
    const Params stopped = params;
    EXPECT_NE(stopped, flown);
    ui.frames(30);
    EXPECT_EQ(params, stopped);
    desk.undo();
    EXPECT_EQ(params, before);
}

TEST_F(ReplayTest, FlyingEndsItAndContinuesFromThere) {
    open_a_flight();
    ui.frames(5);
    ASSERT_TRUE(desk.workbench.replay.is_playing());
    const double yaw = params.camera.yaw;
    desk.hold(Key::left);
    ui.frames(3);
    desk.let_go(Key::left);
    desk.settle();
    EXPECT_FALSE(desk.workbench.replay.is_playing());
    EXPECT_GT(params.camera.yaw, yaw);
}

TEST_F(ReplayTest, APastedFlightAlsoPlays) {
    open_a_flight();
    play();
    desk.undo();
    desk.clipboard = write_flight(flight);
    desk.press_with(Key::ctrl, Key::v);
    play();
    EXPECT_EQ(params, flown);
}

}  // namespace
}  // namespace viewing::test
