// The depth buffer's controls: the panel's section, the second picture, the topics below it, the pinned pixel and the
// histogram's range.
#include <string>
#include <vector>

#include "desk.h"
#include "topics/why/numbers/why.h"
#include "ui/views/lower_view.h"

namespace viewing::test {
namespace {

class DepthPanel : public UiTest {
protected:
    /// Expects that one use of a control changes this field and no other.
    void expect_edits(const std::string& label, const std::string& field, bool is_number = false) {
        SCOPED_TRACE(label);
        const Params before = params;
        is_number ? desk.drag(label, 30.0F) : desk.click(label);
        EXPECT_EQ(differing_fields(before, params), Paths{field});
    }
    void open_section() {
        desk.fold_out_all();
        desk.settle();
    }
};

TEST_F(DepthPanel, EachMappingShowsItsSwitches) {
    params.depth.mapping = DepthMapping::reversed;
    open_section();
    expect_edits("buffer/Clip range 0 … 1", "depth.reversed_zero_to_one");
    expect_edits("buffer/Clear to 0", "depth.reversed_clear");
    expect_edits("buffer/Flip the offset's sign", "depth.reversed_offset");
    EXPECT_FALSE(ui.find("buffer/Per vertex").enabled);
    params.depth.mapping = DepthMapping::logarithmic;
    desk.settle();
    expect_edits("buffer/Per vertex", "depth.logarithm_per_vertex");
    EXPECT_FALSE(ui.find("buffer/Clear to 0").enabled);
}

TEST_F(DepthPanel, SwitchesThatBreakThePictureSayWhy) {
    const auto sentences = [&] {
        desk.settle();
        std::vector<std::string> all;
        for (const Problem& problem : desk.problems) all.push_back(say(problem.sentence));
        return all;
    };
    EXPECT_EQ(sentences(), std::vector<std::string>{});
    for (const auto& [path, value] :
         std::vector<std::pair<std::string, std::string>>{{"depth.test", "false"},
                                                          {"depth.func", "always"},
                                                          {"depth.func", "never"},
                                                          {"depth.func", "greater"},
                                                          {"depth.write", "false"},
                                                          {"depth.clear", "false"},
                                                          {"depth.write_while_clearing", "false"}}) {
        SCOPED_TRACE(path + "=" + value);
        const std::vector<std::string> setting{path + "=" + value};
        const Result<Params> broken = apply_settings(Params{}, setting);
        ASSERT_TRUE(broken);
        params = *broken;
        EXPECT_EQ(sentences().size(), 1U);
    }
}

TEST_F(DepthPanel, TheCoplanarSceneHasItsOwnSliders) {
    open_section();
    EXPECT_FALSE(ui.find("buffer/gap").enabled);
    params.scene = std::string("coplanar");
    open_section();
    expect_edits("buffer/gap", "coplanar.gap", true);
    expect_edits("buffer/tilt", "coplanar.tilt", true);
    expect_edits("buffer/distance", "coplanar.distance", true);
}

TEST_F(DepthPanel, DecalsOfferThreeMethods) {
    params.scene = std::string("decals");
    open_section();
    expect_edits("buffer/decals/GL_EQUAL", "depth.decals");
    EXPECT_EQ(params.depth.decals, DecalMethod::equal);
    EXPECT_FALSE(ui.find("buffer/decal factor").enabled);
    expect_edits("buffer/decals/Stencil", "depth.decals");
    EXPECT_EQ(params.depth.decals, DecalMethod::stencil);
}

TEST_F(DepthPanel, ASecondPictureTakesHalfOfTheView) {
    const auto divided = [&](ImVec2 window_px) {
        ImGui::GetIO().DisplaySize = window_px;
        params.view.beside.shows = Beside::nothing;
        desk.settle();
        const Rect whole = desk.layout().camera;
        params.view.beside.shows = Beside::depth;
        desk.settle();
        const Layout layout = desk.layout();
        EXPECT_EQ(layout.camera.size_px(), layout.beside.size_px());
        EXPECT_EQ(layout.camera.min.x, whole.min.x);
        EXPECT_EQ(layout.camera.min.y, whole.min.y);
        EXPECT_NEAR(layout.beside.max.x, whole.max.x, 2.0F);
        EXPECT_NEAR(layout.beside.max.y, whole.max.y, 2.0F);
        return std::pair(layout, whole);
    };
    const Layout above = divided({1600, 1500}).first;
    const auto [beside, whole] = divided({1600, 900});
    EXPECT_LT(beside.camera.max.x, beside.beside.min.x);
    EXPECT_LT(above.camera.max.y + above.header_height, above.beside.min.y);  // the second picture has a title, too
    EXPECT_TRUE(ui.has("beside/beside view"));
    params.view.beside.layout = BesideLayout::divider;
    desk.settle();
    EXPECT_TRUE(desk.layout().beside.empty());
    EXPECT_EQ(desk.layout().camera.size_px(), whole.size_px());
}

TEST_F(DepthPanel, DraggingTheDividerLeavesTheCameraAlone) {
    params.view.beside.shows = Beside::other_depth;
    params.view.beside.layout = BesideLayout::divider;
    desk.settle();
    const Params before = params;
    const Rect rect = desk.layout().camera;
    desk.drag_from({(rect.min.x + rect.max.x) * 0.5F, rect.min.y + 0.8F * rect.height()}, 100.0F, 0.0F);
    EXPECT_EQ(differing_fields(before, params), Paths{"view.beside.share"});
    EXPECT_NEAR(params.view.beside.share, 0.5 + 100.0 / rect.width(), 0.01);
}

TEST_F(DepthPanel, AClickPinsThePixelWhileAViewDescribesIt) {
    const Rect rect = desk.layout().camera;
    const ImVec2 place(rect.min.x + 40.0F, rect.max.y - 30.0F);
    desk.click_at(place);
    EXPECT_EQ(params.view.pixel, std::nullopt);
    params.view.lower_right = Topic::pixel;
    params.follow.reset();
    desk.settle();
    desk.click_at(place);
    ASSERT_TRUE(params.view.pixel);
    EXPECT_EQ(*params.view.pixel, glm::ivec2(40, static_cast<int>(rect.height()) - 30));
    EXPECT_EQ(params.follow, std::nullopt);
    desk.click_at(place);
    EXPECT_EQ(params.view.pixel, std::nullopt);
}

TEST_F(DepthPanel, ARightClickAsksWhyAndADragDoesNot) {
    const Rect rect = desk.layout().camera;
    const ImVec2 place(rect.min.x + 60.0F, rect.max.y - 40.0F);
    ui.move_to(place);
    ui.press(ImGuiMouseButton_Right);
    ui.move_to({place.x + 30.0F, place.y});
    ui.release(ImGuiMouseButton_Right);
    EXPECT_FALSE(is_shown(params, Topic::why));
    EXPECT_EQ(params.view.pixel, std::nullopt);
    const glm::ivec2 pixel(60, static_cast<int>(rect.height()) - 40);
    ui.move_to(place);
    ui.press(ImGuiMouseButton_Right);
    ui.release(ImGuiMouseButton_Right);
    desk.settle();
    EXPECT_TRUE(is_shown(params, Topic::why));
    ASSERT_TRUE(params.view.pixel);
    EXPECT_EQ(*params.view.pixel, pixel);
}

TEST_F(DepthPanel, TheExplanationShowsItsRowsAndStopsAfterAPass) {
    params.view.lower_right = Topic::why;
    params.reflection.enabled = false;
    const glm::ivec2 size_px = desk.layout().camera.size_px();
    const Derived derived = derive(params, desk.session.scene(), Viewport{size_px});
    const FramePlan frame = plan(params, derived);
    const FragmentFinder finder(desk.session.scene());
    // This pixel, at the middle of the floor's front edge, shows the floor at any picture size.
    const glm::ivec2 pixel(size_px.x / 2, size_px.y - size_px.y / 8);
    desk.workbench.views.why.told = std::make_shared<const Why>(
        why({params, derived, frame, finder, Viewport{size_px}, {}, pixel, std::nullopt, {}}));
    desk.settle();
    EXPECT_TRUE(ui.has("lower/why/Seen here: the plane."));
    EXPECT_TRUE(ui.has("lower/why/why: Ray"));
    EXPECT_TRUE(ui.has("lower/why/why: Light source"));
    desk.click("lower/why/why: Pass 1, Patch");
    EXPECT_EQ(params.view.pass, 0);
    desk.click("lower/why/Whole frame");
    EXPECT_EQ(params.view.pass, -1);
}

TEST_F(DepthPanel, EveryTopicFitsInBothSlots) {
    for (const Slot slot : {Slot::left, Slot::right}) {
        for (int topic = 0; topic < static_cast<int>(topic_titles().size()); ++topic) {
            SCOPED_TRACE(topic_titles()[static_cast<std::size_t>(topic)]);
            choose_topic(params, slot, static_cast<Topic>(topic));
            desk.settle();
            EXPECT_NE(topic_of(params, slot), Topic::automatic);
            EXPECT_NE(topic_of(params, Slot::left), topic_of(params, Slot::right));
        }
    }
}

TEST_F(DepthPanel, ChoosingTheOtherViewsTopicMovesItOver) {
    params.view.lower_left = Topic::precision;
    choose_topic(params, Slot::right, Topic::precision);
    EXPECT_EQ(topic_of(params, Slot::right), Topic::precision);
    EXPECT_EQ(topic_of(params, Slot::left), Topic::depth);  // it was on the right before
}

TEST_F(DepthPanel, ChangingTheMethodBringsBackItsTopic) {
    params.view.lower_right = Topic::codes;
    desk.settle();
    desk.click("depth/method");
    ui.frames(2);
    ui.click("depth/method/BSP tree");
    desk.settle();
    EXPECT_EQ(topic_of(params, Slot::right), Topic::tree);
}

}  // namespace
}  // namespace viewing::test
