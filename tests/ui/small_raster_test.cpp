// A method at work in a small raster: a click selects the pixel under the pointer at any size and scale, a click on a
// row goes to its step, and both levels of steps lead to the right place.
#include <algorithm>

#include "hidden_desk.h"
#include "topics/hidden/numbers/step_groups.h"

namespace viewing::test {
namespace {

class SmallRaster : public ::testing::Test {
protected:
    /// Returns the center of a pixel's square in the window; the squares are as large as the view allows.
    static ImVec2 square(const Desk& desk, glm::ivec2 pixel, glm::ivec2 raster) {
        const Rect view = desk.layout().camera;
        const float side =
            std::min(view.width() / static_cast<float>(raster.x), view.height() / static_cast<float>(raster.y));
        const glm::vec2 from_middle = (glm::vec2(pixel) + 0.5F - 0.5F * glm::vec2(raster)) * side;
        return {0.5F * (view.min.x + view.max.x) + from_middle.x, 0.5F * (view.min.y + view.max.y) + from_middle.y};
    }
};

TEST_F(SmallRaster, AClickChoosesThePixelUnderThePointerAtAnySizeAndScale) {
    struct Case {
        ImVec2 size;
        double scale;
        glm::ivec2 raster;
    };
    for (const Case& each : {Case{{1600, 900}, 1.0, {24, 16}}, Case{{800, 600}, 1.0, {24, 16}},
                             Case{{1600, 900}, 1.0, {7, 40}}, Case{{1920, 1200}, 2.0, {24, 16}}}) {
        SCOPED_TRACE(std::to_string(each.size.x) + " " + std::to_string(each.raster.x));
        Desk desk(each.size, "z-buffer-small");
        desk.params().ui.scale = each.scale;
        desk.params().visibility.raster = each.raster;
        desk.params().visibility.pixel.reset();
        desk.apply_looks();
        desk.settle();
        for (const glm::ivec2 pixel :
             {glm::ivec2(0, 0), each.raster - 1, each.raster / 2, glm::ivec2(each.raster.x / 3, each.raster.y - 2)}) {
            desk.click_at(square(desk, pixel, each.raster));
            desk.settle();
            EXPECT_EQ(desk.params().visibility.pixel, pixel);
        }
        const glm::ivec2 last = *desk.params().visibility.pixel;
        desk.click_at(square(desk, last, each.raster));
        EXPECT_FALSE(desk.params().visibility.pixel) << "a second click deselects it";
        EXPECT_FALSE(desk.params().follow);
    }
}

TEST_F(SmallRaster, ForRaysAClickShowsTheRayOrGoesToIt) {
    Desk desk({1600, 900}, "rays-small");
    desk.settle();
    desk.click_at(square(desk, {5, 3}, {24, 16}));
    desk.settle();
    EXPECT_EQ(desk.params().visibility.step, -1) << "the picture stays complete";
    ASSERT_TRUE(desk.answer()->camera->traced);
    EXPECT_EQ(desk.answer()->camera->traced->pixel, glm::ivec2(5, 3));
    desk.params().visibility.step = 7;
    desk.settle();
    desk.click_at(square(desk, {9, 8}, {24, 16}));
    desk.settle();
    EXPECT_EQ(desk.params().visibility.step, 8 * 24 + 9 + 1);
    EXPECT_EQ(desk.answer()->camera->traced->pixel, glm::ivec2(9, 8));
}

class SmallZBuffer : public HiddenViews {
protected:
    SmallZBuffer() : HiddenViews("z-buffer-small", {1600, 1200}) { desk.settle(); }

