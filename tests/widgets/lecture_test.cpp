// Planes, lights and matrices under real input: planes and lights never become degenerate, matrices show their rows as
// on the slides, and links work in both directions.
#include <array>

#include "widget_test.h"

namespace widgets::test {
namespace {

using LectureTest = WidgetTest;

TEST_F(LectureTest, PlaneButtons) {
    glm::dvec4 plane{0, 1, 0, 2};
    start([&] { return PlaneEquation("equation", plane, {0, 1, 0, 0}); });
    ui.click("equation/yz");
    EXPECT_EQ(plane, glm::dvec4(1, 0, 0, 0));
    ui.click("equation/xy");
    EXPECT_EQ(plane, glm::dvec4(0, 0, 1, 0));
    ui.click("equation/xz");
    EXPECT_EQ(plane, glm::dvec4(0, 1, 0, 0));
    EXPECT_EQ(changes, 3);
    ui.click("equation/xz");
    EXPECT_EQ(changes, 3) << "the plane is already this one";
}

TEST_F(LectureTest, PlaneNormalize) {
    glm::dvec4 plane{0, 3, 4, 10};
    start([&] { return PlaneEquation("equation", plane, {0, 1, 0, 0}); });
    EXPECT_TRUE(ui.find("equation/Normalize").enabled);
    ui.click("equation/Normalize");
    EXPECT_NEAR(glm::length(plane - glm::dvec4(0, 0.6, 0.8, 2)), 0.0, 1e-15);
    ui.frame();
    EXPECT_FALSE(ui.find("equation/Normalize").enabled);
}

TEST_F(LectureTest, PlaneNormalIsNeverZero) {
    glm::dvec4 plane{0, 0.3, 0, 1};
    start([&] {
        const bool changed = PlaneEquation("equation", plane, {0, 1, 0, 0});
        EXPECT_GT(glm::length(glm::dvec3(plane)), 0.0);
        return changed;
    });
    ui.ctrl_click("equation/b");
    ui.type("0");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(plane, glm::dvec4(0, 0.3, 0, 1));
    EXPECT_EQ(changes, 0);
    ui.right_click("equation/a");
    EXPECT_EQ(changes, 0);
    ui.drag("equation/b", -60, 0, 60);  // through zero, pixel by pixel
    EXPECT_NEAR(plane.y, -0.3, 1e-12);
    ui.ctrl_click("equation/d");
    ui.type("0");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(plane.w, 0.0) << "d may be zero";
}

TEST_F(LectureTest, LightSwitchesBetweenPointAndParallel) {
    glm::dvec4 light{1, 2, 3, 1};
    start([&] { return Light("position", light, {2.6, 5.2, 2.2, 1}); });
    EXPECT_EQ(ui.text_of("position/point"), "on");
    ui.click("position/parallel");
    EXPECT_EQ(light, glm::dvec4(1, 2, 3, 0));
    ui.ctrl_click("position/w");
    ui.type("0.5");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(light.w, 0.5);
    EXPECT_EQ(ui.text_of("position/point"), "off");
    EXPECT_EQ(ui.text_of("position/parallel"), "off");
    ui.click("position/point");
    EXPECT_EQ(light, glm::dvec4(1, 2, 3, 1));
    ui.right_click("position/y");
    EXPECT_EQ(light, glm::dvec4(1, 5.2, 3, 1));
}

TEST_F(LectureTest, LightIsNeverAllZero) {
    glm::dvec4 light{0, 0.2, 0, 0};
    start([&] { return Light("position", light, {2.6, 5.2, 2.2, 1}); });
    ui.ctrl_click("position/y");
    ui.type("0");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(light, glm::dvec4(0, 0.2, 0, 0));
    EXPECT_EQ(changes, 0);
    light = {0, 0, 0, 1};
    ui.frame();
    EXPECT_FALSE(ui.find("position/parallel").enabled);
    ui.click("position/parallel");
    ui.ctrl_click("position/w");
    ui.type("0");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(light, glm::dvec4(0, 0, 0, 1));
}

/// Returns a matrix that holds 10 r + c in row r and column c, both counted from 1 as on the slides.
glm::dmat4 numbered_rows() {
    return glm::transpose(glm::dmat4(11, 12, 13, 14, 21, 22, 23, 24, 31, 32, 33, 34, 41, 42, 43, 44));
}

TEST_F(LectureTest, MatrixShowsRows) {
    const glm::dmat4 value = numbered_rows();
    start([&] {
        Matrix("S", value, {.decimals = 1});
        return false;
    });
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            const std::string cell = "S/r" + std::to_string(row) + "c" + std::to_string(column);
            const std::string expected = std::to_string(row + 1) + std::to_string(column + 1) + ".0";
            EXPECT_EQ(ui.text_of(cell), expected) << cell;
            if (row > 0) {
                const std::string above = "S/r" + std::to_string(row - 1) + "c" + std::to_string(column);
                EXPECT_GE(ui.find(cell).min.y, ui.find(above).max.y);
            }
            if (column > 0) {
                const std::string left = "S/r" + std::to_string(row) + "c" + std::to_string(column - 1);
                EXPECT_GE(ui.find(cell).min.x, ui.find(left).max.x);
            }
        }
    }
}

