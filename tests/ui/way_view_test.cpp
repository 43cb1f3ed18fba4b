// The lower view "The path of a point": its slider and its play button move the point, and the user can drag the point.
#include "topics/camera/shown/way_view.h"

#include "desk.h"
#include "recorded_letters.h"
#include "topics/camera/numbers/clip_space.h"
#include "ui/parts/topics.h"

namespace viewing::test {
namespace {

class WayViewTest : public ::testing::Test {
protected:
    WayViewTest() {
        choose_topic(params, Slot::left, Topic::way);
        params.follow = Follow{"box", 3};
        desk.settle();
    }
    Desk desk;
    Params& params = desk.params();

    bool says(std::string part) {
        std::erase(part, ' ');  // not a visible letter
        desk.settle();
        std::string all;
        for (const Letter& letter : letters_of_frame()) all += utf8(letter.character);
        return all.find(part) != std::string::npos;
    }
    ImVec2 in_view(const glm::dvec3& world) {
        const Rect rect = desk.layout().lower_left;
        const glm::dvec4 clip =
            derive_way_view(params, desk.derived, {rect.size_px()}, free_of_numbers(rect)).clip_from_world *
            glm::dvec4(world, 1.0);
        return {rect.min.x + rect.width() * static_cast<float>(0.5 + 0.5 * clip.x / clip.w),
                rect.min.y + rect.height() * static_cast<float>(0.5 - 0.5 * clip.y / clip.w)};
    }
};

TEST_F(WayViewTest, TheSliderCarriesThePointAndThePictureTurns) {
    const Params before = params;
    desk.drag("left/way/way", 60.0F);
    desk.settle();
    EXPECT_EQ(differing_fields(before, params), std::vector<std::string>{"view.way"});
    EXPECT_GT(params.view.way, 0.5);
    desk.undo();
    EXPECT_EQ(params, before);
    const Rect picture = way_places(desk.layout().lower_left).picture;
    desk.drag_from({picture.min.x + 20.0F, picture.min.y + 20.0F}, 30.0F, 0.0F);
    EXPECT_EQ(differing_fields(before, params), std::vector<std::string>{"observer.yaw"});
}

TEST_F(WayViewTest, PlaysFromSpaceToSpaceUntilTheWindow) {
    desk.click("left/way/play");
    double last = params.view.way;
    int rests = 0, frames = 0;
    for (; frames < 60 * 30 && desk.workbench.views.way_player.playing; ++frames) {
        desk.ui.frame();
        EXPECT_GE(params.view.way, last) << "only forward";
        EXPECT_LE(params.view.way, std::floor(last) + 1.0) << "no space is skipped";
        if (params.view.way == last && last == std::floor(last)) ++rests;
        last = params.view.way;
    }
    EXPECT_EQ(params.view.way, 4.0);
    EXPECT_FALSE(desk.workbench.views.way_player.playing);
    EXPECT_GT(rests, 3 * 20);
    desk.click("left/way/play");
    EXPECT_LT(params.view.way, 1.0) << "starts over";
    desk.ui.frames(120);
    desk.click("left/way/play");
    const double stopped = params.view.way;
    desk.ui.frames(30);
    EXPECT_EQ(params.view.way, stopped);
}

TEST(PlayWay, WithoutMotionItOnlyJumps) {
    double way = 0.0;
    widgets::StepPlayer player{.playing = true};
    std::vector<double> seen{way};
    for (int frame = 0; frame < 60 * 30 && player.playing; ++frame) {
        play_way(way, player, 1.0 / 60.0, false);
        if (way != seen.back()) seen.push_back(way);
    }
    EXPECT_EQ(seen, (std::vector<double>{0, 1, 2, 3, 4}));
}

TEST_F(WayViewTest, SaysWhatCarriesThePointAndWhatCutsItOff) {
    EXPECT_TRUE(says("world space"));
    params.view.way = 1.0;
    EXPECT_TRUE(says("V maps p to eye space"));
    params.view.way = 2.0;
    EXPECT_TRUE(says("P maps it to clip space"));
    params.view.way = 3.0;
    EXPECT_TRUE(says("maps it to NDC"));
    params.view.way = 4.0;
    EXPECT_TRUE(says("the viewport"));
    EXPECT_TRUE(says("pixel ("));
    params.follow = Follow{.object = "", .point = glm::dvec3(3.9, 3.0, 12.0)};  // behind the camera
    EXPECT_TRUE(says("cut off by the near plane: z < −w"));
    params.depth.mapping = DepthMapping::reversed;
    EXPECT_TRUE(says("cut off by the near plane: z > w"));
    params.follow.reset();
    EXPECT_TRUE(says("click a vertex"));
}

TEST_F(WayViewTest, ThePointIsDraggedInEverySpace) {
    for (const double way : {0.0, 1.0, 2.0, 3.0, 4.0}) {
        params.follow = Follow{.object = "", .point = glm::dvec3(1.0, 1.0, 1.0)};
        params.projection.far = 14.0;
        params.view.way = way;
        desk.settle();
        const Params before = params;
        const ImVec2 from = in_view(*params.follow->point);
        desk.drag_from(from, 12.0F, -8.0F);
        EXPECT_EQ(differing_fields(before, params), std::vector<std::string>{"follow"}) << way;
        const ImVec2 now = in_view(*params.follow->point);
        EXPECT_NEAR(now.x - from.x, 12.0F, 1.0F) << way;
        EXPECT_NEAR(now.y - from.y, -8.0F, 1.0F) << way;
    }
}

}  // namespace
}  // namespace viewing::test
