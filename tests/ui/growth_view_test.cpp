// The growth of costs is measured in the background. The user can watch and cancel the measurement; its results are
// shown and written to files.
#include <chrono>
#include <fstream>
#include <set>
#include <thread>

#include "hidden_desk.h"

namespace viewing::test {
namespace {

class GrowthView : public HiddenViews {
protected:
    GrowthView() { show(Topic::growth, VisibilityMethod::depth_buffer); }

    std::vector<GrowthRow>& rows() { return hidden().growth.rows[static_cast<std::size_t>(hidden().growth.scene)]; }
    void wait_until_measured() {
        for (int i = 0; i < 6000 && hidden().growth.measuring.is_running(); ++i) {
            ui.frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        ASSERT_FALSE(hidden().growth.measuring.is_running());
        ui.frames(2);
    }
    void measure_current_scene() {
        hidden().growth.scene = static_cast<int>(GrowthScene::own_polygons);
        ui.frames(2);
        ui.click("lower/Measure");
        wait_until_measured();
    }
    static std::string content(const std::filesystem::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
};

TEST_F(GrowthView, EveryMethodIsMeasuredAndReported) {
    EXPECT_TRUE(says("Measures every method"));
    EXPECT_FALSE(ui.find("lower/Save CSV").enabled);
    measure_current_scene();
    std::set<GrowthMethod> methods;
    for (const GrowthRow& row : rows()) methods.insert(row.method);
    EXPECT_EQ(methods.size(), growth_method_count);
    EXPECT_TRUE(says(say(growth_summary(rows()))));
    EXPECT_TRUE(ui.has("lower/chart/marker"));
    EXPECT_TRUE(ui.find("lower/Save CSV").enabled);
    ui.click("lower/operations");
    EXPECT_TRUE(hidden().growth.shows_operations);

    // Each kind of scene keeps its own rows. The rows for the state's scene disappear when that scene changes.
    hidden().growth.scene = static_cast<int>(GrowthScene::small_triangles);
    ui.frames(2);
    EXPECT_TRUE(says("Measures every method"));
    hidden().growth.scene = static_cast<int>(GrowthScene::own_polygons);
    params.scene = session_of("opening").params.scene;
    desk.settle();
    EXPECT_TRUE(rows().empty());
}

/// On stage there are no buttons: counting starts by itself, only once, and shows operation counts, which are the same
/// on all machines.
TEST_F(GrowthView, OnStageItMeasuresByItself) {
    HiddenStatus status;
    status.shows_time = true;
    begin_hidden_frame(hidden(), desk.session, status);
    EXPECT_FALSE(hidden().growth.measuring.is_running()) << "the window does not start it";
    desk.press(Key::f5);
    ui.frames(3);
    ASSERT_TRUE(desk.workbench.widgets.is_on_stage);
    EXPECT_FALSE(hidden().growth.measuring.is_running()) << "not for a picture that must be reproducible";
    begin_hidden_frame(hidden(), desk.session, status);
    EXPECT_TRUE(hidden().growth.measuring.is_running());
    EXPECT_TRUE(hidden().growth.shows_operations);
    hidden().growth.measuring.cancel();
    wait_until_measured();
    begin_hidden_frame(hidden(), desk.session, status);
    EXPECT_FALSE(hidden().growth.measuring.is_running()) << "a canceled measurement does not restart";
}

TEST_F(GrowthView, MeasuringShowsProgressAndCanBeCanceled) {
    ui.click("lower/Measure");
    EXPECT_TRUE(hidden().growth.measuring.is_running());
    EXPECT_TRUE(hidden().is_busy());
    EXPECT_TRUE(ui.has("lower/progress"));
    for (int i = 0; i < 2000 && rows().empty(); ++i) {
        ui.frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_FALSE(rows().empty()) << "rows appear during the measurement";
    // Rows are collected no matter which view is shown.
    ui.click("lower/Cancel");
    desk.params().view.lower_right = Topic::depth;
    wait_until_measured();
    EXPECT_FALSE(hidden().is_busy());
    EXPECT_FALSE(rows().empty());
    EXPECT_LT(rows().back().polygons, 100'000);
}

TEST_F(GrowthView, TheNextFrameShowsTheResult) {
    hidden().growth.scene = static_cast<int>(GrowthScene::own_polygons);
    ui.frames(2);
    ui.click("lower/Measure");
    hidden().growth.measuring.wait(-1.0);
    ui.frame();
    EXPECT_FALSE(ui.has("lower/progress")) << "otherwise a sleeping window would never show the result";
    EXPECT_TRUE(ui.find("lower/Save CSV").enabled);
}

TEST_F(GrowthView, FailuresAreReportedInASentence) {
    hidden().growth.log = std::make_shared<BackgroundLog<GrowthRow>>();
    hidden().growth.measuring.start([](WorkProgress&) -> std::vector<GrowthRow> { throw std::bad_alloc(); });
    hidden().growth.measuring.wait(-1.0);
    ui.frame();
    EXPECT_TRUE(desk.session.message.is_error);
    EXPECT_FALSE(hidden().is_busy());
    EXPECT_TRUE(ui.has("lower/Measure"));
}

TEST_F(GrowthView, RowsAreWrittenToAnUnusedFileName) {
    const TemporaryFolder folder;
    measure_current_scene();
    ui.click("lower/Save CSV");
    desk.settle();
    EXPECT_EQ(content("viewing-growth.csv"), growth_csv(rows()));
    EXPECT_NE(desk.session.message.text.find((folder.path / "viewing-growth.csv").string()), std::string::npos);
    EXPECT_FALSE(desk.session.message.is_error);
    std::ofstream("viewing-growth.csv") << "mine";
    ui.click("lower/Save CSV");
    desk.settle();
    EXPECT_EQ(content("viewing-growth.csv"), "mine");
    EXPECT_EQ(content("viewing-growth-2.csv"), growth_csv(rows()));
}

TEST_F(GrowthView, WriteFailuresAreReportedAsErrors) {
    const TemporaryFolder folder;
    measure_current_scene();
    std::filesystem::create_directory("gone");
    std::filesystem::current_path("gone");
    std::filesystem::remove(folder.path / "gone");
    ui.click("lower/Save CSV");
    desk.settle();
    EXPECT_TRUE(desk.session.message.is_error) << desk.session.message.text;
    std::filesystem::current_path(folder.path);
}

TEST_F(GrowthView, ThePictureOfTheChartIsRequestedOnce) {
    const TemporaryFolder folder;
    measure_current_scene();
    const Rect scrolled = desk.layout().lower_right;
    ui.move_to({scrolled.min.x + 60.0F, scrolled.max.y - 20.0F});
    ImGui::GetIO().MouseWheel = -1.0F;
    ui.frame();
    ImGui::GetIO().MouseWheel = 0.0F;
    ui.hover("lower/Save PNG");
    ui.press();
    ui.release();
    ui.frame();
    ASSERT_TRUE(desk.requests.view_picture);
    EXPECT_EQ(desk.requests.view_picture->file, folder.path / "viewing-growth.png");
    const Rect picture = desk.requests.view_picture->rect, view = desk.layout().lower_right;
    EXPECT_GE(picture.min.x, view.min.x);
    EXPECT_GE(picture.min.y, view.min.y);
    EXPECT_LE(picture.max.x, view.max.x);
    EXPECT_LE(picture.max.y, view.max.y);
    EXPECT_GT(picture.height(), 80.0F);
    const RecordedItem marker = ui.find("lower/chart/marker");
    EXPECT_TRUE(picture.contains(marker.min));
    ui.frame();
    EXPECT_FALSE(desk.requests.view_picture);
}

}  // namespace
}  // namespace viewing::test