TEST_F(LectureTest, MatrixEditsTheEntryOfItsRow) {
    glm::dmat4 value = numbered_rows();
    start([&] { return Matrix("S", value, {.editable = true}); });
    ui.frames(10);
    EXPECT_EQ(changes, 0);
    ui.ctrl_click("S/r0c3");
    ui.type("-7");
    ui.key(ImGuiKey_Enter);
    EXPECT_EQ(value[3][0], -7.0);
    EXPECT_EQ(changes, 1);
    ui.right_click("S/r0c3");
    EXPECT_EQ(value[3][0], 0.0) << "back to the identity's entry";
    ui.drag("S/r2c1", 100);
    EXPECT_DOUBLE_EQ(value[1][2], 33.0);
}

TEST_F(LectureTest, AReadOnlyMatrixStaysUnchanged) {
    glm::dmat4 value = numbered_rows();
    start([&] { return Matrix("S", value, {}); });
    ui.drag("S/r0c1", 60);
    ui.right_click("S/r0c1");
    ui.double_click("S/r0c1");
    EXPECT_EQ(value, numbered_rows());
    EXPECT_EQ(changes, 0);
}

TEST_F(LectureTest, MatrixRoundsNoiseToZeroAndAlignsDecimals) {
    glm::dmat4 value(0.0);
    value[0][0] = -1e-17;
    value[1][0] = -0.0;
    value[2][0] = 12.34567;
    value[3][0] = -0.0004;
    start([&] { return Matrix("R", value, {.decimals = 3}); });
    EXPECT_EQ(ui.text_of("R/r0c0"), "0.000");
    EXPECT_EQ(ui.text_of("R/r0c1"), "0.000");
    EXPECT_EQ(ui.text_of("R/r0c2"), "12.346");
    EXPECT_EQ(ui.text_of("R/r0c3"), "−4.000·10⁻⁴");
}

TEST_F(LectureTest, MatrixShowsEveryEntryThatIsNotZero) {
    glm::dmat4 value(1.0);
    value[3][2] = -2.0000002e-4;  // P of near 0.0001
    value[1][3] = -8e-12;         // S of a light with a tiny w
    for (const float width : {600.0F, 350.0F, 250.0F}) {
        for (const bool editable : {false, true}) {
            start([&] { return Matrix("P", value, {.decimals = 3, .editable = editable}, width); });
            for (const char* entry : {"P/r2c3", "P/r3c1"}) {
                const std::string text = ui.text_of(entry);
                EXPECT_NE(text.find_first_of("123456789"), std::string::npos) << text << " at " << width;
            }
        }
    }
    start([&] { return Matrix("P", value, {.decimals = 3}, 350.0F); });
    EXPECT_TRUE(ui.text_of("P/r2c3").starts_with("−2"));
    EXPECT_TRUE(ui.text_of("P/r2c3").ends_with("10⁻⁴"));
}

