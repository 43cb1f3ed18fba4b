// The lecture's code on screen: each line lights up together with the matrix entry that it fills, the switch shows the
// mistake as it is printed on the slide, and the observer's rays follow light, plane and scene.
#include "desk.h"
#include "ui/parts/links.h"

namespace viewing::test {
namespace {

class LectureCodeTest : public ::testing::Test {
protected:
    Desk desk{{2440, 2400}, "lecture-code"};
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;

    LectureCodeTest() {
        desk.workbench.arrangement.lower_height = 1000.0F;  // both functions fit without scrolling
        ui.frames(3);
    }

    /// Returns the entries in both matrices that light up while the pointer is over an item.
    widgets::Links entries_at(const std::string& label) {
        ui.hover(label);
        ui.frames(2);
        constexpr widgets::Links parameters = link::bit(20) - 1;
        return desk.workbench.widgets.hovered & ~parameters;
    }
    static std::string cell_name(int row, int column) {
        return "r" + std::to_string(row) + "c" + std::to_string(column);
    }
};

TEST_F(LectureCodeTest, EachLineAndItsEntryHighlightTheSameItems) {
    for (int index = 0; index < 16; ++index) {
        const int row = index % 4, column = index / 4;  // as GL reads the array
        const std::string element = "[" + std::to_string(index) + "]";
        const widgets::Links of_shadow = entries_at("left/code/shadowMat" + element);
        EXPECT_EQ(of_shadow, link::shadow_entry(4 * row + column));
        EXPECT_EQ(entries_at("matrices/S/" + cell_name(row, column)), of_shadow);
        const widgets::Links of_mirror = entries_at("left/code/reflectionMat" + element);
        EXPECT_EQ(of_mirror, link::mirror_entry(4 * row + column));
        EXPECT_EQ(entries_at("matrices/R/" + cell_name(row, column)), of_mirror);
    }
}

TEST_F(LectureCodeTest, ALineHighlightsTheControlsItDependsOn) {
    ui.hover("left/code/shadowMat[4]");  // 0.f - lightpos[0] * plane[1]
    ui.frames(2);
    const widgets::Links hovered = desk.workbench.widgets.hovered;
    EXPECT_EQ(hovered & (link::all_light | link::all_plane), link::light[0] | link::plane[1]);
}

TEST_F(LectureCodeTest, TheSwitchShowsTheTranspose) {
    const Params before = params;
    const std::string right = ui.text_of("matrices/R/r0c3");
    EXPECT_EQ(ui.text_of("matrices/R/r3c0"), "0.000");
    desk.click("left/code/R as printed on the slide");
    EXPECT_EQ(differing_fields(before, params), Paths{"reflection.printed_by_rows"});
    EXPECT_EQ(ui.text_of("matrices/R/r3c0"), right);
    EXPECT_EQ(ui.text_of("matrices/R/r0c3"), "0.000");
    EXPECT_NE(ui.text_of("left/code/trouble").find("w is no longer 1"), std::string::npos);
    params.planes.front().equation.w = 0.0;
    ui.frames(2);
    EXPECT_FALSE(ui.has("left/code/trouble")) << "correct when d = 0";
    // The element that the slide fills with −2ad is entry (4, 1) for GL.
    EXPECT_EQ(entries_at("left/code/reflectionMat[3]"), link::mirror_entry(12));
}

TEST_F(LectureCodeTest, IsDrawnInEveryWidthAndTheme) {
    for (const ImVec2 size : {ImVec2(800, 600), ImVec2(1600, 900), ImVec2(300, 200), ImVec2(3000, 1000)})
        for (const Theme theme : {Theme::dark, Theme::projector}) {
            params.ui.theme = theme;
            ImGui::GetIO().DisplaySize = size;
            desk.apply_looks();
            ui.frames(3);
            if (desk.layout().lower_left.empty()) continue;
            const Rect rect = desk.layout().lower_left;
            for (const char* label : {"left/code/shadowMat[15]", "left/code/reflectionMat[15]"}) {
                EXPECT_GE(ui.find(label).min.x, rect.min.x);
                EXPECT_LE(ui.find(label).max.x, rect.max.x) << size.x;
            }
        }
}

TEST(LightRaysTest, AreUpdatedWhenLightPlaneOrSceneChanges) {
    Session session = session_of("opening");
    LightRays rays;
    const auto count = [&] {
        const Derived derived = derive(session.params, session.scene(), {});
        return rays.of(session, derived).size();
    };
    EXPECT_GT(count(), 12U);
    EXPECT_LE(count(), 3U * 12U) << "three objects";
    const glm::dvec3 before = rays.of(session, derive(session.params, session.scene(), {})).front().shadow_world;
    session.params.lights.front().position.x += 1.0;
    EXPECT_GT(count(), 0U);
    const glm::dvec3 after = rays.of(session, derive(session.params, session.scene(), {})).front().shadow_world;
    EXPECT_GT(glm::distance(before, after), 0.05);
    session.params.planes.front().equation = {0, 1, 0, -20};
    EXPECT_EQ(count(), 0U) << "all objects are beyond the light";
    session.params.lights.front().position = {1, 20, 1, 1};
    EXPECT_EQ(count(), 0U) << "the light is in the plane";
}

}  // namespace
}  // namespace viewing::test
