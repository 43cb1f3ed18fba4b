// Numbers and formulas as text, the contrast and hues of the palettes, and labels in a view.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "widget_test.h"

namespace widgets::test {
namespace {

TEST(NumberText, FixedDecimalsAndRealSigns) {
    EXPECT_EQ(viewing::number_text(5.2, 3), "5.200");
    EXPECT_EQ(viewing::number_text(-2.6, 3), "−2.600");
    EXPECT_EQ(viewing::number_text(0.0, 3), "0.000");
    EXPECT_EQ(viewing::number_text(-0.0, 3), "0.000");
    EXPECT_EQ(viewing::number_text(-1e-17, 3), "0.000");
    EXPECT_EQ(viewing::number_text(9.9996, 3), "10.000");
    EXPECT_EQ(viewing::number_text(7.0, 0), "7");
    EXPECT_EQ(viewing::number_text(999999.0, 1), "999999.0");
}

TEST(NumberText, ExponentsAndNonNumbers) {
    EXPECT_EQ(viewing::number_text(1.2341e8, 3), "1.234·10⁸");
    EXPECT_EQ(viewing::number_text(-1e12, 0), "−1·10¹²");
    EXPECT_EQ(viewing::number_text(7.92e-6, 2), "7.92·10⁻⁶");
    EXPECT_EQ(viewing::number_text(std::nan(""), 3), "—");
    EXPECT_EQ(viewing::number_text(std::numeric_limits<double>::infinity(), 3), "∞");
    EXPECT_EQ(viewing::number_text(-std::numeric_limits<double>::infinity(), 3), "−∞");
    EXPECT_EQ(viewing::number_text(std::numeric_limits<double>::max(), 3), "1.798·10³⁰⁸");
    EXPECT_FALSE(viewing::number_text(std::numeric_limits<double>::max(), 400).empty());
}

TEST(ParseNumber, AcceptsWhatUsersType) {
    EXPECT_EQ(ParseNumber("1e-3"), 0.001);
    EXPECT_EQ(ParseNumber("−2"), -2.0);
    EXPECT_EQ(ParseNumber("1e−3"), 0.001);
    EXPECT_EQ(ParseNumber("  +4,5 "), 4.5);
    EXPECT_EQ(ParseNumber("30.6°", "°"), 30.6);
    EXPECT_EQ(ParseNumber("−7.51·10⁻⁶"), -7.51e-6);
    EXPECT_EQ(ParseNumber("1·10¹² °", "°"), 1e12);
    for (const char* junk : {"·10²", "2·10", "2·10⁻", "2·102", "2·10²3", "2e1·10²", "2·10²·10²"}) {
        EXPECT_EQ(ParseNumber(junk), std::nullopt) << junk;
    }
    for (const char* junk : {"", " ", "abc", "1.2.3", "1e", "+-1", "+−1", "--1", "nan", "inf", "1e999", "0x10", "1 2",
                             "11111111111111111111111111111111111111111111111111111111111111111111111111"}) {
        EXPECT_EQ(ParseNumber(junk), std::nullopt) << junk;
    }
}

TEST(ParseNumber, ShownNumbersReadBack) {
    const std::uint32_t seed = 5;
    SCOPED_TRACE("seed 5");
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> exponent(-12, 300), sign(-1, 1);
    for (int i = 0; i < 500; ++i) {
        const double value = std::copysign(std::pow(10.0, exponent(random)), sign(random));
        const std::optional<double> read = ParseNumber(viewing::number_text(value, 15));
        ASSERT_TRUE(read) << viewing::number_text(value, 15);
        EXPECT_NEAR(*read / value, 1.0, std::abs(value) < 1e-9 ? 1.0 : 1e-6) << viewing::number_text(value, 15);
    }
}

class TextTest : public WidgetTest {
protected:
    ImVec2 size_of(const char* formula) {
        ImVec2 size;
        start([&] {
            static constexpr LetterRole roles[] = {{'l', Role::light}, {'n', Role::plane}};
            const ImVec2 measured = Formula(nullptr, ImVec2(0, 0), formula, roles, IM_COL32_WHITE);
            size = Formula(ImGui::GetWindowDrawList(), ImVec2(10, 10), formula, roles, IM_COL32_WHITE);
            EXPECT_EQ(measured.x, size.x);
            EXPECT_EQ(measured.y, size.y);
            return false;
        });
        return size;
    }
    bool drew(ImU32 color) {
        for (const ImDrawVert& vertex : ImGui::GetDrawData()->CmdLists[0]->VtxBuffer) {
            if (vertex.col == color) return true;
        }
        return false;
    }
};

TEST_F(TextTest, SubscriptsAndSuperscriptsAreSmallerAndOverlapNoSigns) {
    const float l = size_of("l").x, x = size_of("x").x;
    EXPECT_GT(size_of("l_x").x, l);
    EXPECT_LT(size_of("l_x").x, l + x);
    EXPECT_FLOAT_EQ(size_of("l_x").x, size_of("l^x").x);
    EXPECT_FLOAT_EQ(size_of("l_{xx}").x, l + 2.0F * (size_of("l_x").x - l));
    EXPECT_GT(size_of("l_x").y, size_of("l").y);
    EXPECT_FLOAT_EQ(size_of("l_x n_y").x, size_of("l_x").x + size_of("n_y").x + size_of("l").y * 0.12F);
}

TEST_F(TextTest, WordsKeepTheirSpaces) {
    const float blank = size_of("| |").x - size_of("||").x;
    const float thin = size_of("R T").x - size_of("RT").x;
    EXPECT_LT(thin, blank);
    for (const auto& [spaced, joined] : std::initializer_list<std::pair<const char*, const char*>>{
             {"T in", "Tin"}, {"in T", "inT"}, {"n of", "nof"}, {"in place", "inplace"}, {"n^2 of", "n^2of"}}) {
        EXPECT_FLOAT_EQ(size_of(spaced).x - size_of(joined).x, blank) << spaced;
    }
}

TEST_F(TextTest, LettersTakeTheirRolesColorAndWordsDoNot) {
    size_of("n_x");
    EXPECT_TRUE(drew(context.palette.plane));
    EXPECT_FALSE(drew(context.palette.light));
    EXPECT_FALSE(drew(IM_COL32_WHITE)) << "a subscript takes its letter's color";
    size_of("-l_x");
    EXPECT_TRUE(drew(context.palette.light));
    EXPECT_TRUE(drew(IM_COL32_WHITE)) << "the sign has the base color";
    size_of("normal");
    EXPECT_FALSE(drew(context.palette.plane));
}

TEST_F(TextTest, JunkIsDrawnWithoutACrash) {
    const std::string longest(5000, 'x');
    std::string many_pieces;
    for (int i = 0; i < 500; ++i) many_pieces += "l_xn^2";
    for (const char* junk : {"",
                             "_",
                             "^",
                             "{",
                             "}",
                             "_{",
                             "^{x",
                             "a_",
                             "a^",
                             "__",
                             "_^_^",
                             "a_{}",
                             "\xFF",
                             "\xE2\x88",
                             "_\xE2",
                             "\xC3",
                             "a_\xF0\x9F\x98\x80",
                             "   ",
                             " l ",
                             longest.c_str(),
                             many_pieces.c_str()}) {
        const ImVec2 size = size_of(junk);
        EXPECT_GE(size.x, 0.0F);
        EXPECT_GT(size.y, 0.0F);
    }
    EXPECT_GT(size_of("_").x, 0.0F) << "a lone sign is shown as it is";
}

float hue_deg(ImU32 color) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(color);
    float h = 0, s = 0, v = 0;
    ImGui::ColorConvertRGBtoHSV(c.x, c.y, c.z, h, s, v);
    return h * 360.0F;
}

TEST(Palette, EveryThemeIsReadableAndKeepsTheHues) {
    constexpr Role roles[] = {Role::light, Role::plane, Role::camera, Role::mirror, Role::point, Role::trouble};
    for (const ThemeKind theme : {ThemeKind::dark, ThemeKind::light, ThemeKind::projector}) {
        const Palette& palette = palette_of(theme);
        if (theme != ThemeKind::dark) {
            EXPECT_GE(hue_deg(palette.point) - hue_deg(palette.light), 35.0F) << "p and s";
            EXPECT_GE(hue_deg(palette.light) - hue_deg(palette.trouble), 14.0F);
        }
        for (const ImU32 ground : {palette.ground, palette.raised, palette.field, palette.view_ground}) {
            EXPECT_GE(contrast(palette.text, ground), 7.0);
            EXPECT_GE(contrast(palette.quiet, ground), 4.5);
            for (const Role role : roles) {
                EXPECT_GE(contrast(palette.of(role), ground), 3.0);
                // Dark yellow and dark amber both look brown, so the light themes move these two hues farther apart.
                const float turned = role == Role::light || role == Role::point ? 22.0F : 3.0F;
                EXPECT_NEAR(hue_deg(palette.of(role)), hue_deg(palette_of(ThemeKind::dark).of(role)), turned);
            }
        }
    }
}

using ViewTest = WidgetTest;

bool overlap(const RecordedItem& a, const RecordedItem& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

TEST_F(ViewTest, LabelsNeverCoverEachOther) {
    const std::uint32_t seed = 11;
    SCOPED_TRACE("seed 11");
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> across(0, 1280), down(0, 800);
    std::vector<ImVec2> points;
    std::vector<std::string> texts;
    for (int i = 0; i < 200; ++i) {
        points.emplace_back(across(random), down(random));
        texts.push_back("s_" + std::to_string(i % 10) + " = S p");
    }
    const ImVec2 forbidden_min(300, 300), forbidden_max(500, 400);
    int placed = 0;
    start([&] {
        static constexpr LetterRole roles[] = {{'p', Role::point}};
        LabelPlacer placer(ImGui::GetForegroundDrawList(), ImVec2(0, 0), ImVec2(1280, 800));
        placer.Avoid(forbidden_min, forbidden_max);
        placed = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool fits = placer.Place(points[i], texts[i].c_str(), IM_COL32_WHITE,
                                           i % 2 ? std::span<const LetterRole>(roles) : std::span<const LetterRole>());
            placed += fits ? 1 : 0;
        }
        return false;
    });
    EXPECT_GE(placed, 190) << "nearly all fit";
    ASSERT_EQ(context.recorded.size(), static_cast<std::size_t>(placed));
    const RecordedItem forbidden{"", "", forbidden_min, forbidden_max, true, ""};
    for (std::size_t i = 0; i < context.recorded.size(); ++i) {
        const RecordedItem& label = context.recorded[i];
        EXPECT_FALSE(overlap(label, forbidden));
        EXPECT_TRUE(label.min.x >= 0 && label.min.y >= 0 && label.max.x <= 1280 && label.max.y <= 800);
        for (std::size_t j = i + 1; j < context.recorded.size(); ++j) EXPECT_FALSE(overlap(label, context.recorded[j]));
    }
}

/// Labels avoid lines where there is enough space; elsewhere, the plate behind a label keeps it readable.
TEST_F(ViewTest, LabelsKeepOffLines) {
    std::mt19937 random(34);
    std::uniform_real_distribution<float> across(150, 1100), down(150, 650);
    const ImVec2 from(across(random), 0), to(across(random), 800);
    start([&] {
        LabelPlacer placer(ImGui::GetForegroundDrawList(), ImVec2(0, 0), ImVec2(1280, 800));
        placer.AvoidLine(from, to);
        for (int i = 0; i < 30; ++i) {  // some points lie on the line
            const float y = down(random), on_line = from.x + (to.x - from.x) * y / 800.0F;
            placer.Place(ImVec2(i % 2 ? on_line : across(random), y), "near plane", IM_COL32_WHITE);
        }
        return false;
    });
    ASSERT_GE(context.recorded.size(), 25U);
    for (const RecordedItem& label : context.recorded)
        for (int i = 0; i <= 8000; ++i) {
            const float share = static_cast<float>(i) / 8000.0F;
            const ImVec2 at(from.x + (to.x - from.x) * share, 800.0F * share);
            ASSERT_FALSE(at.x > label.min.x && at.x < label.max.x && at.y > label.min.y && at.y < label.max.y);
        }
}

TEST_F(ViewTest, AFullViewDropsLabels) {
    int placed = 0;
    start([&] {
        LabelPlacer placer(ImGui::GetForegroundDrawList(), ImVec2(0, 0), ImVec2(100, 70));
        placed = 0;
        for (int i = 0; i < 50; ++i) placed += placer.Place(ImVec2(50, 35), "label", IM_COL32_WHITE) ? 1 : 0;
        return false;
    });
    EXPECT_GT(placed, 0);
    EXPECT_LT(placed, 10);
}

TEST_F(ViewTest, ATooltipShowsAllItsLines) {
    start([] {
        Button("S");
        Tooltip("Title", "body", "a = b; c = d", "glFlush", {}, "shadow.lift");
        Button("empty");
        Tooltip("", "");
        return false;
    });
    ui.hover("S");
    ui.frames(10);
    EXPECT_FALSE(ui.has("tooltip")) << "not immediately";
    ui.frames(60);
    EXPECT_EQ(ui.text_of("tooltip"), "Title\nbody\na = b; c = d\nglFlush\nshadow.lift");
    ui.hover("empty");
    ui.frames(60);
    EXPECT_FALSE(ui.has("tooltip"));
}

TEST_F(ViewTest, SentencesAreRecorded) {
    start([] {
        Trouble("The light lies in the plane.");
        Note("24-bit depth");
        ValueText("p = (1, 2)", Role::point);
        PlateText(ImGui::GetForegroundDrawList(), ImVec2(10, 10), IM_COL32_WHITE, "n");
        return false;
    });
    EXPECT_EQ(ui.text_of("trouble"), "The light lies in the plane.");
    EXPECT_EQ(ui.text_of("note"), "24-bit depth");
    EXPECT_EQ(ui.text_of("value"), "p = (1, 2)");
}

}  // namespace
}  // namespace widgets::test
