// Numbers and sliders under real input: dragging, typing, resetting and clamping. Displaying a number never changes it.
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "widget_test.h"
#include "widgets/inner.h"

namespace widgets::test {
namespace {

using NumberTest = WidgetTest;

TEST_F(NumberTest, DragChangesByStepPerPixel) {
    double value = 3.9;
    start([&] { return Number("x", value, {.step = 0.02, .decimals = 2}); });
    ui.drag("x", 50);
    EXPECT_DOUBLE_EQ(value, 4.9);
    EXPECT_EQ(changes, 5);
    ui.drag("x", -100);
    EXPECT_DOUBLE_EQ(value, 2.9);
}

TEST_F(NumberTest, DragInDesignPixels) {
    double value = 0.0;
    context.scale = 2.0F;
    start([&] { return Number("x", value, {.step = 0.01}); });
    ui.drag("x", 100);
    EXPECT_DOUBLE_EQ(value, 0.5);
}

TEST_F(NumberTest, ShiftIsCoarseAltIsFine) {
    double value = 0.0;
    start([&] { return Number("x", value, {.step = 0.01}); });
    ImGui::GetIO().KeyShift = true;
    ui.drag("x", 10);
    EXPECT_DOUBLE_EQ(value, 1.0);
    ImGui::GetIO().KeyShift = false;
    ImGui::GetIO().KeyAlt = true;
    ui.drag("x", 10);
    ImGui::GetIO().KeyAlt = false;
    EXPECT_DOUBLE_EQ(value, 1.001);
}

TEST_F(NumberTest, ClicksAndTinyMovesChangeNothing) {
    double value = 1.5;
    start([&] { return Number("x", value, {.step = 0.1}); });
    ui.click("x");
    ui.drag("x", 2, 0, 1);
    EXPECT_EQ(value, 1.5);
    EXPECT_EQ(changes, 0);
}

TEST_F(NumberTest, DragStopsAtTheRangeAndReturnsImmediately) {
    double value = 0.9;
    start([&] { return Number("x", value, {.min = 0, .max = 1, .step = 0.01}); });
    ui.hover("x");
    const ImVec2 from = ImGui::GetIO().MousePos;
    ui.press();
    ui.move_to(ImVec2(from.x + 200, from.y));
    EXPECT_EQ(value, 1.0);
    ui.move_to(ImVec2(from.x + 190, from.y));
    EXPECT_DOUBLE_EQ(value, 0.9);
    ui.release();
}

TEST_F(NumberTest, LogarithmicDragMultiplies) {
    double value = 0.001;
    start([&] { return Number("near", value, {.min = 1e-4, .max = 1e6, .decimals = 4, .logarithmic = true}); });
    ui.drag("near", 232);  // 1.01^232 = 10.06
    EXPECT_NEAR(value, 0.01006, 0.00002);
    ui.drag("near", -232);
    EXPECT_NEAR(value, 0.001, 0.000002);
}

TEST_F(NumberTest, DragKeepsAnItemActiveForUndo) {
    double value = 0.0;
    start([&] { return Number("x", value, {}); });
    ui.hover("x");
    EXPECT_FALSE(ui.any_item_active());
    ui.press();
    EXPECT_TRUE(ui.any_item_active());
    ui.move_to(ImVec2(ImGui::GetIO().MousePos.x + 20, ImGui::GetIO().MousePos.y));
    EXPECT_TRUE(ui.any_item_active());
    ui.release();
    EXPECT_FALSE(ui.any_item_active());
}

TEST_F(NumberTest, DoubleClickTypesAndEnterCommits) {
    double value = 2.0;
    start([&] { return Number("x", value, {.step = 0.02}); });
    ui.double_click("x");
    ui.type(
        "\xE2\x88\x92"
        "1.25e1");
    EXPECT_EQ(changes, 0) << "nothing changes before Enter";
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(value, -12.5);
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(ui.text_of("x"), "−12.50");
}

/// If the undo steps of an earlier edit remained, ImGui would apply them to another text and crash the program.
TEST_F(NumberTest, UndoWhileTypingIgnoresEarlierEdits) {
    double value = 2.0;
    start([&] { return Number("x", value, {.step = 0.02}); });
    const auto undo = [&] {
        ImGui::GetIO().KeyCtrl = true;
        ui.key(ImGuiKey_Z);
        ImGui::GetIO().KeyCtrl = false;
    };
    ui.double_click("x");
    ui.type("123456789012345");
    ui.type("1");
    ui.key(ImGuiKey_Escape);
    ui.double_click("x");
    undo();
    undo();
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(value, 2.0);
}

TEST_F(NumberTest, CtrlClickTypesAndClamps) {
    double value = 2.0;
    start([&] { return Number("x", value, {.min = 0, .max = 10, .unit = "°"}); });
    ui.ctrl_click("x");
    ui.type("400°");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(value, 10.0);
}

TEST_F(NumberTest, EscapeCancelsAndAClickElsewhereCommits) {
    double value = 2.0;
    start([&] {
        const bool changed = Number("x", value, {});
        ImGui::InvisibleButton("elsewhere", ImVec2(100, 100));
        Record("elsewhere");
        return changed;
    });
    ui.ctrl_click("x");
    ui.type("7");
    ui.key(ImGuiKey_Escape);
    EXPECT_EQ(value, 2.0);
    for (const char* junk : {"seven", "", "1e999", "nan", "inf", "3 4", "--3"}) {
        ui.ctrl_click("x");
        ui.key(ImGuiKey_Delete);
        ui.type(junk);
        ui.key(ImGuiKey_Enter);
        EXPECT_EQ(value, 2.0) << junk;
    }
    EXPECT_EQ(changes, 0);
    ui.ctrl_click("x");
    ui.type("8");
    ui.click("elsewhere");
    EXPECT_EQ(value, 8.0);
}

TEST_F(NumberTest, TabMovesToTheNextNumberAndBack) {
    glm::dvec3 value{1, 2, 3};
    start([&] { return Vec3("position", value, {}); });
    ui.ctrl_click("position/x");
    ui.type("10");
    ui.key(ImGuiKey_Tab);
    ui.type("20");
    ui.key(ImGuiKey_Tab);
    ui.type("30");
    ui.key(ImGuiKey_Tab, true);
    ui.type("25");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(value, glm::dvec3(10, 25, 30));
    ui.frames(20);
    EXPECT_LT(RedrawIn(context), 0.0F) << "no frame is due";
}

TEST_F(NumberTest, RightClickResets) {
    glm::dvec3 value{1, 2, 3};
    start([&] { return Vec3("position", value, {}, {7, 8, 9}); });
    ui.right_click("position/y");
    EXPECT_EQ(value, glm::dvec3(1, 8, 3));
    EXPECT_EQ(changes, 1);
    ui.right_click("position/y");
    EXPECT_EQ(changes, 1) << "the value is already the default";
}

TEST_F(NumberTest, DisplayingNeverChangesTheValue) {
    const double inf = std::numeric_limits<double>::infinity();
    for (const double start_value : {0.123456789, -5.0, 1e9, 0.0, -0.0, 1e-300, inf, std::nan("")}) {
        double number = start_value, slider = start_value, log_slider = start_value;
        start([&] {
            bool changed = Number("n", number, {.min = 0, .max = 1});
            changed |= Slider("s", slider, {.min = 0, .max = 1});
            changed |= Slider("l", log_slider, {.min = 0.01, .max = 10, .logarithmic = true});
            return changed;
        });
        ui.hover("n");
        ui.frames(10);
        EXPECT_EQ(changes, 0);
        for (const double shown : {number, slider, log_slider}) {
            EXPECT_EQ(std::memcmp(&shown, &start_value, sizeof shown), 0) << start_value;
        }
    }
}

TEST_F(NumberTest, OpeningTheTextFieldDoesNotClamp) {
    double value = 5.0;
    start([&] { return Number("x", value, {.min = 0, .max = 1}); });
    ui.ctrl_click("x");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(value, 5.0);
    EXPECT_EQ(changes, 0);
}

TEST_F(NumberTest, WholeNumbers) {
    double value = 2.0;
    start([&] { return Number("n", value, {.min = 0, .max = 8, .step = 0.05, .integer = true}); });
    ui.drag("n", 33);
    EXPECT_EQ(value, 4.0);
    ui.ctrl_click("n");
    ui.type("6.6");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(value, 7.0);
    EXPECT_EQ(ui.text_of("n"), "7");
}

TEST_F(NumberTest, DisabledNumbersIgnoreInput) {
    double value = 2.0;
    start([&] {
        ImGui::BeginDisabled();
        const bool changed = Number("x", value, {});
        ImGui::EndDisabled();
        return changed;
    });
    EXPECT_FALSE(ui.find("x").enabled);
    ui.drag("x", 40);
    ui.right_click("x");
    ui.double_click("x");
    EXPECT_EQ(value, 2.0);
}

TEST_F(NumberTest, TheTextFitsItsBox) {
    const std::uint32_t seed = 7;
    SCOPED_TRACE("seed 7");
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> exponent(-8, 11), sign(-1, 1);
    double value = 0.0;
    float width = 100.0F;
    start([&] { return Number("x", value, {.decimals = 3, .unit = "°", .logarithmic = false}, width); });
    for (int i = 0; i < 300; ++i) {
        value = std::copysign(std::pow(10.0, exponent(random)), sign(random));
        width = static_cast<float>(48 + i % 60);
        ui.frame();
        const RecordedItem& item = ui.find("x");
        const float smallest = ImGui::GetFont()->CalcTextSizeA(10.5F, FLT_MAX, 0.0F, item.text.c_str()).x;
        EXPECT_LE(smallest, item.max.x - item.min.x) << item.text;
    }
}

TEST_F(NumberTest, SliderFollowsThePointer) {
    double value = 0.25;
    start([&] { return Slider("s", value, {.min = 0, .max = 1, .decimals = 2}, 212); });
    ui.drag("s", 0, 0, 1, 0.5F);  // a press in the middle
    EXPECT_NEAR(value, 0.5, 0.005);
    ui.drag("s", 500);
    EXPECT_EQ(value, 1.0);
    ui.drag("s", -500);
    EXPECT_EQ(value, 0.0);
    ui.right_click("s");
    EXPECT_EQ(value, 0.0);
}

TEST_F(NumberTest, SliderKnobDoesNotJumpWhenTouched) {
    double value = 0.4321;
    start([&] { return Slider("s", value, {.min = 0, .max = 1, .decimals = 2}, 200); });
    ui.drag("s", 0, 0, 1, (6.0F + 0.4321F * 188.0F) / 200.0F);
    EXPECT_EQ(value, 0.4321);
    EXPECT_EQ(changes, 0);
}

TEST_F(NumberTest, LogarithmicSliderIsSpacedByDecades) {
    double value = 1.0;
    start([&] { return Slider("s", value, {.min = 0.01, .max = 100, .decimals = 2, .logarithmic = true}, 212); });
    ui.drag("s", 50);  // a quarter of the 200 pixels is one of four decades
    EXPECT_NEAR(value, 10.0, 0.2);
}

TEST_F(NumberTest, DoubleClickOnASliderEditsTheOldValue) {
    double value = 0.2;
    start([&] { return Slider("s", value, {.min = 0, .max = 1, .decimals = 2}, 212); });
    ui.double_click("s");
    EXPECT_EQ(value, 0.2);
    ui.type("0.75");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(value, 0.75);
}

TEST_F(NumberTest, TheTextFieldStartsWithPlainNotation) {
    double value = 0.0;
    start([&] { return Slider("s", value, {.min = -1e12, .max = 1e12, .decimals = 1}, 212); });
    for (const auto& [number, text] : std::initializer_list<std::pair<double, const char*>>{{40.0, "40"},
                                                                                            {0.5, "0.5"},
                                                                                            {0.001, "0.001"},
                                                                                            {-30.6, "-30.6"},
                                                                                            {1e6, "1000000"},
                                                                                            {1234567.25, "1234567.25"},
                                                                                            {1e-6, "0.000001"},
                                                                                            {1e9, "1e+09"},
                                                                                            {0.0, "0"}}) {
        value = number;
        ui.ctrl_click("s");
        EXPECT_STREQ(context.editing.text, text);
        ui.key(ImGuiKey_Escape);
        EXPECT_EQ(value, number);
    }
}

TEST_F(NumberTest, ARowSharesDecimalsAndKeepsThemWhenASignAppears) {
    glm::dvec3 value{0.0, 1.0, -0.7234};
    start([&] { return Vec3("n", value, {.decimals = 3}); });
    for (float width = 130.0F; width < 320.0F; width += 7.0F) {
        show = [&, width] {
            ImGui::SetNextItemWidth(width);
            return Vec3("n", value, {.decimals = 3});
        };
        std::size_t decimals[2][3] = {};
        for (const double sign : {1.0, -1.0}) {
            value = {0.0, 1.0 * sign, -0.7234 * sign};
            ui.frames(2);
            for (int i = 0; i < 3; ++i) {
                const std::string text = ui.text_of(std::string("n/") + "xyz"[i]);
                decimals[sign < 0.0][i] = text.size() - text.find('.') - 1;
            }
        }
        for (const auto& of_sign : decimals) {
            for (const std::size_t count : of_sign) EXPECT_EQ(count, decimals[0][0]) << "width " << width;
        }
    }
    value = {0.0, 1e9, 0.5};  // a number that cannot fit does not reduce the others' decimals
    show = [&] {
        ImGui::SetNextItemWidth(250.0F);
        return Vec3("n", value, {.decimals = 3});
    };
    ui.frames(2);
    EXPECT_EQ(ui.text_of("n/z"), "0.500");
    EXPECT_EQ(ui.text_of("n/y"), "1.000·10⁹");
}

TEST_F(NumberTest, ANarrowRowShrinksBeforeItLosesDigits) {
    glm::dvec3 value{0.15, -0.15, 12.25};
    float width = 0.0F;
    start([&] {
        ImGui::SetNextItemWidth(width);
        return Vec3("n", value, {.decimals = 2});
    });
    // From the narrowest row that still shows both decimals of 0.15 to a row as wide as the panel's.
    for (width = 150.0F; width < 260.0F; width += 5.0F) {
        ui.frames(2);
        EXPECT_EQ(ui.text_of("n/x"), "0.15") << width;
        EXPECT_EQ(ui.text_of("n/y"), "−0.15") << width;
        EXPECT_EQ(ui.text_of("n/z"), "12.25") << width;
    }
}

TEST_F(NumberTest, TypingReachesBeyondTheSlider) {
    double value = 0.5;
    start([&] {
        const NumberStyle style{
            .min = 1e-6, .max = 1e6, .drag_min = 0.001, .drag_max = 100.0, .decimals = 3, .logarithmic = true};
        return Slider("near", value, style, 212);
    });
    const auto enter = [&](const char* text) {
        ui.double_click("near");
        ui.type(text);
        ui.key(ImGuiKey_Enter);
    };
    enter("2e-6");
    EXPECT_EQ(value, 2e-6);
    enter("1e9");
    EXPECT_EQ(value, 1e6) << "the field's own end";
    ui.drag("near", -400.0F);
    EXPECT_EQ(value, 0.001) << "the slider's end";
    ui.drag("near", 600.0F, 0.0F, 5, 0.03F);
    EXPECT_EQ(value, 100.0);
}

TEST_F(NumberTest, TheKnobIsBehindTheNumberAndFullHeight) {
    double value = 0.5;
    start([&] { return Slider("s", value, {.min = 0, .max = 1, .decimals = 3}, 200); });
    const RecordedItem item = ui.find("s");
    const ImU32 knob = inner::Mix(context.palette.field, context.palette.accent, 0.6F);
    const auto knob_extent = [&] {
        float top = 1e9F, bottom = -1e9F;
        for (const ImDrawVert& vertex : ImGui::GetDrawData()->CmdLists[0]->VtxBuffer) {
            if (vertex.col != knob) continue;
            top = std::min(top, vertex.pos.y);
            bottom = std::max(bottom, vertex.pos.y);
        }
        return bottom - top;
    };
    const float height = item.max.y - item.min.y;
    EXPECT_GT(knob_extent(), height - 5.0F);
    const ImVector<ImDrawVert>& vertices = ImGui::GetDrawData()->CmdLists[0]->VtxBuffer;
    int last_knob = -1, first_digit = -1;
    for (int i = 0; i < vertices.Size; ++i) {
        if (vertices[i].col == knob) last_knob = i;
        if (vertices[i].col == context.palette.text && first_digit < 0) first_digit = i;
    }
    EXPECT_GE(last_knob, 0);
    EXPECT_GT(first_digit, last_knob);
}

TEST_F(NumberTest, TypingEndsWhenTheNumberDisappears) {
    double value = 2.0;
    bool visible = true;
    start([&] { return visible && Number("x", value, {}); });
    ui.ctrl_click("x");
    ui.type("9");
    visible = false;
    ui.frames(3);
    visible = true;
    ui.frames(3);
    EXPECT_EQ(value, 2.0);
    EXPECT_EQ(context.editing.typing, 0U);
}

}  // namespace
}  // namespace widgets::test