TEST_F(LectureTest, MatrixAdaptsToItsWidth) {
    glm::dmat4 value(-123.456789);
    value[1][0] = 1.5;
    value[3][2] = -98765432.1;
    std::array<MatrixCell, 16> cells;
    for (MatrixCell& cell : cells) cell.symbol = "n·l - l_x n_x";
    for (const float width : {500.0F, 350.0F, 250.0F, 180.0F}) {
        start([&] { return Matrix("P", value, {.decimals = 3, .cells = cells}, width); });
        for (const RecordedItem& item : context.recorded) {
            if (!item.label.starts_with("P/")) continue;
            EXPECT_LE(ImGui::CalcTextSize(item.text.c_str()).x, item.max.x - item.min.x)
                << item.text << " at " << width;
            EXPECT_LE(item.max.x, 8.0F + width);
        }
    }
    start([&] { return Matrix("P", value, {.decimals = 3}, 500.0F); });
    EXPECT_EQ(ui.text_of("P/r0c0"), "−123.457");
    EXPECT_EQ(ui.text_of("P/r2c3"), "−9.877·10⁷");
    start([&] { return Matrix("P", value, {.decimals = 3}, 250.0F); });
    EXPECT_EQ(ui.text_of("P/r0c0"), "−123.5");
    EXPECT_EQ(ui.text_of("P/r0c1"), "1.5");
}

/// An enlarged matrix is taller and loses no digit: its numbers grow only as long as the widest one still fits.
TEST_F(LectureTest, AMatrixGrowsWithoutLosingDigits) {
    glm::dmat4 value(-1.25);
    value[2][1] = -123.456;
    for (const float width : {700.0F, 500.0F, 420.0F, 350.0F, 250.0F}) {
        std::vector<std::string> texts[2];
        float heights[2] = {};
        for (const int grown : {0, 1}) {
            context.matrix_growth = grown ? 1.4F : 1.0F;
            start([&] { return Matrix("P", value, {.decimals = 3}, width); });
            for (const RecordedItem& item : context.recorded) {
                if (!item.label.starts_with("P/")) continue;
                texts[grown].push_back(item.text);
                heights[grown] = item.max.y - item.min.y;
            }
        }
        EXPECT_EQ(texts[0], texts[1]) << width;
        EXPECT_NEAR(heights[1], 1.4F * heights[0], 2.0F) << width;
    }
    context.matrix_growth = 1.0F;
}

TEST_F(LectureTest, AMatrixEnteredByHandHasMarkedBracketsAndKeepsItsSymbols) {
    const glm::dmat4 value(1.0);
    std::array<MatrixCell, 16> cells;
    for (MatrixCell& cell : cells) cell.symbol = "l_x";
    bool overridden = false;
    start([&] {
        static constexpr LetterRole roles[] = {{'l', Role::mirror}};
        Matrix("S", value, {.cells = cells, .roles = roles, .overridden = overridden}, 500.0F);
        return false;
    });
    const auto drew = [](ImU32 color) {
        for (const ImDrawVert& vertex : ImGui::GetDrawData()->CmdLists[0]->VtxBuffer) {
            // The symbols of zero entries are faded, so any opacity counts.
            if ((vertex.col & ~IM_COL32_A_MASK) == (color & ~IM_COL32_A_MASK)) return true;
        }
        return false;
    };
    EXPECT_TRUE(drew(context.palette.mirror));
    EXPECT_FALSE(drew(context.palette.trouble));
    overridden = true;
    ui.frames(2);
    EXPECT_TRUE(drew(context.palette.mirror));
    EXPECT_TRUE(drew(context.palette.trouble));
}

TEST_F(LectureTest, PlaneButtonsShowTheirOwnTooltips) {
    glm::dvec4 plane{0, 1, 0, 0};
    start([&] {
        const bool changed = PlaneEquation("equation", plane, {0, 1, 0, 0});
        Tooltip("the plane", "of the lecture");
        return changed;
    });
    const auto tip_of = [this](const char* label) {
        ui.hover(label);
        ui.frames(60);
        std::string all;
        for (const RecordedItem& item : context.recorded) {
            if (item.label.ends_with("tooltip")) all += item.text + "|";
        }
        return all;
    };
    EXPECT_NE(tip_of("equation/yz").find("x = 0"), std::string::npos);
    EXPECT_NE(tip_of("equation/xz").find("y = 0"), std::string::npos);
    EXPECT_NE(tip_of("equation/xy").find("z = 0"), std::string::npos);
    EXPECT_NE(tip_of("equation/Normalize").find("already has length 1"), std::string::npos);
    EXPECT_EQ(tip_of("equation/b"), "the plane\nof the lecture|");
    plane = {0, 2, 0, 0};
    EXPECT_NE(tip_of("equation/Normalize").find("Divides"), std::string::npos);
}

class LinksTest : public WidgetTest {
protected:
    static constexpr Links light_x = 1, light_y = 2, plane_a = 4, plane_b = 8, own = 16;
    double x = 1, y = 2;
    std::array<MatrixCell, 16> cells{};
    int hovered_cell = -1;
    bool line_lit = false;

