// Stepping through the frame pass by pass: the bar, the list, and the value of view.pass. gl/pass_limit_test.cpp tests
// what GL draws up to a pass.
#include "topics/planes/shown/passes_view.h"

#include <algorithm>

#include "desk.h"

namespace viewing::test {
namespace {

/// The window is so tall that all passes are visible.
class PassesView : public ::testing::Test {
protected:
    PassesView() {
        params.view.lower_right = Topic::passes;
        desk.params().view.layout.big = ViewName::lower_right;
        desk.settle();
    }

    Desk desk{{1600, 4000}};
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;

    int count() const { return static_cast<int>(desk.frame_plan.passes.size()); }
    std::string title(int pass) const { return "lower/pass " + std::to_string(pass + 1); }
    void stop_after(int pass) {
        params.view.pass = pass;
        desk.settle();
    }
    void click_pass(int pass) {
        ui.click(title(pass));
        desk.settle();
    }
    /// Returns the highest opacity of anything painted within an item, except the scrollbar.
    int strongest_alpha(std::string_view label) const {
        const RecordedItem& item = ui.find(label);
        int strongest = 0;
        const ImDrawData& drawn = *ImGui::GetDrawData();
        for (int list = 0; list < drawn.CmdListsCount; ++list)
            for (const ImDrawVert& vertex : drawn.CmdLists[list]->VtxBuffer)
                if (item.window == drawn.CmdLists[list]->_OwnerName && vertex.pos.y > item.min.y &&
                    vertex.pos.y < item.max.y && vertex.pos.x < item.max.x - 20.0F)
                    strongest = std::max(strongest, static_cast<int>(vertex.col >> IM_COL32_A_SHIFT));
        return strongest;
    }
};

TEST_F(PassesView, HasAHeadingForEachPassInOrder) {
    ASSERT_GE(count(), 4);
    float last = -1e9F;
    for (int pass = 0; pass < count(); ++pass) {
        const RecordedItem& item = ui.find(title(pass));
        EXPECT_GT(item.min.y, last) << title(pass);
        last = item.max.y;
    }
    EXPECT_EQ(ui.text_of("lower/passes/text"), "all " + std::to_string(count()) + " steps");
    for (const char* buffer : {"lower/color", "lower/depth", "lower/stencil"}) EXPECT_TRUE(ui.has(buffer)) << buffer;
}

TEST_F(PassesView, StepsEditThePassAndNothingElse) {
    const Params before = params;
    ui.click("lower/passes/Back");
    desk.settle();
    EXPECT_EQ(params.view.pass, count() - 2);
    EXPECT_EQ(desk.frame_plan.limit.pass, count() - 2);
    EXPECT_EQ(ui.text_of("lower/passes/text"),
              "step " + std::to_string(count() - 1) + " of " + std::to_string(count()));
    ui.click("lower/passes/Back");
    EXPECT_EQ(params.view.pass, count() - 3);
    ui.click("lower/passes/Forward");
    ui.click("lower/passes/Forward");
    EXPECT_EQ(params.view.pass, -1) << "the end shows the whole frame";
    ui.click("lower/passes/First");
    EXPECT_EQ(params.view.pass, 0);
    EXPECT_EQ(differing_fields(before, params), (Paths{"view.pass"}));
    desk.settle();
    ui.click("lower/passes/Back");
    ui.click("lower/passes/First");
    EXPECT_EQ(params.view.pass, 0) << "before the first pass there is nothing to see";
    ui.click("lower/passes/All");
    EXPECT_EQ(params.view.pass, -1);
    EXPECT_EQ(params, before);
}

TEST_F(PassesView, PlaysFromTheFirstPassToTheWholeFrameAndStops) {
    widgets::StepPlayer& player = desk.workbench.views.pass_player;
    ui.click("lower/passes/Play");
    EXPECT_TRUE(player.playing);
    std::vector<int> seen{params.view.pass};
    for (int i = 0; i < 400 && player.playing; ++i) {
        ui.frame(0.05F);
        if (params.view.pass != seen.back()) seen.push_back(params.view.pass);
    }
    EXPECT_FALSE(player.playing);
    ASSERT_EQ(static_cast<int>(seen.size()), count());
    for (int pass = 0; pass + 1 < count(); ++pass) EXPECT_EQ(seen[static_cast<std::size_t>(pass)], pass);
    EXPECT_EQ(seen.back(), -1);
}

TEST_F(PassesView, PlayingAFrameOfOnePassEnds) {
    params.shadow.enabled = params.reflection.enabled = false;
    FramePlan single = desk.frame_plan;
    single.passes.resize(1);
    widgets::Context context;
    context.fonts = desk.workbench.widgets.fonts;
    context.palette = desk.workbench.widgets.palette;
    widgets::StepPlayer player{.playing = true};
    const Rect rect{{10, 10}, {700, 400}};
    widgets::test::Harness alone(context, [&] {
        widgets::NewFrame(context);
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({800, 500});
        ImGui::Begin("alone", nullptr, ImGuiWindowFlags_NoDecoration);
        draw_passes_view(desk.session, single, rect, {}, 1.5, player);
        ImGui::End();
    });
    alone.frames(5);
    EXPECT_FALSE(player.playing);
    EXPECT_EQ(params.view.pass, -1);
    alone.click("passes/First");
    EXPECT_EQ(params.view.pass, -1) << "the first pass is the whole frame";
    single.passes.clear();
    alone.frames(3);
    EXPECT_EQ(params.view.pass, -1);
}

TEST_F(PassesView, AClickStopsAtAPassAndASecondOneReleases) {
    const Params before = params;
    click_pass(1);
    EXPECT_EQ(params.view.pass, 1);
    EXPECT_EQ(differing_fields(before, params), (Paths{"view.pass"}));
    click_pass(1);
    EXPECT_EQ(params, before);
    click_pass(2);
    click_pass(0);
    EXPECT_EQ(params.view.pass, 0) << "from one pass to another";
    click_pass(count() - 1);
    EXPECT_EQ(params, before) << "after the last pass, the frame is whole";
    desk.undo();
    EXPECT_EQ(params.view.pass, 0);
}

TEST_F(PassesView, PassesNotDrawnAreDimmed) {
    for (const int stop : {0, 1, count() - 2, -1}) {
        stop_after(stop);
        ui.move_to({-1, -1});
        ui.frames(2);
        for (int pass = 0; pass < count(); ++pass)
            EXPECT_EQ(strongest_alpha(title(pass)) > 200, stop < 0 || pass <= stop)
                << title(pass) << " at " << stop << ": " << strongest_alpha(title(pass));
    }
}

TEST_F(PassesView, TheListFollowsTheSteps) {
    ImGui::GetIO().DisplaySize = {1600, 900};
    desk.params().view.layout.big = ViewName::none;
    desk.settle();
    const Rect place = desk.layout().lower_right;
    ui.click("lower/passes/First");
    for (int pass = 1; pass + 1 < count(); ++pass) {
        ui.click("lower/passes/Forward");
        ui.frames(2);
        EXPECT_EQ(params.view.pass, pass);
        const RecordedItem& item = ui.find(title(pass));
        EXPECT_GE(item.min.y, place.min.y) << title(pass);
        EXPECT_LE(item.max.y, place.max.y) << title(pass);
    }
}

TEST_F(PassesView, APassPastTheLastOneShowsTheWholeFrame) {
    for (const int pass : {count() - 1, count(), 1000, 1'000'000}) {
        stop_after(pass);
        ui.frames(3);
        EXPECT_EQ(params.view.pass, pass) << "the state keeps its value";
        EXPECT_EQ(ui.text_of("lower/passes/text"),
                  "step " + std::to_string(count()) + " of " + std::to_string(count()));
        ui.click("lower/passes/Back");
        EXPECT_EQ(params.view.pass, count() - 2);
    }
}

/// Frames of methods that run in software are always drawn whole, so the view offers no stops.
TEST_F(PassesView, HiddenSurfaceMethodsHaveNoStops) {
    for (const VisibilityMethod method : {VisibilityMethod::painter, VisibilityMethod::newell, VisibilityMethod::bsp,
                                          VisibilityMethod::software_depth_buffer, VisibilityMethod::ray_cast}) {
        params.visibility.method = method;
        ui.frame();  // changing the method selects its topic
        params.view.lower_right = Topic::passes;
        params.view.pass = 1;
        desk.settle();
        const Params before = params;
        EXPECT_FALSE(ui.has("lower/passes/Back"));
        ui.click(title(0));
        EXPECT_EQ(params, before) << static_cast<int>(method);
        EXPECT_EQ(desk.frame_plan.limit.pass, -1);
    }
    params.visibility.method = VisibilityMethod::none;
    ui.frame();
    params.view.lower_right = Topic::passes;
    desk.settle();
    EXPECT_TRUE(ui.has("lower/passes/Back"));
    EXPECT_EQ(desk.frame_plan.limit.pass, 1);
}

TEST_F(PassesView, FitsEverywhereAndChangesNothing) {
    params.planes = {{}, {.equation = {0.0, 0.0, 1.0, 3.0}}, {.equation = {1.0, 0.0, 0.0, 3.0}}};
    params.reflection.bounces = 3;
    for (const Theme theme : {Theme::dark, Theme::projector}) {
        params.ui.theme = theme;
        params.view.layout.big = ViewName::none;
        ImGui::GetIO().DisplaySize = {1600, 900};
        desk.apply_looks();
        for (const ImVec2 size : {ImVec2{1600, 900}, ImVec2{800, 600}, ImVec2{420, 320}, ImVec2{250, 200},
                                  ImVec2{90, 120}, ImVec2{20, 20}, ImVec2{2, 2}}) {
            ImGui::GetIO().DisplaySize = size;
            for (const ViewName big : {ViewName::none, ViewName::lower_right}) {
                params.view.layout.big = big;
                const Params before = params;
                ui.frames(4);
                EXPECT_EQ(params, before);
                const Rect place = desk.layout().lower_right;
                for (const char* name : {"lower/color", "lower/depth", "lower/stencil"}) {
                    const RecordedItem* picture = ui.try_find(name);
                    EXPECT_EQ(picture != nullptr, !place.empty()) << size.x;
                    if (!picture || place.width() < 60 || place.height() < 60) continue;
                    EXPECT_GE(picture->min.x, place.min.x - 1.0F) << name << " " << size.x;
                    EXPECT_GE(picture->min.y, place.min.y - 1.0F) << name << " " << size.x;
                    EXPECT_LE(picture->max.x, place.max.x + 1.0F) << name << " " << size.x;
                    EXPECT_LE(picture->max.y, place.max.y + 1.0F) << name << " " << size.x;
                }
                const RecordedItem* text = ui.try_find("lower/passes/text");
                if (size.x >= 1600 || (size.x == 800 && theme == Theme::dark)) {
                    EXPECT_TRUE(text) << size.x;
                }
                if (text) {
                    EXPECT_LE(text->max.x, place.max.x + 1.0F) << "the bar is cut off at " << size.x;
                }
            }
        }
    }
}

TEST(PassPictureSize, HasTheCamerasShapeAndAtLeastOnePixel) {
    for (const double aspect : {0.2, 1.0, 1.78, 5.0})
        for (const ImVec2 size : {ImVec2{600, 300}, ImVec2{300, 300}, ImVec2{300, 900}, ImVec2{3, 2}, ImVec2{0, 0}}) {
            const Rect rect{{10, 20}, {10 + size.x, 20 + size.y}};
            const glm::ivec2 made = pass_picture_size(rect, aspect);
            EXPECT_GE(std::min(made.x, made.y), 1);
            EXPECT_LE(made.x, std::max(size.x, 1.0F));
            EXPECT_LE(made.y, std::max(size.y, 1.0F));
            if (made.y > 20) {
                EXPECT_NEAR(static_cast<double>(made.x) / made.y, aspect, 0.1 * aspect);
            }
        }
}

}  // namespace
}  // namespace viewing::test
