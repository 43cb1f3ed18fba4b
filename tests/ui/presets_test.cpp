// The window's controls for the open preset: its caption, its title in the list, the back button, the searchable list,
// and the next preset.
#include <filesystem>

#include "desk.h"
#include "text/catalogue.h"
#include "ui/window/preset_picker.h"

namespace viewing::test {
namespace {

class PresetsTest : public ::testing::Test {
protected:
    Desk desk{{1600, 900}, "walk"};
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;

    std::string shown() const { return ui.text_of("top/preset"); }
    void down(int times, ImGuiKey key = ImGuiKey_DownArrow) {
        for (int i = 0; i < times; ++i) ui.key(key);
    }
};

TEST_F(PresetsTest, TheCaptionIsBelowThePicture) {
    const Layout layout = desk.layout();
    ASSERT_FALSE(layout.caption.empty());
    EXPECT_GE(layout.caption.min.y, layout.camera.max.y);
    EXPECT_LE(layout.caption.max.y, layout.lower_left.min.y - layout.header_height);
    EXPECT_FALSE(layout.caption_is_folded);
    EXPECT_TRUE(ui.has("caption/text"));
    EXPECT_FALSE(ui.has("caption/restore"));
}

/// To be readable from the last row of a hall with 200 seats, text needs at least 1/50 of the picture's height.
TEST_F(PresetsTest, TheCaptionIsReadableFromTheBackRow) {
    params.ui.theme = Theme::projector;
    desk.apply_looks();
    ui.frames(3);
    EXPECT_GE(desk.workbench.widgets.fonts.caption->FontSize, 900.0F / 50.0F);
    EXPECT_FALSE(desk.layout().caption_is_folded);
}

TEST_F(PresetsTest, AnyEditMarksThePresetAsChangedAndResetRestoresIt) {
    const Params as_opened = params;
    EXPECT_EQ(shown(), "Walking while looking down");
    const float top = desk.layout().camera.max.y;
    desk.click("depth/Cull face");
    EXPECT_TRUE(desk.session.departs_from_preset());
    EXPECT_EQ(shown(), "Walking while looking down (changed)");
    EXPECT_EQ(desk.layout().camera.max.y, top) << "marking the preset as changed moves nothing";
    ui.click("caption/restore");
    EXPECT_EQ(params, as_opened);
    EXPECT_EQ(shown(), "Walking while looking down");
    EXPECT_FALSE(ui.has("caption/restore"));
    desk.undo();
    EXPECT_TRUE(params.cull.enabled);
    EXPECT_TRUE(desk.session.departs_from_preset());
}

TEST_F(PresetsTest, ThemeAndScaleBelongToTheUser) {
    params.ui = {Theme::light, 1.2};
    ui.frames(2);
    EXPECT_FALSE(desk.session.departs_from_preset());
    params.cull.enabled = true;
    ui.frames(2);
    ui.click("caption/restore");
    EXPECT_EQ(params.ui.theme, Theme::light);
    EXPECT_EQ(params.ui.scale, 1.2);
    EXPECT_FALSE(params.cull.enabled);
}

TEST_F(PresetsTest, FixingMarksThePresetAsChanged) {
    Desk broken({1600, 900}, "shadow-anti");
    ASSERT_FALSE(broken.session.departs_from_preset());
    broken.ui.click("view/Fix");
    broken.ui.frames(2);
    EXPECT_TRUE(broken.ui.has("caption/restore"));
}

TEST_F(PresetsTest, UndoAndRedoRestoreThePreset) {
    desk.click("depth/Cull face");
    desk.press(Key::page_down);
    desk.settle();
    EXPECT_EQ(desk.session.preset()->name, "walk-slows");
    desk.undo();
    desk.settle();
    EXPECT_EQ(shown(), "Walking while looking down (changed)");
    desk.redo();
    desk.settle();
    EXPECT_EQ(shown(), "Walking slows");
}

TEST_F(PresetsTest, StatesWithoutAPresetHaveNoCaption) {
    desk.clipboard = "{}";
    desk.press_with(Key::ctrl, Key::v);
    desk.settle();
    EXPECT_EQ(desk.session.preset(), nullptr);
    EXPECT_TRUE(desk.layout().caption.empty());
    EXPECT_EQ(shown(), "choose…");
    EXPECT_FALSE(ui.find("top/previous preset").enabled);
    ui.click("top/next preset");
    desk.settle();
    EXPECT_EQ(desk.session.preset()->name, "opening");
}

TEST_F(PresetsTest, TheCaptionFoldsWithAKeyAndAClick) {
    const float picture = desk.layout().camera.height();
    desk.press(Key::c);
    EXPECT_TRUE(desk.layout().caption_is_folded);
    EXPECT_GE(desk.layout().camera.height(), picture);
    ui.click("caption/text");
    EXPECT_FALSE(desk.layout().caption_is_folded);
    desk.press(Key::c);
    EXPECT_TRUE(desk.layout().caption_is_folded);
}

TEST(Caption, TakesAtMostAThirdOfThePictureUnlessUnfolded) {
    for (const char* preset : {"fighting-offset", "opening", "mirror-oblique-depth"})
        for (const ImVec2 size : {ImVec2(800, 600), ImVec2(1280, 720), ImVec2(1600, 900)}) {
            const Desk desk(size, preset);
            const Layout layout = desk.layout();
            EXPECT_LE(layout.caption.height(), 0.5F * layout.camera.height()) << preset << " " << size.x;
        }
    Desk small({800, 600}, "fighting-offset");
    EXPECT_TRUE(small.layout().caption_is_folded);
    small.press(Key::c);
    EXPECT_FALSE(small.layout().caption_is_folded);
}

TEST_F(PresetsTest, NextAndPreviousSkipPresetsThatSetTheLooks) {
    std::vector<NamedFile> all = presets();
    const std::size_t setting_looks =
        std::erase_if(all, [](const NamedFile& preset) { return load_state(preset.name)->params.ui != UiParams{}; });
    ASSERT_EQ(setting_looks, 2U) << "light-theme and projector";
    const UiParams own{.theme = Theme::light, .scale = 1.1};
    params.ui = own;
    while (ui.find("top/previous preset").enabled) {
        ui.click("top/previous preset");
        desk.settle();
    }
    EXPECT_EQ(desk.session.preset()->name, all.front().name);
    desk.press(Key::page_up);
    EXPECT_EQ(desk.session.preset()->name, all.front().name) << "no preset precedes the first";
    for (std::size_t i = 1; i < all.size(); ++i) {
        desk.press(Key::page_down);
        desk.settle();
        ASSERT_EQ(desk.session.preset()->name, all[i].name);
        ASSERT_EQ(params.ui, own) << all[i].name;
    }
    EXPECT_FALSE(ui.find("top/next preset").enabled);
}

/// The appearance that the preset `projector` sets lasts only while it is open.
TEST_F(PresetsTest, APresetsLooksEndWithIt) {
    desk.session.open("projector");
    desk.settle();
    ASSERT_EQ(params.ui.theme, Theme::projector);
    desk.press(Key::page_down);
    desk.settle();
    EXPECT_EQ(desk.session.preset()->name, "camera-plus-ten") << "the lecture's next preset";
    EXPECT_EQ(params.ui.theme, Theme::dark);
}

// ---- the list ----------------------------------------------------------------------------------------------------

TEST_F(PresetsTest, TheListOpensAtTheCurrentOne) {
    desk.click("top/preset");
    ui.frames(3);
    const RecordedItem row = ui.find("top/walk"), search = ui.find("top/search");
    EXPECT_EQ(desk.workbench.wanted_preset_picture(), "walk");
    EXPECT_GT(row.min.y, search.max.y);
    EXPECT_LT(row.max.y, 900.0F);
}

TEST_F(PresetsTest, TypingFiltersArrowsMoveAndEnterOpensIt) {
    desk.click("top/preset");
    ui.frames(3);
    ui.type("polygon OFFSET");
    ui.frames(2);
    EXPECT_FALSE(ui.has("top/walk"));
    ASSERT_TRUE(ui.has("top/fighting-offset"));
    ASSERT_TRUE(ui.has("top/fighting-offset-too-much"));
    const std::string first = desk.workbench.wanted_preset_picture();
    down(1);
    EXPECT_NE(desk.workbench.wanted_preset_picture(), first);
    down(1, ImGuiKey_UpArrow);
    EXPECT_EQ(desk.workbench.wanted_preset_picture(), first);
    ui.key(ImGuiKey_Enter);
    desk.settle();
    EXPECT_EQ(desk.session.preset()->name, first);
    EXPECT_FALSE(ui.has("top/search"));
    EXPECT_EQ(desk.workbench.wanted_preset_picture(), "");
}

TEST(PresetList, ALongTitleTakesTwoLines) {
    Desk desk({800, 600}, "fighting-reversed-clip-range");
    desk.params().ui.theme = Theme::projector;
    desk.params().ui.scale = 1.2;
    desk.apply_looks();
    desk.click("top/preset");
    desk.ui.frames(3);
    const RecordedItem list = desk.ui.find("top/search"), row = desk.ui.find("top/fighting-reversed-clip-range"),
                       brief = desk.ui.find("top/fighting-offset");
    EXPECT_GT(row.max.y - row.min.y, 1.5F * (brief.max.y - brief.min.y));
    EXPECT_LE(row.max.x, list.max.x + 1.0F);
}

TEST_F(PresetsTest, TitlesRankBeforeSentences) {
    desk.click("top/preset");
    ui.frames(3);
    ui.type("mirror");
    ui.frames(2);
    EXPECT_TRUE(ui.has("top/room")) << "its sentence mentions mirrors";
    EXPECT_EQ(desk.workbench.wanted_preset_picture(), "observer-rays") << "titled Rays, mirrored eye, image space";
}

TEST_F(PresetsTest, ASlidesNumberFindsItsPresets) {
    desk.click("top/preset");
    ui.frames(3);
    ui.type("s23");
    ui.frames(2);
    for (const char* name : {"top/mirror-yz", "top/mirror-xz", "top/mirror-xy"}) EXPECT_TRUE(ui.has(name)) << name;
    EXPECT_FALSE(ui.has("top/walk"));
    EXPECT_EQ(desk.workbench.wanted_preset_picture(), "mirror-yz");
}

TEST_F(PresetsTest, EscapeClosesTheListAndChangesNothing) {
    const Params before = params;
    desk.click("top/preset");
    ui.frames(3);
    ui.type("mirror");
    down(2);
    desk.press(Key::escape);
    ui.frames(2);
    EXPECT_FALSE(ui.has("top/search"));
    EXPECT_EQ(params, before);
    EXPECT_EQ(desk.session.preset()->name, "walk");
}

TEST_F(PresetsTest, AnEmptyResultIsReportedAndEnterDoesNothing) {
    desk.click("top/preset");
    ui.frames(3);
    ui.type("qqq");
    ui.frames(2);
    EXPECT_TRUE(ui.has("top/note"));
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(desk.session.preset()->name, "walk");
}

TEST_F(PresetsTest, CtrlZWorksWhileAListIsOpen) {
    for (const char* list : {"top/scene", "top/preset"}) {
        SCOPED_TRACE(list);
        params.cull.enabled = true;
        ui.frames(2);
        desk.click(list);
        ui.frames(2);
        desk.undo();
        EXPECT_FALSE(params.cull.enabled);
        desk.press(Key::escape);
    }
    desk.click("top/preset");
    ui.frames(3);
    params.cull.enabled = true;
    ui.type("mirror");
    desk.undo();
    EXPECT_TRUE(params.cull.enabled) << "the field undoes its own typing";
}

TEST(PresetSearch, FindsWordsOfTitleSentenceNameAndTopicInAnyOrder) {
    NamedFile preset;
    preset.name = "anti-1";
    preset.title = "Anti-shadow";
    preset.about = "Behind the light.";
    preset.group = "Shadow";
    for (const char* search : {"", "anti", "ANTI light", "light behind", "shadow", " anti  ", "anti-1 shadow"})
        EXPECT_TRUE(is_found(preset, search)) << search;
    for (const char* search : {"mirror", "anti mirror"}) EXPECT_FALSE(is_found(preset, search)) << search;
}

// ---- notices and the scale of the window ----------------------------------------------------------------------------

TEST_F(PresetsTest, NoticesExpireAndErrorsStay) {
    desk.press_with(Key::ctrl, Key::c);
    EXPECT_FALSE(desk.session.message.text.empty());
    EXPECT_GT(message_ends_in_s(desk.session.message), 0.0);
    ui.frame(5.0F);
    EXPECT_FALSE(desk.session.message.text.empty());
    ui.frame(5.0F);
    EXPECT_TRUE(desk.session.message.text.empty());
    desk.session.message = {"saved, after the window slept for long"};
    ui.frame(50.0F);
    EXPECT_FALSE(desk.session.message.text.empty()) << "it has just been shown";
    ui.frame(50.0F);
    EXPECT_TRUE(desk.session.message.text.empty());
    desk.session.message = {"broken", true};
    EXPECT_LT(message_ends_in_s(desk.session.message), 0.0);
    ui.frame(50.0F);
    EXPECT_EQ(desk.session.message.text, "broken");
}

TEST_F(PresetsTest, CtrlPlusMinusAndZeroScaleTheWindow) {
    desk.hold(Key::ctrl);
    desk.hold(Key::plus);
    EXPECT_EQ(params.ui.scale, 1.1);
    EXPECT_EQ(desk.requests.chosen_scale, 1.1);
    desk.let_go(Key::plus);
    desk.press(Key::minus);
    desk.press(Key::minus);
    EXPECT_EQ(params.ui.scale, 0.9);
    for (int i = 0; i < 20; ++i) desk.press(Key::minus);
    EXPECT_EQ(params.ui.scale, 0.5);
    desk.press(Key::zero);
    EXPECT_EQ(params.ui.scale, 1.0);
    desk.let_go(Key::ctrl);
}

}  // namespace
}  // namespace viewing::test
