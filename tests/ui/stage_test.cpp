// Lesson covers hide their content everywhere, pointed-out parts are framed and scrolled into view, and marks appear.
// The tests judge by the drawn letters (letters.h), the recorded items and the clipboard.
#include <algorithm>
#include <set>

#include "desk.h"
#include "lesson/target_names.h"
#include "letters.h"
#include "ui/parts/topics.h"

namespace viewing::test {
namespace {

/// Returns whether a name belongs to one of the fields that the tests below do not look for.
bool is_new_field(const std::string& name) {
    return name == "control:projection.aspect" || name == "control:depth.buffer" ||
           name == "control:slips.degrees_as_radians" || name == "control:slips.plus_2ab" ||
           name == "control:slips.normal_not_unit";
}

class StageTest : public UiTest {
protected:
    Stage& stage = desk.workbench.stage;

    void open(const char* preset) {
        const Result<LoadedState> state = load_state(preset);
        if (!state) throw std::runtime_error(state.error());
        params = state->params;
        desk.settle();
    }
    void cover(std::vector<std::string> names) {
        stage.cover = std::move(names);
        ui.move_to({-1, -1});
        ui.frames(5);
    }
    void highlight(std::vector<std::string> names) {
        stage.highlight = std::move(names);
        ui.frames(8);
    }
    /// Returns every line of letters on the screen.
    std::string drawn() const {
        const widgets::Fonts& fonts = desk.workbench.widgets.fonts;
        const Page page{fonts.text, fonts.heading, fonts.note, fonts.number, fonts.small_number};
        std::string all;
        const ImDrawData* data = ImGui::GetDrawData();
        for (int i = 0; i < data->CmdListsCount; ++i)
            for (const Line& line : lines_of(page.letters(*data->CmdLists[i]))) all += line.text + "\n";
        return all;
    }
    bool draws(const std::string& text) const { return drawn().find(text) != std::string::npos; }
    bool records(const std::string& text) const {
        return std::ranges::any_of(
            desk.recorded(), [&text](const RecordedItem& item) { return item.text.find(text) != std::string::npos; });
    }
    /// Hovers over a position long enough for a tooltip to appear; returns its text, or "".
    std::string tooltip_at(ImVec2 place) {
        ui.move_to(place);
        for (int i = 0; i < 4; ++i) ui.frame(1.0F);
        for (const RecordedItem& item : desk.recorded())
            if (item.label.ends_with("tooltip")) return "tooltip: " + item.text;
        return "";
    }
    std::string tooltip_of(std::string_view label) {
        desk.reveal(label);
        const RecordedItem item = ui.find(label);
        return tooltip_at({(item.min.x + item.max.x) * 0.5F, (item.min.y + item.max.y) * 0.5F});
    }
    std::vector<std::string> missing() const {
        std::vector<std::string> missing;
        for (const std::string& name : stage.highlight) {
            const auto& found = desk.workbench.widgets.targets.found;
            if (std::ranges::find(found, name, &widgets::Targets::Found::name) == found.end()) missing.push_back(name);
        }
        return missing;
    }
};

/// Before an audience, a wrong picture is explained only where the step offers a control of the group that the mistake
/// belongs to.
TEST_F(StageTest, AStepTellsOnlyWhatItIsAbout) {
    params.shadow.stencil_once = false;
    desk.workbench.presenter.begin();
    const auto tells_with = [&](const char* control) {
        params.view.layout.controls = {control};
        desk.settle();
        ui.frames(3);
        return draws("blended separately");
    };
    EXPECT_TRUE(tells_with("shadow.opacity"));
    EXPECT_FALSE(tells_with("camera.yaw"));
    EXPECT_FALSE(tells_with("depth.test"));
    params.view.layout.controls.clear();
    desk.settle();
    EXPECT_TRUE(draws("blended separately")) << "a stage without limits reports every problem";
}

TEST_F(StageTest, WithoutALessonNothingIsCoveredOrFramed) {
    EXPECT_TRUE(desk.workbench.widgets.targets.empty());
    EXPECT_FALSE(ui.has("highlight"));
    EXPECT_FALSE(draws("?\n?"));
}

/// R of this plane has −0.571 in row 2, column 4, and no other displayed number is the same.
TEST_F(StageTest, ACoveredMatrixIsReadableNowhere) {
    for (const Topic topic : {Topic::mirror_derivation, Topic::lecture_code, Topic::passes}) {
        open("mirror-derivation");
        params.view.lower_right = topic;
        params.view.lower_left = Topic::observer;
        desk.settle();
        cover({});
        const std::string entry = number_text(desk.derived.chosen_plane().mirrored_world_from_world[3][1], 3);
        EXPECT_EQ(entry, "−0.571");
        EXPECT_TRUE(draws(entry) && records(entry)) << "the entry is visible before it is covered";
        cover({"matrix:R"});
        EXPECT_FALSE(draws(entry)) << name_of(topic);
        EXPECT_FALSE(records(entry)) << name_of(topic);
        EXPECT_EQ(ui.text_of("matrices/R"), "?");
        EXPECT_TRUE(ui.has("matrices/S/r0c0")) << "the other entries are shown";
    }
}

TEST_F(StageTest, ACoveredMatrixHasNoCopyTooltipOrLink) {
    open("mirror-derivation");
    cover({"matrix:R"});
    for (const RecordedItem& item : desk.recorded()) {
        if (item.label == "matrices/Copy") {
            const bool is_of_mirror =
                item.min.y > ui.find("matrices/S/r3c3").max.y && item.max.y < ui.find("matrices/R").min.y + 1.0F;
            EXPECT_EQ(item.enabled, !is_of_mirror);
        }
    }
    const RecordedItem plate = ui.find("matrices/R");
    for (float y = 0.1F; y < 1.0F; y += 0.2F)
        for (float x = 0.1F; x < 1.0F; x += 0.2F) {
            const ImVec2 place(plate.min.x + x * (plate.max.x - plate.min.x),
                               plate.min.y + y * (plate.max.y - plate.min.y));
            EXPECT_EQ(tooltip_at(place), "");
            EXPECT_EQ(desk.workbench.widgets.hovered, 0U) << "no control lights up";
        }
}

TEST_F(StageTest, ACoveredEntryIsAPlateAndTheOthersStayVisible) {
    cover({"matrix:V[2][3]", "matrix:S[3]"});
    EXPECT_EQ(ui.text_of("matrices/V/r2c3"), "?");
    EXPECT_NE(ui.text_of("matrices/V/r2c2"), "?");
    for (int column = 0; column < 4; ++column) {
        EXPECT_EQ(ui.text_of("matrices/S/r3c" + std::to_string(column)), "?");
        EXPECT_NE(ui.text_of("matrices/S/r2c" + std::to_string(column)), "?");
    }
    EXPECT_EQ(tooltip_of("matrices/V/r2c3"), "");
    EXPECT_NE(tooltip_of("matrices/V/r2c2"), "");
}

TEST_F(StageTest, ACoveredControlShowsNothingAndIgnoresInput) {
    const Params before = params;
    cover({"control:camera", "control:light.position[3]", "control:plane.equation"});
    EXPECT_EQ(ui.text_of("camera/position"), "?");
    for (const char* angle : {"camera/yaw pitch roll/x", "camera/yaw pitch roll/y", "camera/yaw pitch roll/z"})
        EXPECT_EQ(ui.text_of(angle), "?");
    EXPECT_EQ(ui.text_of("light/position/w"), "?");
    EXPECT_NE(ui.text_of("light/position/x"), "?");
    EXPECT_EQ(ui.text_of("plane/equation"), "?");
    for (const char* plate : {"camera/position", "camera/yaw pitch roll/x", "light/position/w", "plane/equation"}) {
        EXPECT_EQ(tooltip_of(plate), "");
        desk.drag(plate, 30.0F);
        desk.right_click(plate);
        ui.double_click(plate);
    }
    EXPECT_EQ(params, before);
}

TEST_F(StageTest, TheStateIsNotCopiedWhileAControlIsCovered) {
    cover({"control:camera.position"});
    desk.press_with(Key::ctrl, Key::c);
    EXPECT_EQ(desk.clipboard, "");
    EXPECT_NE(desk.session.message.text.find("not copied"), std::string::npos) << desk.session.message.text;
    cover({});
    desk.press_with(Key::ctrl, Key::c);
    EXPECT_NE(desk.clipboard.find("\"camera\""), std::string::npos);
}

TEST_F(StageTest, CoveredCodeButtonsAndViewsAreGone) {
    cover({"code:display.translate", "button:show C", "view:observer"});
    EXPECT_FALSE(draws("translate("));
    EXPECT_TRUE(draws("rotate("));
    EXPECT_EQ(ui.text_of("matrices/Show C"), "?");
    const ImVec2 button = ui.find("matrices/Show C").min;
    desk.click_at({button.x + 5.0F, button.y + 5.0F});
    EXPECT_TRUE(ui.has("matrices/V/r0c0")) << "C does not open the code";
    EXPECT_FALSE(ui.has("left/observer/observer view"));
    const ObserverParams before = params.observer;
    const Rect view = desk.layout().lower_left;
    desk.drag_from({view.min.x + 80.0F, view.min.y + 80.0F}, 60.0F, 20.0F);
    EXPECT_EQ(params.observer, before);
    cover({"code:display"});
    EXPECT_FALSE(draws("rotate(") || draws("perspective("));
}

TEST_F(StageTest, TheImageOfTheFollowedPointIsCoveredEverywhere) {
    open("mirror-derivation");
    params.follow = Follow{"box", 7};
    desk.settle();
    ASSERT_TRUE(desk.derived.followed);
    const std::string y = number_text(desk.derived.followed->mirrored_world.y, 3);
    cover({});
    EXPECT_TRUE(draws(y)) << y;
    cover({"follow:mirrored"});
    EXPECT_FALSE(draws(y)) << y;
    EXPECT_FALSE(draws("R p"));
    EXPECT_FALSE(records(y));
}

TEST_F(StageTest, OpenQuestionsHideWarningsAdviceAndFormulas) {
    open("depth-test-off");
    stage.asks = false;
    cover({});
    ASSERT_TRUE(ui.has("view/Fix"));
    EXPECT_NE(tooltip_of("projection/z-near").find("f/(f−n)"), std::string::npos);
    stage.asks = true;
    cover({});
    EXPECT_FALSE(ui.has("view/Fix"));
    for (const RecordedItem& item : desk.recorded()) EXPECT_FALSE(item.label.ends_with("/trouble")) << item.label;
    EXPECT_EQ(tooltip_of("projection/z-near").find("f/(f−n)"), std::string::npos);
    EXPECT_NE(tooltip_of("projection/z-near"), "");
}

// ---- pointed out -------------------------------------------------------------------------------------

TEST_F(StageTest, PointedOutPartsAreFramed) {
    highlight({"matrix:V[2][3]"});
    const RecordedItem frame = ui.find("highlight"), cell = ui.find("matrices/V/r2c3");
    EXPECT_LE(frame.min.x, cell.min.x);
    EXPECT_GE(frame.max.y, cell.max.y);
    EXPECT_LT(frame.max.x - frame.min.x, 1.3F * (cell.max.x - cell.min.x));
    const Params before = params;
    desk.drag("projection/z-near", 40.0F);
    EXPECT_NE(params.projection.near, before.projection.near) << "the layer of frames lets the pointer through";
    highlight({});
    EXPECT_FALSE(ui.has("highlight"));
}

TEST(StageAtSmallSizes, AControlIsScrolledIntoViewAndAFoldedSectionOpens) {
    Desk desk({1280, 720});
    for (const char* name : {"control:observer.distance", "control:slips.pole_flip",
                             "control:reflection.same_projection", "control:camera.position"}) {
        desk.workbench.stage.highlight = {name};
        desk.ui.frames(10);
        const auto& found = desk.workbench.widgets.targets.found;
        ASSERT_EQ(found.size(), 1U) << name;
        const Rect panel = desk.layout().panel;
        EXPECT_GE(found[0].min.y, panel.min.y) << name;
        EXPECT_LE(found[0].max.y, panel.max.y) << name;
        EXPECT_GE(found[0].max.y - found[0].min.y, 12.0F) << name << " is completely visible";
    }
    // The user may scroll away again.
    const float before = desk.ui.find("camera/position/x").min.y;
    desk.ui.move_to({60.0F, 400.0F});
    ImGui::GetIO().MouseWheel = -4.0F;
    desk.ui.frame();
    ImGui::GetIO().MouseWheel = 0.0F;
    desk.ui.frames(5);
    EXPECT_LT(desk.ui.find("camera/position/x").min.y, before - 20.0F);
}

TEST_F(StageTest, UnknownNamesAreIgnored) {
    highlight({"view:growth", "matrix:C"});
    EXPECT_EQ(missing(), (std::vector<std::string>{"view:growth", "matrix:C"}));
    EXPECT_FALSE(ui.has("highlight"));
}

/// Parts that need a GL context are exempt: tables of counted and read-back values.
TEST_F(StageTest, EveryNameOfTheVocabularyExistsOnScreen) {
    std::set<std::string> left;
    for (const std::string& name : target_names()) left.insert(name);
    for (const char* name : {"matrix:V[2][3]", "matrix:S[3]", "control:light.position[3]", "control:plane.equation[1]",
                             "control:camera.position[0]"})
        left.insert(name);
    const auto look = [&](const char* preset, auto change) {
        if (*preset != '\0') open(preset);
        change();
        stage.highlight.assign(left.begin(), left.end());
        stage.cover.clear();
        desk.settle();
        ui.frames(8);
        for (const auto& found : desk.workbench.widgets.targets.found) left.erase(found.name);
        // Items that may need scrolling are checked one by one.
        const std::set<std::string> all = left;
        for (const std::string& name : all) {
            if (!name.starts_with("code:") && !name.starts_with("call:") && !name.starts_with("text:") &&
                !name.starts_with("button:"))
                continue;
            highlight({name});
            if (missing().empty()) left.erase(name);
        }
    };
    look("", [] {});
    look("opening", [&] { params.follow = Follow{"box", 3}; });
    look("orthographic", [] {});
    look("opening", [&] { params.projection.type = ProjectionType::frustum; });
    for (std::size_t topic = 1; topic < names_of<Topic>().size(); ++topic)
        look("", [&] { choose_topic(params, Slot::left, static_cast<Topic>(topic)); });
    look("opening", [&] {
        choose_topic(params, Slot::left, Topic::passes);
        params.cull.enabled = true;
    });
    look("mirror-derivation", [] {});
    look("shadow-derivation", [] {});
    look("depth-test-off", [] {});
    look("depth-fighting", [&] { choose_topic(params, Slot::left, Topic::precision); });
    look("depth-near-cuts", [&] { choose_topic(params, Slot::left, Topic::precision); });
    look("painter-nearest-fails", [] {});
    look("bsp-walk", [] {});
    look("newell-cycle", [] {});
    look("rays-small", [] {});
    look("opening", [&] { desk.click("matrices/Show C"); });
    for (auto name = left.begin(); name != left.end();)
        name = name->starts_with("column:") || *name == "bar:pixel" || *name == "note:codes" || *name == "formulas" ||
                       *name == "links" || *name == "text:why.fault" || is_new_field(*name)
                   ? left.erase(name)
                   : std::next(name);
    std::string all;
    for (const std::string& name : left) all += name + "\n";
    EXPECT_EQ(all, "");
}

// ---- marked ------------------------------------------------------------------------------------------

TEST_F(StageTest, ATargetIsMarkedInTheCamerasAndTheObserversView) {
    cover({});
    EXPECT_FALSE(draws("right here"));
    stage.target = Stage::Target{{0.5, 0.4, 0.0}, "right here"};
    ui.frames(3);
    const std::string text = drawn();
    const std::size_t first = text.find("right here");
    ASSERT_NE(first, std::string::npos);
    EXPECT_NE(text.find("right here", first + 1), std::string::npos) << "in both views";
    stage.target->point_world = {0.0, 0.0, 500.0};  // behind the camera: an arrow at the edge shows the way
    ui.frames(3);
    EXPECT_TRUE(draws("right here"));
}

// ---- laid out ----------------------------------------------------------------------------------------

TEST_F(StageTest, ALayoutShowsOnlyTheListedMatricesAndControls) {
    params.view.layout = {ViewName::camera, {"C", "V", "follow"}, {"camera.position", "slips.swapped_order"}, {}};
    desk.settle();
    EXPECT_LT(ui.find("matrices/C/r0c0").min.y, ui.find("matrices/V/r0c0").min.y) << "in their order";
    EXPECT_FALSE(ui.has("matrices/S/r0c0") || ui.has("matrices/R/r0c0") || ui.has("matrices/P/r0c0"));
    EXPECT_TRUE(ui.has("camera/position/x"));
    for (const RecordedItem& item : desk.recorded()) {
        const bool is_listed = item.label.starts_with("camera/position") || item.label.find("T·R") != std::string::npos;
        EXPECT_TRUE(item.window != "panel" || is_listed) << item.label;
    }
    EXPECT_TRUE(desk.layout().lower_left.empty() && desk.layout().lower_right.empty());
    EXPECT_GT(desk.layout().camera.width(), 0.6F * 1600.0F);
    desk.drag("camera/position/x", 20.0F);
    EXPECT_NE(params.camera.position.x, CameraParams{}.position.x);
}

TEST_F(StageTest, AnEmptyListHidesTheColumn) {
    params.view.layout = {ViewName::camera, {"R"}, {}, {}};
    desk.settle();
    EXPECT_TRUE(desk.layout().panel.empty());
    EXPECT_FALSE(desk.layout().matrices.empty());
    params.view.layout = {ViewName::camera, {}, {"plane.equation"}, {}};
    desk.settle();
    EXPECT_FALSE(desk.layout().panel.empty());
    EXPECT_TRUE(desk.layout().matrices.empty());
    EXPECT_TRUE(ui.has("plane/equation/x") || ui.has("plane/equation/a"));
    params.view.layout = {ViewName::camera, {}, {}, {}};
    desk.settle();
    EXPECT_TRUE(desk.layout().panel.empty() && desk.layout().matrices.empty());
}

TEST_F(StageTest, EveryListableControlExists) {
    std::string none;
    for (const std::string& name : target_names()) {
        constexpr std::string_view control = "control:";
        if (!name.starts_with(control) || !find_field(name.substr(control.size()))) continue;
        const std::string path = name.substr(control.size());
        if (path == "view.shows") continue;  // in the view's heading
        if (is_new_field(name)) continue;
        params = Params{};
        if (path == "projection.height") params.projection.type = ProjectionType::orthographic;
        for (const char* edge : {"left", "right", "bottom", "top"})
            if (path == std::string("projection.") + edge) params.projection.type = ProjectionType::frustum;
        if (path == "visibility.sort_key") params.visibility.method = VisibilityMethod::painter;
        if (path == "visibility.exact_curves") params.visibility.method = VisibilityMethod::ray_cast;
        if (path == "visibility.step") params.visibility.method = VisibilityMethod::newell;
        for (const char* of_tree : {"visibility.splitter", "visibility.walk", "visibility.epsilon"})
            if (path == of_tree) params.visibility.method = VisibilityMethod::bsp;
        params.view.layout = {ViewName::camera, {}, {path}, {}};
        stage.highlight = {name};
        ui.frames(3);
        if (!missing().empty()) none += path + "\n";
    }
    EXPECT_EQ(none, "");
}

TEST_F(StageTest, KeysChangeTheStatesLayoutAndUndoRestoresIt) {
    desk.press(Key::f2);
    EXPECT_EQ(params.view.layout.folded, std::vector<std::string>{"panel"});
    EXPECT_TRUE(desk.layout().panel.empty());
    desk.press(Key::f3);
    EXPECT_EQ(params.view.layout.folded, (std::vector<std::string>{"panel", "matrices"}));
    ui.hover("view/camera view");
    desk.press(Key::m);
    EXPECT_EQ(params.view.layout.big, ViewName::camera);
    desk.undo();
    EXPECT_EQ(params.view.layout.big, ViewName::none);
    EXPECT_EQ(params.view.layout.folded, (std::vector<std::string>{"panel", "matrices"}));
    desk.press(Key::f2);
    EXPECT_EQ(params.view.layout.folded, std::vector<std::string>{"matrices"});
}

TEST_F(StageTest, APresetWithoutALayoutKeepsTheCurrentOne) {
    params.view.layout = {ViewName::camera, {"V"}, {}, {}};
    const LayoutParams chosen = params.view.layout;
    desk.session.open("tilted-plane");
    desk.settle();
    EXPECT_EQ(params.view.layout, chosen);
    EXPECT_FALSE(desk.session.departs_from_preset()) << "the layout does not count as a change";
}

}  // namespace
}  // namespace viewing::test