    std::string row_of(std::size_t touch) const {
        const RasterStep& fragment = result().touches[touch].fragment;
        const int object = (*result().fragments)[static_cast<std::size_t>(fragment.polygon)].object;
        return std::to_string(touch + 1) + " " +
               desk.session.scene().objects[static_cast<std::size_t>(object)].description.name;
    }
    /// Clicks the first row that starts with this text. The pixel's fragments are listed before the drawing order.
    void click_row(const std::string& start) {
        for (const RecordedItem& item : desk.recorded())
            if (item.label.starts_with("left/" + start)) {
                desk.click_at({item.min.x + 8.0F, 0.5F * (item.min.y + item.max.y)});
                return desk.settle();
            }
        FAIL() << start;
    }
};

TEST_F(SmallZBuffer, ClickingAFragmentRowGoesToItsStep) {
    ASSERT_GT(result().touches.size(), 2U);
    for (std::size_t touch = 0; touch < result().touches.size(); ++touch) {
        const int step = result().touches[touch].step;
        click_row(row_of(touch));
        EXPECT_EQ(params.visibility.step, step);
        EXPECT_EQ(glm::ivec2(result().compare->x, result().compare->y), *params.visibility.pixel);
    }
}

TEST_F(SmallZBuffer, ClickingARowOfTheOrderGoesToTheStepOfItsTriangle) {
    params.visibility.pixel.reset();
    desk.settle();
    click_row("2 ");
    EXPECT_EQ(params.visibility.step, end_of_group(result(), 2));
    params.visibility.step = -1;
    desk.settle();
    click_row("3 ");
    EXPECT_EQ(params.visibility.step, -1) << "the picture stays complete";
}

TEST_F(SmallZBuffer, ButtonsStepByTriangleAndByTouch) {
    params.visibility.step = 0;
    desk.settle();
    const std::vector<int> ends = result().group_ends;
    std::vector<int> touches;
    for (const PixelTouch& touch : result().touches) touches.push_back(touch.step);
    const auto expect_forth_and_back = [&](const std::vector<int>& steps, const char* next, const char* previous) {
        for (const int step : steps) {
            desk.click(next);
            EXPECT_EQ(params.visibility.step, step) << next;
        }
        EXPECT_FALSE(ui.find(next).enabled) << next;
        for (std::size_t i = steps.size() - 1; i-- > 0;) {
            desk.click(previous);
            EXPECT_EQ(params.visibility.step, steps[i]) << previous;
        }
    };
    expect_forth_and_back(ends, "depth/levels/next group", "depth/levels/group before");
    params.visibility.step = 0;
    desk.settle();
    expect_forth_and_back(touches, "depth/levels/next touch", "depth/levels/touch before");
}

TEST_F(SmallZBuffer, TheOrdersButtonsMatchThePanels) {
    params.visibility.step = 100;
    desk.settle();
    const HiddenResult& now = result();
    const std::vector<std::pair<const char*, std::optional<int>>> buttons = {{"step before", 99},
                                                                             {"next step", 101},
                                                                             {"group before", previous_group(now, 100)},
                                                                             {"next group", next_group(now, 100)},
                                                                             {"touch before", previous_touch(now, 100)},
                                                                             {"next touch", next_touch(now, 100)}};
    for (const auto& [name, step] : buttons) {
        params.visibility.step = 100;
        desk.settle();
        ASSERT_TRUE(step) << name;
        ui.click("left/line/" + std::string(name));
        EXPECT_EQ(params.visibility.step, *step) << name;
    }
}

TEST_F(SmallZBuffer, ColumnsAndRowsCanBeSetAndReset) {
    desk.enter("depth/columns", "9");
    desk.enter("depth/rows", "5");
    desk.settle();
    EXPECT_EQ(params.visibility.raster, glm::ivec2(9, 5));
    EXPECT_EQ(result().image.ids.size(), 45U);
    desk.enter("depth/columns", "9999");
    EXPECT_EQ(params.visibility.raster->x, 256) << "typed values stay in the range of the state";
    desk.click("depth/Small raster");
    desk.settle();
    EXPECT_FALSE(params.visibility.raster);
    EXPECT_FALSE(params.visibility.pixel);
    EXPECT_EQ(glm::ivec2(result().image.width, result().image.height), desk.layout().camera.size_px());
    EXPECT_FALSE(ui.find("depth/columns").enabled);
}

}  // namespace
}  // namespace viewing::test
