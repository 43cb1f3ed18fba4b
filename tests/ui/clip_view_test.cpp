// The lower view Clip space: its slider leads from eye space to NDC, and dragging elsewhere in the picture rotates the
// view.
#include "desk.h"
#include "recorded_letters.h"
#include "topics/camera/numbers/clip_space.h"
#include "ui/parts/topics.h"

namespace viewing::test {
namespace {

TEST(ClipSpaceView, TheSliderDividesAndThePictureTurns) {
    Desk desk;
    choose_topic(desk.params(), Slot::left, Topic::clip);
    desk.settle();
    const Params before = desk.params();
    desk.drag("left/clip/division", -60.0F);
    desk.settle();
    EXPECT_EQ(differing_fields(before, desk.params()), Paths{"view.division"});
    EXPECT_LT(desk.params().view.division, 0.9);
    EXPECT_GT(desk.params().view.division, 0.1);
    desk.undo();
    EXPECT_EQ(desk.params(), before);
    desk.drag("left/clip/lower view", 30.0F);
    desk.settle();
    EXPECT_EQ(differing_fields(before, desk.params()), Paths{"observer.yaw"});
}

TEST(ClipSpaceView, SaysWhatTheSpaceIs) {
    Desk desk;
    choose_topic(desk.params(), Slot::left, Topic::clip);
    const auto says = [&](std::string part) {
        std::erase(part, ' ');  // not a visible letter
        desk.settle();
        std::string all;
        for (const Letter& letter : letters_of_frame()) all += utf8(letter.character);
        return all.find(part) != std::string::npos;
    };
    EXPECT_TRUE(says("NDC: after ÷ w, a box; its depth codes are equally spaced"));
    desk.params().view.division = 0.0;
    EXPECT_TRUE(says("crowd at the near plane"));
    desk.params().view.division = 0.5;
    EXPECT_TRUE(says("a blend of a constant and w"));
    desk.params().view.division = 1.0;
    desk.params().depth.format = DepthFormat::d32f;
    EXPECT_TRUE(says("NDC: after ÷ w, the frustum is a box"));
    desk.params().projection.type = ProjectionType::orthographic;
    EXPECT_TRUE(says("w = 1"));
}

TEST(ClipSpaceView, MarksTheFaceThatCutsTheFollowedPointOff) {
    Desk desk;
    choose_topic(desk.params(), Slot::left, Topic::clip);
    desk.params().follow = Follow{"box", 3};
    const auto says = [&](const std::string& part) {
        desk.settle();
        std::string all;
        for (const Letter& letter : letters_of_frame()) all += utf8(letter.character);
        std::size_t count = 0;
        for (std::size_t at = all.find(part); at != std::string::npos; at = all.find(part, at + 1)) ++count;
        return count;
    };
    EXPECT_EQ(says("PVp÷w"), 1U);
    EXPECT_EQ(says("cutoffbythefarplane"), 0U);
    desk.params().projection.far = 2.0;  // nearer than the box, so the matrices' column reports it, too
    EXPECT_GE(says("cutoffbythefarplane"), 1U);
    desk.params().view.division = 0.0;
    EXPECT_GE(says("Vp"), 1U);
}

TEST(ClipSpaceView, TheFollowedPointIsDragged) {
    Desk desk;
    choose_topic(desk.params(), Slot::left, Topic::clip);
    desk.params().projection.far = 14.0;
    desk.params().follow = Follow{"box", 3};
    const auto place = [&] {
        desk.settle();
        const Rect rect = desk.layout().lower_left;
        const glm::dvec4 clip = derive_clip_view(desk.params(), desk.derived, {rect.size_px()}).clip_from_world *
                                glm::dvec4(desk.derived.followed->point_world, 1.0);
        return ImVec2(rect.min.x + rect.width() * static_cast<float>(0.5 + 0.5 * clip.x / clip.w),
                      rect.min.y + rect.height() * static_cast<float>(0.5 - 0.5 * clip.y / clip.w));
    };
    const ImVec2 from = place();
    const Params before = desk.params();
    desk.drag_from(from, 15.0F, -10.0F);
    EXPECT_EQ(differing_fields(before, desk.params()), Paths{"follow"});
    const ImVec2 now = place();
    EXPECT_NEAR(now.x - from.x, 15.0F, 1.0F);
    EXPECT_NEAR(now.y - from.y, -10.0F, 1.0F);
}

}  // namespace
}  // namespace viewing::test
