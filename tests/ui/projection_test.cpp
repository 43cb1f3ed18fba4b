// The projection in the panel, with a custom window: its edges are those that glFrustum and glOrtho take.
#include "desk.h"

namespace viewing::test {
namespace {

constexpr const char* window_switch = "projection/explicit window";

/// Opens the panel's rarely used controls and enables the custom window.
void give_window(Desk& desk) {
    desk.click("projection/Window, far, aspect, radians");
    desk.settle();
    desk.click(window_switch);
    desk.settle();
}

TEST(ProjectionWindow, BeginsWithThePictureAsItIs) {
    for (const bool orthographic : {false, true}) {
        Desk desk;
        if (orthographic) desk.click("projection/type/Orthographic");
        desk.settle();
        const glm::dmat4 before = desk.derived.clip_from_view;
        give_window(desk);
        const ProjectionParams& projection = desk.params().projection;
        EXPECT_EQ(projection.type, orthographic ? ProjectionType::orthographic_window : ProjectionType::frustum);
        for (int column = 0; column < 4; ++column)
            EXPECT_LT(glm::distance(desk.derived.clip_from_view[column], before[column]), 1e-9);
        EXPECT_TRUE(desk.problems.empty()) << say(desk.problems.front().sentence);
        desk.undo();
        EXPECT_FALSE(desk.params().projection.has_window());
    }
}

TEST(ProjectionWindow, AnEdgeMovesOneColumnOfPAndStopsShortOfTheOther) {
    Desk desk;
    give_window(desk);
    const Params before = desk.params();
    const glm::dmat4 was = desk.derived.clip_from_view;
    desk.drag("projection/left", 30.0F);
    desk.settle();
    EXPECT_EQ(differing_fields(before, desk.params()), Paths{"projection.left"});
    const glm::dmat4& now = desk.derived.clip_from_view;
    EXPECT_GT(now[0][0], was[0][0]) << "a narrower window enlarges x";
    EXPECT_GT(now[2][0], 0.0) << "(r + l) / (r − l) of a window to the right of the axis";
    EXPECT_EQ(now[1], was[1]);
    desk.drag("projection/left", 500.0F);
    desk.settle();
    EXPECT_LT(desk.params().projection.left, desk.params().projection.right);
    desk.drag("projection/top", -500.0F);
    desk.settle();
    EXPECT_GT(desk.params().projection.top, desk.params().projection.bottom);
}

TEST(ProjectionWindow, AStretchedPictureIsMendedByLeftAndRight) {
    Desk desk;
    desk.params().projection.type = ProjectionType::frustum;
    desk.params().projection.set_window({-0.1, 0.5, -0.1, 0.1});
    desk.settle();
    ASSERT_EQ(desk.problems.size(), 1U);
    EXPECT_NE(say(desk.problems.front().sentence).find("the projection window is 3 times as wide as it is high"),
              std::string::npos);
    const std::vector<std::string> fix{desk.problems.front().fixed_by};
    const Result<Params> fixed = apply_settings(desk.params(), fix, "fix");
    ASSERT_TRUE(fixed) << fixed.error();
    desk.params() = *fixed;
    desk.settle();
    EXPECT_TRUE(desk.problems.empty());
    EXPECT_NEAR(desk.params().projection.window().center().x, 0.2, 1e-9) << "about the same middle";
}

TEST(InfiniteFar, IsASwitchWherePerspectiveAllowsIt) {
    constexpr const char* infinite_switch = "projection/infinite z-far";
    Desk desk;
    desk.click("projection/Window, far, aspect, radians");
    desk.settle();
    desk.click(infinite_switch);
    desk.settle();
    EXPECT_TRUE(std::isinf(desk.params().projection.far));
    EXPECT_EQ(desk.ui.find("projection/z-far").text, "∞");
    EXPECT_EQ(desk.derived.clip_from_view[2][2], -1.0);
    EXPECT_TRUE(desk.problems.empty());
    desk.click(infinite_switch);
    desk.settle();
    EXPECT_EQ(desk.params().projection.far, 40.0);
    desk.click(infinite_switch);
    desk.settle();
    desk.drag("projection/z-far", -60.0F);
    desk.settle();
    EXPECT_TRUE(std::isfinite(desk.params().projection.far)) << "a drag makes far finite again";
    desk.params().projection.far = INFINITY;
    desk.click("projection/type/Orthographic");
    desk.settle();
    EXPECT_EQ(desk.params().projection.far, 40.0) << "a parallel projection needs a finite far plane";
    EXPECT_FALSE(desk.ui.find(infinite_switch).enabled);
}

// Displayed text must show infinity as ∞ and never contain "inf" or "nan".
TEST(InfiniteFar, IsReadAsASign) {
    for (const char* view :
         {"observer", "depth", "histogram", "precision", "codes", "pixel", "fighting", "display_code"})
        for (const char* mapping : {"standard", "reversed"}) {
            Desk desk;
            const std::vector<std::string> settings{"projection.far=infinite", "depth.format=d32f",
                                                    "view.pixel=[300,200]", std::string("view.lower_left=") + view,
                                                    std::string("depth.mapping=") + mapping};
            desk.params() = *apply_settings(desk.params(), settings);
            desk.settle();
            for (const RecordedItem& item : desk.recorded())
                for (const char* const bad : {"inf,", "inf ", "-inf", "nan", "—"})
                    EXPECT_EQ(item.text.find(bad), std::string::npos) << view << " " << item.label << ": " << item.text;
        }
}

TEST(ProjectionWindow, TurningTheWheelEnlargesAnOrthographicWindow) {
    Params params;
    params.projection.type = ProjectionType::orthographic_window;
    params.projection.set_window({-1.0, 3.0, -2.0, 1.0});
    params.projection.scale_picture(0.5);
    EXPECT_EQ(params.projection.window(), (Edges{-0.5, 1.5, -1.0, 0.5}));
    params.projection.type = ProjectionType::orthographic;
    params.projection.scale_picture(0.5);
    EXPECT_EQ(params.projection.height, 3.0);
    EXPECT_EQ(params.projection.left, -0.5) << "without a custom window, only the height changes";
}

}  // namespace
}  // namespace viewing::test