    void SetUp() override {
        cells[1].links = light_x | plane_a;
        cells[2].links = light_y;
        cells[5].links = plane_b;
        cells[5].own = own;
        start([this] {
            bool changed = Number("x", x, {.links = light_x});
            changed |= Number("y", y, {.links = light_y});
            const glm::dmat4 shown(1.0);
            Matrix("S", shown, {.cells = cells, .hovered_cell = &hovered_cell});
            ImGui::Dummy(ImVec2(100, 20));
            line_lit = FollowEntry(own, plane_b | light_x);
            Record("line");
            return changed;
        });
    }
};

TEST_F(LinksTest, HoveringAControlHighlightsTheMatrix) {
    ui.hover("x");
    EXPECT_EQ(RedrawIn(context), 0.0F) << "the highlight is drawn in the next frame";
    ui.frame();
    EXPECT_EQ(context.hovered, light_x);
    EXPECT_FALSE(context.entry_hovered);
    EXPECT_NE(RedrawIn(context), 0.0F);
}

TEST_F(LinksTest, HoveringAnEntryHighlightsTheControls) {
    ui.hover("S/r0c1");
    ui.frame();
    EXPECT_EQ(context.hovered, light_x | plane_a);
    EXPECT_TRUE(context.entry_hovered);
    EXPECT_EQ(hovered_cell, 1);
    ui.hover("S/r0c2");
    ui.frame();
    EXPECT_EQ(context.hovered, light_y);
    ui.move_to(ImVec2(590, 770));
    ui.frame();
    EXPECT_EQ(context.hovered, 0U);
    EXPECT_EQ(hovered_cell, -1);
}

TEST_F(LinksTest, ADragKeepsItsHighlight) {
    ui.hover("x");
    ui.press();
    ui.move_to(ImVec2(580, 700));
    ui.frame();
    EXPECT_EQ(context.hovered, light_x);
    ui.release();
}

/// Counts the vertices of this color in the windows' draw lists of the last frame.
int vertices_colored(ImU32 color) {
    int count = 0;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        for (const ImDrawVert& vertex : data.CmdLists[i]->VtxBuffer) count += vertex.col == color ? 1 : 0;
    }
    return count;
}

TEST_F(LinksTest, RepresentationsOfAnEntryLightUpTogether) {
    const ImU32 cell_outline = (context.palette.accent & ~IM_COL32_A_MASK) | (179U << IM_COL32_A_SHIFT);
    const auto after_hovering = [&](const char* label) {
        ui.hover(label);
        ui.frame();
        return line_lit;
    };
    EXPECT_TRUE(after_hovering("S/r1c1"));
    const int one_entry = vertices_colored(cell_outline);
    EXPECT_GT(one_entry, 0);
    EXPECT_EQ(context.hovered, plane_b | own);

    EXPECT_TRUE(after_hovering("line"));
    EXPECT_EQ(context.hovered, plane_b | light_x | own) << "the controls on which it depends light up";
    EXPECT_EQ(vertices_colored(cell_outline), one_entry) << "only its own entry lights up";
    EXPECT_TRUE(after_hovering("x")) << "a control lights up all that depend on it";
    EXPECT_FALSE(after_hovering("S/r0c1")) << "another entry";
    EXPECT_FALSE(after_hovering("y"));
}

TEST_F(LinksTest, LinkedItemsAreDrawnInTheAccentColor) {
    const ImU32 outline = context.palette.accent;
    const ImU32 cell_outline = (outline & ~IM_COL32_A_MASK) | (179U << IM_COL32_A_SHIFT);
    ui.move_to(ImVec2(590, 770));
    ui.frame();
    EXPECT_EQ(vertices_colored(outline), 0);
    EXPECT_EQ(vertices_colored(cell_outline), 0);

    ui.hover("x");
    ui.frame();
    const int one_box = vertices_colored(outline);
    EXPECT_GT(one_box, 0) << "the hovered control";
    EXPECT_GT(vertices_colored(cell_outline), 0) << "its entry";

    ui.hover("S/r0c2");
    ui.frame();
    EXPECT_EQ(vertices_colored(outline), one_box) << "only y";
    EXPECT_GT(vertices_colored(cell_outline), 0) << "the entry under the pointer";
}

}  // namespace
}  // namespace widgets::test
