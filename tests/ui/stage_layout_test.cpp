// The layout on stage: everything that a step names has a place, the main view is largest, and text is large enough.
#include <gtest/gtest.h>

#include <algorithm>

#include "desk.h"
#include "main_view.h"
#include "readable.h"
#include "trials.h"
#include "ui/parts/layout.h"
#include "ui/views/lower_view.h"

namespace viewing::test {
namespace {

const ImVec2 halls[] = {{1920, 1080}, {1280, 720}, {1024, 768}, {3840, 2160}};

Arrangement on_stage() {
    Arrangement arrangement;
    arrangement.presents = true;
    arrangement.telling = {1, 140.0F, 230.0F, 90.0F, 2, false};
    return arrangement;
}

Layout laid_out(ImVec2 room, const Arrangement& arrangement) {
    return lay_out(room, enlargement(room, 1.0F, arrangement), arrangement);
}

bool are_apart(const Rect& a, const Rect& b) {
    return a.max.x <= b.min.x || b.max.x <= a.min.x || a.max.y <= b.min.y || b.max.y <= a.min.y;
}

/// The parts of the window that a step names besides the camera's view.
struct Named {
    bool left, right, matrices, controls, vectors;
};
Named named(int bits) {
    return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0};
}

/// Every combination of parts, with few and with more controls, in each room, with short and long texts below.
template <typename Test>
void for_every_stage(const Test& test) {
    for (const ImVec2 room : halls)
        for (const float band : {0.25F, 0.4F, 0.5F})
            for (int bits = 0; bits < 64; ++bits) {
                const Named parts = named(bits);
                Arrangement arrangement = on_stage();
                arrangement.strip_px = band * room.y;
                if (bits >= 32) arrangement.telling.control_rows = 4;
                arrangement.stage = {parts.left, parts.right, {440.0F, 150.0F}, {360.0F, 150.0F}};
                arrangement.matrices_folded = !parts.matrices;
                arrangement.panel_folded = !parts.controls;
                arrangement.telling.has_vectors = parts.vectors;
                SCOPED_TRACE(::testing::Message()
                             << room.x << "×" << room.y << ", band " << band << ", parts " << bits);
                test(room, parts, laid_out(room, arrangement));
            }
}

TEST(StageLayout, HasAPlaceForEverythingThatAStepNames) {
    for_every_stage([](ImVec2 room, const Named& parts, const Layout& layout) {
        EXPECT_FALSE(layout.camera.empty());
        EXPECT_EQ(layout.lower_left.empty(), !parts.left);
        EXPECT_EQ(layout.lower_right.empty(), !parts.right);
        EXPECT_EQ(layout.matrices.empty(), !parts.matrices);
        EXPECT_EQ(layout.panel.empty(), !parts.controls);
        const Rect all[] = {layout.camera, layout.lower_left, layout.lower_right, layout.matrices, layout.panel};
        for (std::size_t a = 0; a < std::size(all); ++a) {
            EXPECT_LE(all[a].max.x, room.x);
            EXPECT_LE(all[a].max.y, layout.strip.min.y);
            for (std::size_t b = 0; b < a; ++b) {
                const bool is_plate = layout.panel_over_picture && &all[a] == &all[4] && b == 0;
                EXPECT_TRUE(is_plate || all[a].empty() || all[b].empty() || are_apart(all[a], all[b]))
                    << a << " and " << b;
            }
        }
        if (!layout.panel_over_picture) return;
        EXPECT_TRUE(layout.camera.contains(layout.panel.min) && layout.camera.contains(layout.panel.max));
        const bool is_alone = !parts.left && !parts.right && !parts.matrices;
        EXPECT_LE(area_of(layout.panel), area_of(layout.camera) / (is_alone ? 8.0F : 3.0F));
    });
}

TEST(StageLayout, GivesTheMainViewTheMost) {
    for_every_stage([](ImVec2 room, const Named& parts, const Layout& layout) {
        const bool is_wide = room.x > 1.5F * room.y;
        const float share = layout.camera.width() * layout.camera.height() / (room.x * layout.strip.min.y);
        EXPECT_GE(share, is_wide ? 0.43F : 0.36F);
        const bool has_column = parts.left || parts.right || parts.matrices;
        if (!has_column) {
            EXPECT_GE(share, !parts.controls || layout.panel_over_picture ? 0.85F : is_wide ? 0.55F : 0.45F);
        }
    });
}

/// Controls are at the lower right of the stage, or of the picture if they are on a plate over it.
TEST(StageLayout, ControlsAreAtTheLowerRight) {
    for_every_stage([](ImVec2 room, const Named& parts, const Layout& layout) {
        if (!parts.controls) return;
        EXPECT_TRUE(layout.panel_over_picture || layout.panel.min.x >= layout.camera.max.x);
        EXPECT_GE(layout.panel.max.x,
                  layout.panel_over_picture ? layout.camera.max.x - 0.02F * room.x : 0.96F * room.x);
        EXPECT_NEAR(layout.panel.max.y, layout.camera.max.y, 0.03F * room.y);
        if (layout.panel_over_picture) return;
        for (const Rect& other : {layout.lower_left, layout.lower_right, layout.matrices})
            EXPECT_TRUE(other.empty() || layout.panel.min.y >= other.max.y);
    });
}

TEST(StageLayout, ViewsShrinkBeforeMatricesAndControls) {
    Arrangement arrangement = on_stage();
    arrangement.stage = {true, false, {360.0F, 150.0F}, {}};
    arrangement.telling.control_rows = 4;
    const ImVec2 room(1280, 720);
    const float scale = enlargement(room, 1.0F, arrangement);
    arrangement.strip_px = room.y - 420.0F * scale;
    const Layout layout = laid_out(room, arrangement);
    EXPECT_GE(layout.matrices.height(), 139.0F * scale);
    EXPECT_GE(layout.panel.height(), 121.0F * scale);
    EXPECT_LT(layout.lower_left.height(), 149.0F * scale);
    EXPECT_GT(layout.lower_left.height(), 80.0F * scale);
}

/// If a column is too short for its views and two controls, the controls move to a plate over the picture, and the
/// views keep their height as long as the column has room for them.
TEST(StageLayout, ControlsLeaveACrowdedColumn) {
    Arrangement arrangement = on_stage();
    arrangement.matrices_folded = true;
    arrangement.stage = {true, true, {440.0F, 150.0F}, {440.0F, 150.0F}};
    const ImVec2 room(1280, 720);
    const float scale = enlargement(room, 1.0F, arrangement);
    for (const float height : {270.0F, 360.0F, 390.0F, 420.0F, 450.0F, 480.0F}) {
        arrangement.strip_px = room.y - height * scale;
        const Layout layout = laid_out(room, arrangement);
        EXPECT_EQ(layout.panel_over_picture, height < 440.0F) << height;
        EXPECT_EQ(layout.column_fits, height > 300.0F) << height;
        EXPECT_TRUE(!layout.column_fits || layout.lower_right.height() >= 105.0F * scale) << height;
    }
}

/// A lesson's sentences and the entries of matrices are 1/30 of the window's height; nothing is below 1/40.
TEST(StageLayout, TypeIsLargeEnoughForTheBackRow) {
    const Arrangement arrangement = on_stage();
    const TypeSizes type = type_sizes(arrangement);
    for (const ImVec2 room : halls)
        for (const float scale : {1.0F, 1.3F, 2.0F}) {
            const float pixels = scale * enlargement(room, scale, arrangement);
            EXPECT_NEAR(type.caption * pixels, room.y / 30.0F, 0.01F * room.y / 30.0F);
            EXPECT_GE(type.matrix * pixels, room.y / 31.0F);
            EXPECT_GE(std::min({type.small, 16.0F}) * pixels, room.y / 40.0F);
        }
}

// ---- the stage without a lesson ----------------------------------------------------------------------------------

class FreeStage : public ::testing::Test {
protected:
    static void enter(Desk& desk) {
        desk.press(Key::f5);
        desk.apply_looks();
        desk.ui.move_to({-1, -1});
        desk.ui.frames(5);
    }
    static void expect_good_stages(ImVec2 room, Language language) {
        const bool is_wide = room.x > 1.5F * room.y;
        Desk desk(room);
        desk.params().ui.language = language;
        enter(desk);
        std::size_t index = 0;
        for (const NamedFile& preset : presets()) {
            if (preset.sets_looks || !testing::takes(index++)) continue;
            SCOPED_TRACE(::testing::Message() << preset.name << " " << room.x << "×" << room.y);
            desk.session.open(preset.name);
            desk.settle();
            desk.ui.frames(4);
            ASSERT_TRUE(desk.workbench.presenter.is_on());
            const Layout layout = desk.layout();
            ASSERT_FALSE(layout.caption.empty());
            EXPECT_GE(layout.caption.min.y, layout.camera.max.y);
            const Rect hero{layout.camera.min, layout.beside.empty() ? layout.camera.max : layout.beside.max};
            EXPECT_GE(hero.width() * hero.height() / (room.x * layout.caption.min.y), is_wide ? 0.5F : 0.4F);
            // The preset's own view is there and legible, whatever is beside it.
            const Slot own = telling_slot(desk.params());
            const Rect& own_view = own == Slot::left ? layout.lower_left : layout.lower_right;
            const float lowest = lower_view(desk.params(), own).lowest * desk.workbench.widgets.scale;
            EXPECT_TRUE(desk.params().view.layout.big != ViewName::none || own_view.height() >= 0.95F * lowest);
            std::size_t entries = 0;
            for (const RecordedItem& item : desk.recorded()) {
                const bool is_entry =
                    item.window.find("matrices") != std::string::npos && item.label.find("/r") != std::string::npos;
                if (!is_entry) continue;
                ++entries;
                EXPECT_TRUE(item.min.y >= layout.matrices.min.y && item.max.y <= layout.matrices.max.y + 1.0F &&
                            item.max.x <= room.x)
                    << item.label << " is not whole";
            }
            EXPECT_EQ(entries % 16, 0U);
            EXPECT_EQ(entries == 0, layout.matrices.empty());
            // In a narrow hall a lower view may be narrower than its longest lines.
            for (const std::string& text : unreadable(desk))
                if (is_wide || !text.starts_with("lower views")) ADD_FAILURE() << text;
        }
    }
};

/// The main view takes up at least half of a wide stage's area above the caption; matrices are shown in full, and no
/// text is cut off.
TEST_F(FreeStage, EveryPresetFitsAWideStage) {
    expect_good_stages({1920, 1080}, Language::en);
}
TEST_F(FreeStage, EveryPresetFitsANarrowStage) {
    expect_good_stages({1024, 768}, Language::en);
}
TEST_F(FreeStage, EveryPresetFitsANarrowStageInKorean) {
    expect_good_stages({1024, 768}, Language::ko);
}

/// Its sentence and its caption compare the mirror's fovy with the camera's.
TEST_F(FreeStage, AMirrorWithItsOwnFovyKeepsTheLens) {
    Desk desk({1024, 768});
    enter(desk);
    desk.session.open("mirror-other-fovy");
    desk.settle();
    EXPECT_EQ(desk.workbench.stage.least_aspect, 0.0);
    desk.session.open("mirror-xz");
    desk.settle();
    EXPECT_GT(desk.workbench.stage.least_aspect, 1.0);
}

TEST_F(FreeStage, F5AndEscapeLeadThereAndBackWithNothingChanged) {
    Desk desk({1280, 720}, "shadow-anti");
    const Params before = desk.params();
    const Layout window = desk.layout();
    for (const Key leaves : {Key::f5, Key::escape}) {
        enter(desk);
        EXPECT_TRUE(desk.workbench.presenter.is_on());
        EXPECT_TRUE(desk.layout().top_bar.empty() || desk.layout().top_bar.height() < 1.0F);
        EXPECT_TRUE(desk.ui.has("matrices/S/r0c0"));
        EXPECT_FALSE(desk.ui.has("matrices/P/r0c0"));
        desk.press(leaves);
        desk.apply_looks();
        desk.ui.frames(3);
        EXPECT_FALSE(desk.workbench.presenter.is_on());
        EXPECT_EQ(desk.params(), before);
        EXPECT_FALSE(desk.session.can_undo());
        EXPECT_EQ(desk.layout().camera.max.x, window.camera.max.x);
        EXPECT_EQ(desk.layout().camera.max.y, window.camera.max.y);
    }
}

TEST_F(FreeStage, HasTheKeysOfALessonsStage) {
    Desk desk({1280, 720}, "walk");
    enter(desk);
    PresenterMode& presenter = desk.workbench.presenter;
    const Params before = desk.params();
    for (const Key blank : {Key::b, Key::period, Key::comma}) {
        desk.press(blank);
        EXPECT_TRUE(presenter.is_blank());
        desk.press(Key::space);
        EXPECT_FALSE(presenter.is_blank());
    }
    desk.press(Key::p);
    EXPECT_TRUE(presenter.is_frozen());
    desk.press(Key::p);
    desk.press(Key::i);
    EXPECT_TRUE(presenter.takes_mouse());
    desk.press(Key::escape);
    EXPECT_FALSE(presenter.takes_mouse());
    EXPECT_TRUE(presenter.is_on()) << "the first Escape removes the ink";
    desk.press(Key::t);
    EXPECT_TRUE(presenter.has_running_clock());
    desk.press(Key::l);
    EXPECT_EQ(desk.params(), before);
    desk.press(Key::page_down);
    desk.settle();
    EXPECT_EQ(desk.session.preset()->name, "walk-slows") << "a clicker goes on to the next preset";
    EXPECT_TRUE(presenter.is_on());
}

/// Ink and a blank screen keep the mouse from the views, which a drag would otherwise turn before the audience.
TEST_F(FreeStage, InkAndBlankScreensKeepTheMouseFromTheViews) {
    Desk desk({1280, 720}, "opening");
    enter(desk);
    desk.ui.frames(3);
    const Params before = desk.params();
    const Layout layout = desk.layout();
    const auto middle = [](const Rect& rect) {
        return ImVec2((rect.min.x + rect.max.x) * 0.5F, (rect.min.y + rect.max.y) * 0.5F);
    };
    const auto drag_all = [&] {
        for (const Rect* view : {&layout.camera, &layout.lower_right, &layout.matrices})
            for (const int button : {0, 1, 2}) desk.drag_from(middle(*view), 60.0F, 30.0F, 5, button);
        desk.ui.frames(2);
    };
    for (const Key key : {Key::i, Key::b, Key::comma}) {
        desk.press(key);
        ASSERT_TRUE(desk.workbench.presenter.takes_mouse());
        drag_all();
        EXPECT_EQ(desk.params(), before) << "key " << static_cast<int>(key);
        desk.press(key);
        desk.ui.frames(2);
        ASSERT_FALSE(desk.workbench.presenter.takes_mouse());
    }
    drag_all();
    EXPECT_NE(desk.params(), before) << "without them, the mouse turns the views again";
}

/// While X is held, the state before the latest edit is shown; the key leaves no trace.
TEST_F(FreeStage, XComparesWithTheStateBefore) {
    Desk desk({1280, 720}, "walk");
    desk.params().projection.fovy = 20.0;
    desk.ui.frames(3);
    enter(desk);
    const Params edited = desk.params();
    desk.hold(Key::x);
    desk.ui.frames(3);
    EXPECT_NE(desk.params().projection.fovy, 20.0);
    desk.let_go(Key::x);
    desk.ui.frames(3);
    EXPECT_EQ(desk.params(), edited);
    desk.undo();
    EXPECT_NE(desk.params().projection.fovy, 20.0);
    EXPECT_FALSE(desk.session.can_undo()) << "holding X adds no undo step";
}

}  // namespace
}  // namespace viewing::test
