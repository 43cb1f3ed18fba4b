// Each tooltip of the panel has its control's visible label as its title and names the path that --set takes. In the
// formulas, words keep their spaces, and the fonts have every character.
#include <regex>

#include "desk.h"
#include "widgets/inner.h"

namespace viewing::test {
namespace {

std::string tooltip_of(Desk& desk, const char* label) {
    desk.ui.hover(label);
    desk.ui.frames(60);
    for (const RecordedItem& item : desk.recorded()) {
        if (item.label.ends_with("tooltip")) return item.text;
    }
    return {};
}

TEST(Tooltips, ShowTheLabelAsTitleAndThePathBelow) {
    Desk desk;
    struct Expected {
        const char *item, *title, *path;
    };
    for (const Expected& expected : {Expected{"shadow/Clip to patch", "Clip to patch", "shadow.clip_to_receiver"},
                                     Expected{"reflection/Mirror light", "Mirror light", "reflection.reflect_light"},
                                     Expected{"projection/z-near", "z-near", "projection.near"},
                                     Expected{"depth/func", "depth function", "depth.func"}}) {
        const std::string text = tooltip_of(desk, expected.item);
        EXPECT_TRUE(text.starts_with(std::string(expected.title) + "\n")) << expected.item << ": " << text;
        EXPECT_TRUE(text.ends_with(std::string("\n") + expected.path)) << expected.item << ": " << text;
    }
}

const RecordedItem* shown_tooltip(const Desk& desk) {
    const auto found =
        std::ranges::find_if(desk.recorded(), [](const RecordedItem& item) { return item.label.ends_with("tooltip"); });
    return found == desk.recorded().end() ? nullptr : &*found;
}

/// A tooltip covers neither its control nor the next one; if the control is in a column, the tooltip is beside the
/// column.
TEST(Tooltips, AppearBesideTheirColumn) {
    Desk desk({1600, 900});
    for (const char* label :
         {"camera/navigation/Orbit", "projection/z-near", "depth/Depth test", "matrices/S/r0c0", "matrices/V/r2c3"}) {
        const std::string text = tooltip_of(desk, label);
        const RecordedItem* tooltip = shown_tooltip(desk);
        ASSERT_TRUE(tooltip) << label << ": " << text;
        const Rect column = *desk.area_of(desk.ui.find(label));
        EXPECT_TRUE(tooltip->min.x >= column.max.x || tooltip->max.x <= column.min.x) << label;
        EXPECT_GE(tooltip->min.x, 0.0F) << label;
        EXPECT_LE(tooltip->max.x, 1600.0F) << label;
        EXPECT_LE(tooltip->max.y, 900.0F) << label;
    }
    // This also holds when the column takes nearly half of the window.
    Desk small({800, 600});
    small.params().ui.theme = Theme::projector;
    small.apply_looks();
    small.ui.frames(3);
    tooltip_of(small, "projection/type/Perspective");
    ASSERT_TRUE(shown_tooltip(small));
    EXPECT_GE(shown_tooltip(small)->min.x, small.layout().panel.max.x);
    EXPECT_LE(shown_tooltip(small)->max.x, 800.0F);
}

TEST(Tooltips, AppearBelowTheItemsOfABar) {
    Desk desk({1600, 900});
    tooltip_of(desk, "top/next preset");
    const RecordedItem* below = shown_tooltip(desk);
    ASSERT_TRUE(below);
    EXPECT_GE(below->min.y, desk.ui.find("top/next preset").max.y);
    desk.ui.frames(2);
}

TEST(Tooltips, AppearAtRestAndStayAwayAfterAClick) {
    Desk desk({1600, 900});
    desk.ui.hover("depth/Depth test");
    desk.ui.frames(20);
    EXPECT_FALSE(shown_tooltip(desk)) << "after a third of a second";
    for (int i = 0; i < 60; ++i) desk.ui.hover("depth/Depth test", 0.3F + 0.005F * static_cast<float>(i));
    EXPECT_FALSE(shown_tooltip(desk)) << "while the pointer moves";
    desk.ui.frames(40);
    EXPECT_TRUE(shown_tooltip(desk));
    desk.ui.press();
    desk.ui.release();
    desk.ui.frames(60);
    EXPECT_FALSE(shown_tooltip(desk)) << "a click hides it";
    desk.ui.hover("depth/Cull face");
    desk.ui.hover("depth/Depth test");
    desk.ui.frames(60);
    EXPECT_TRUE(shown_tooltip(desk));
}

TEST(Tooltips, AreHiddenWhileTyping) {
    Desk desk({1600, 900});
    desk.ui.double_click("projection/z-near");
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    desk.ui.hover("projection/z-far");
    desk.ui.frames(60);
    EXPECT_FALSE(shown_tooltip(desk));
    desk.ui.key(ImGuiKey_Enter);
    desk.ui.hover("projection/z-near");
    desk.ui.frames(60);
    EXPECT_TRUE(shown_tooltip(desk));
}

/// Covers every disabled control outside the panel, in states that disable many.
TEST(Tooltips, DisabledControlsSayWhy) {
    int greyed = 0;
    for (const char* state : {"opening", "painter-cycle", "depth-cells"}) {
        Desk desk({1600, 1500}, state);
        desk.ui.frames(4);
        std::vector<RecordedItem> items;
        for (const RecordedItem& item : desk.recorded())
            if (!item.enabled && item.window != "panel") items.push_back(item);
        for (const RecordedItem& item : items) {
            desk.ui.move_to({-1, -1});
            desk.ui.move_to({(item.min.x + item.max.x) * 0.5F, (item.min.y + item.max.y) * 0.5F});
            desk.ui.frames(40);
            EXPECT_TRUE(shown_tooltip(desk)) << state << ": " << item.window << ": " << item.label;
            ++greyed;
        }
    }
    EXPECT_GT(greyed, 4);
}

TEST(Tooltips, SegmentsAndPlaneButtonsHaveOne) {
    Desk desk;
    for (const char* item : {"projection/type/Perspective", "projection/type/Orthographic", "light/position/point",
                             "light/position/parallel", "plane/equation/yz", "plane/equation/xz", "plane/equation/xy",
                             "plane/equation/Normalize"}) {
        EXPECT_FALSE(tooltip_of(desk, item).empty()) << item;
    }
}

TEST(Tooltips, WordsInFormulasKeepTheirSpaces) {
    Desk desk;
    desk.ui.frame();
    for (const Field& field : fields()) {
        const std::string formula(field.formula);
        const widgets::inner::FormulaLayout layout(formula.c_str(), {}, 0, {desk.workbench.widgets.fonts.text, 16.0F});
        const std::string drawn(layout.text, static_cast<std::size_t>(layout.bytes));
        const std::regex word(" ?\\b[A-Za-z]{2,}\\b ?");
        for (std::sregex_iterator found(formula.begin(), formula.end(), word), end; found != end; ++found) {
            EXPECT_NE(drawn.find(found->str()), std::string::npos) << field.path << ": " << drawn;
        }
        EXPECT_LT(layout.bytes, widgets::inner::FormulaLayout::max_bytes) << field.path;
        EXPECT_LT(layout.piece_count, widgets::inner::FormulaLayout::max_pieces) << field.path;
    }
}

/// Returns the characters of a text for which the font has no glyph.
std::string missing_in(ImFont& font, std::string_view text) {
    std::string missing;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        unsigned code = bytes == 1 ? lead : lead & (0x7FU >> bytes);
        for (std::size_t k = 1; k < bytes; ++k) code = (code << 6U) | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
        if (code != '\n' && !font.FindGlyphNoFallback(static_cast<ImWchar>(code))) missing += text.substr(i, bytes);
        i += bytes;
    }
    return missing;
}

TEST(Tooltips, TheFontsHaveEverySignOfFieldsAndNumbers) {
    Desk desk;
    const widgets::Fonts& fonts = desk.workbench.widgets.fonts;
    for (const Field& field : fields()) {
        EXPECT_EQ(missing_in(*fonts.heading, field.label), "") << field.path;
        for (const std::string_view text : {field.help, field.formula, field.unit})
            EXPECT_EQ(missing_in(*fonts.text, text), "") << field.path;
        EXPECT_EQ(missing_in(*fonts.number, field.gl_call), "") << field.path;
        EXPECT_EQ(missing_in(*fonts.small_number, field.path), "") << field.path;
    }
    for (ImFont* font : {fonts.text, fonts.heading, fonts.note, fonts.number, fonts.small_number})
        EXPECT_EQ(missing_in(*font, "0123456789.−·⁻⁰¹²³⁴⁵⁶⁷⁸⁹°—∞"), "");
}

TEST(Tooltips, TheMinusIsWiderThanAHyphen) {
    Desk desk;
    for (ImFont* font : {desk.workbench.widgets.fonts.number, desk.workbench.widgets.fonts.small_number}) {
        const ImFontGlyph &minus = *font->FindGlyph(0x2212), &hyphen = *font->FindGlyph('-');
        EXPECT_GE(minus.X1 - minus.X0, hyphen.X1 - hyphen.X0);
        EXPECT_EQ(minus.AdvanceX, font->FindGlyph('0')->AdvanceX);
    }
}

}  // namespace
}  // namespace viewing::test
