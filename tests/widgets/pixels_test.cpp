// The histogram, the pixel block and the divider under real input: ranges and fractions stay in order, a click hits the
// cell under it, text is readable on every color, and invalid input does no harm.
#include <algorithm>
#include <limits>
#include <random>

#include "picture_checks.h"
#include "widgets/depth.h"

namespace widgets::test {
namespace {

class HistogramTest : public WidgetTest {
protected:
    std::vector<std::uint32_t> counts = std::vector<std::uint32_t>(10);
    double min = 0.0, max = 1.0;
    glm::dvec2 range{0.25, 0.75};
    HistogramStyle style{.size = ImVec2(500, 200)};

    void start_histogram() {
        start([this] { return Histogram("counts", counts, min, max, range, style); });
    }
    /// Returns the number of pixels between the range's two lines, per unit of the range.
    float unit_px() const {
        return (center(ui, "counts/to").x - center(ui, "counts/from").x) / static_cast<float>(range.y - range.x);
    }
};

TEST_F(HistogramTest, DraggedLinesFollowThePointer) {
    counts[4] = 10;
    start_histogram();
    const float unit = unit_px();
    EXPECT_GT(unit, 300.0F);
    ui.drag("counts/from", 0.1F * unit);
    EXPECT_NEAR(range.x, 0.35, 0.005);
    EXPECT_EQ(range.y, 0.75);
    ui.drag("counts/to", 0.1F * unit);
    EXPECT_NEAR(range.y, 0.85, 0.005);
    const int before = changes;
    EXPECT_GT(before, 2);
    ui.click("counts/from");
    ui.hover("counts/histogram");
    ui.frames(40);
    EXPECT_EQ(changes, before);
}

TEST_F(HistogramTest, TheRangeStaysInOrderOnRandomDrags) {
    counts[4] = 10;
    min = -3.0;
    max = 50.0;
    range = {0.0, 20.0};
    start_histogram();
    std::mt19937 random(8);
    std::uniform_real_distribution<float> pixels(-600.0F, 600.0F);
    for (int i = 0; i < 60; ++i) {
        ui.drag(random() % 2 == 0 ? "counts/from" : "counts/to", pixels(random), 0.0F, 3);
        ASSERT_LT(range.x, range.y);
        ASSERT_GE(range.x, min);
        ASSERT_LE(range.y, max);
    }
}

TEST_F(HistogramTest, FitSelectsTheBinsWithCounts) {
    start_histogram();
    EXPECT_FALSE(ui.find("counts/Fit").enabled);
    counts[3] = 7;
    counts[5] = 1;
    ui.frame();
    ui.click("counts/Fit");
    EXPECT_NEAR(range.x, 0.3, 1e-12);
    EXPECT_NEAR(range.y, 0.6, 1e-12);
    EXPECT_EQ(changes, 1);
    range = {0.1, 0.9};
    ui.double_click("counts/histogram");
    EXPECT_NEAR(range.x, 0.3, 1e-12);
    EXPECT_NEAR(range.y, 0.6, 1e-12);
    ui.right_click("counts/histogram");
    EXPECT_EQ(range, glm::dvec2(0, 1));
    range = {0.1, 0.9};
    ui.frame();
    ui.double_click("counts/from");
    ui.right_click("counts/Fit");
    EXPECT_EQ(range, glm::dvec2(0.1, 0.9)) << "clicks on a line or the button are not on the background";
    ui.right_click("counts/to");
    EXPECT_EQ(range, glm::dvec2(0, 1));
    EXPECT_EQ(changes, 4);
}

TEST_F(HistogramTest, ThePointerShowsTheCount) {
    counts = {1, 22, 333, 4};
    style.unwritten = 98765;
    range = {0.0, 1.0};
    start_histogram();
    const float left = center(ui, "counts/from").x, unit = unit_px(), y = center(ui, "counts/from").y;
    ui.move_to(ImVec2(left + 0.6F * unit, y));
    EXPECT_EQ(ui.text_of("counts/readout"), "333 pixels\n0.500 to 0.750");
    ui.move_to(ImVec2(left + 0.3F * unit, y));
    EXPECT_EQ(ui.text_of("counts/readout"), "22 pixels\n0.250 to 0.500");
    ui.hover("counts/unwritten");
    EXPECT_EQ(ui.text_of("counts/readout"), "98,765 pixels\nnot written");
    EXPECT_GT(ui.find("counts/unwritten").min.x, left + unit);
}

/// Returns the height of the bar between two x positions, measured from its vertices in the accent color.
float bar_height(const Context& context, float from_x, float to_x) {
    float top = 1e9F, bottom = -1e9F;
    const ImDrawData& picture = *ImGui::GetDrawData();
    for (int list = 0; list < picture.CmdListsCount; ++list) {
        for (const ImDrawVert& corner : picture.CmdLists[list]->VtxBuffer) {
            if (corner.col != context.palette.accent || corner.pos.x < from_x || corner.pos.x > to_x) continue;
            top = std::min(top, corner.pos.y);
            bottom = std::max(bottom, corner.pos.y);
        }
    }
    return std::max(bottom - top, 0.0F);
}

TEST_F(HistogramTest, HeightsAreToScale) {
    counts = {100, 0, 50, 0, 10, 0};
    range = {0.0, 1.0};
    start_histogram();
    const float left = center(ui, "counts/from").x, bar = unit_px() / 6.0F;
    const auto height = [&](int i) {
        return bar_height(context, left + bar * static_cast<float>(i) - 1.0F, left + bar * static_cast<float>(i + 1));
    };
    EXPECT_NEAR(height(2) / height(0), 0.5F, 0.01F);
    EXPECT_NEAR(height(4) / height(0), 0.1F, 0.01F);
    style.logarithmic = true;
    ui.frame();
    EXPECT_NEAR(height(4) / height(0), std::log(11.0F) / std::log(101.0F), 0.01F);
}

TEST_F(HistogramTest, InvalidInputDoesNoHarm) {
    style.unwritten = ~0ULL;
    start_histogram();
    expect_finite_picture();
    counts[2] = ~0U;
    for (const glm::dvec2& wild : {glm::dvec2(nan, 1), glm::dvec2(2, 1), glm::dvec2(-inf, inf), glm::dvec2(7, 9)}) {
        range = wild;
        changes = 0;
        ui.frames(2);
        expect_finite_picture();
        EXPECT_EQ(changes, 0) << "drawing does not correct the range";
        ui.right_click("counts/histogram");
        EXPECT_EQ(range, glm::dvec2(0, 1));
        EXPECT_EQ(changes, 1);
        range = wild;
        ui.drag("counts/from", 30);
        EXPECT_TRUE(range.x < range.y && range.x >= 0.0 && range.y <= 1.0);
    }
    for (const glm::dvec2& ends : {glm::dvec2(1, 1), glm::dvec2(2, 1), glm::dvec2(nan, 1), glm::dvec2(-1e308, 1e308)}) {
        min = ends.x;
        max = ends.y;
        changes = 0;
        ui.frames(2);
        EXPECT_FALSE(ui.has("counts/from"));
        ui.double_click("counts/histogram");
        ui.right_click("counts/histogram");
        EXPECT_EQ(changes, 0);
        expect_finite_picture();
    }
    min = 0.0;
    max = 1.0;
    for (const std::size_t count : {0U, 1U, 70'000U}) {
        counts.assign(count, 5);
        for_every_look(context, ui, [&](float scale) {
            style.size = ImVec2(200.0F * scale, 120.0F * scale);
            ui.frames(2);
            expect_finite_picture();
        });
    }
}

class CellGridTest : public WidgetTest {
protected:
    std::vector<std::string> texts;
    std::vector<Cell> cells;
    int columns = 4, rows = 3, selected = -1, hovered = -1;
    CellGridStyle style{.hovered = &hovered, .size = ImVec2(500, 400)};

    void fill(int count, const char* text) {
        texts.assign(static_cast<std::size_t>(count), text);
        cells.clear();
        for (const std::string& each : texts) cells.push_back({.color = IM_COL32(90, 120, 60, 255), .text = each});
    }
    void start_grid() {
        start([this] { return CellGrid("grid", cells, columns, rows, selected, style); });
    }
};

TEST_F(CellGridTest, CellsAreSquareAndInTheirPlaces) {
    fill(12, "0.5");
    start_grid();
    const RecordedItem first = ui.find("grid/cell/0/0"), last = ui.find("grid/cell/3/2"), all = ui.find("grid/grid");
    const float side = first.max.x - first.min.x;
    EXPECT_EQ(first.max.y - first.min.y, side);
    EXPECT_GT(side, 110.0F);
    EXPECT_EQ(last.min.x - first.min.x, 3.0F * side);
    EXPECT_EQ(last.min.y - first.min.y, 2.0F * side);
    EXPECT_GE(first.min.x, all.min.x);
    EXPECT_LE(last.max.y, all.max.y);
    EXPECT_EQ(first.text, "0.5");
}

TEST_F(CellGridTest, AClickPinsAndUnpins) {
    fill(12, "0.5");
    start_grid();
    ui.hover("grid/cell/1/2");
    EXPECT_EQ(hovered, 9);
    EXPECT_EQ(changes, 0);
    ui.click("grid/cell/1/2");
    EXPECT_EQ(selected, 9);
    ui.click("grid/cell/3/0");
    EXPECT_EQ(selected, 3);
    ui.click("grid/cell/3/0");
    EXPECT_EQ(selected, -1);
    ui.click("grid/cell/0/0");
    ui.right_click("grid/cell/2/2");
    EXPECT_EQ(selected, -1);
    EXPECT_EQ(changes, 5);
    ui.move_to(ImVec2(-1, -1));
    EXPECT_EQ(hovered, -1);
}

TEST_F(CellGridTest, TextThatDoesNotFitAppearsUnderThePointer) {
    fill(12, "0.123456789");
    start_grid();
    EXPECT_EQ(ui.text_of("grid/cell/0/0"), "0.123456789");
    ui.hover("grid/cell/1/1");
    EXPECT_FALSE(ui.has("grid/readout"));
    style.size = ImVec2(200, 120);
    ui.frames(2);
    EXPECT_EQ(ui.text_of("grid/cell/0/0"), "");
    ui.hover("grid/cell/1/1");
    EXPECT_EQ(ui.text_of("grid/readout"), "0.123456789");
    for (const RecordedItem& item : context.recorded) {
        if (!item.text.empty() && item.label.starts_with("grid/cell/")) ADD_FAILURE() << item.label << " has text";
    }
}

TEST_F(CellGridTest, TextIsReadableOnEveryColor) {
    columns = rows = 1;
    fill(1, "0.5");
    start_grid();
    std::mt19937 random(4);
    for (int round = 0; round < 200; ++round) {
        const ImU32 color = (random() & 0x00FFFFFF) | 0x01000001 | IM_COL32_A_MASK;  // neither black nor white
        cells[0].color = color;
        ui.frame();
        std::vector<ImU32> inks;
        const ImDrawData& picture = *ImGui::GetDrawData();
        for (int list = 0; list < picture.CmdListsCount; ++list) {
            for (const ImDrawVert& corner : picture.CmdLists[list]->VtxBuffer) {
                if (corner.col == IM_COL32_BLACK || corner.col == IM_COL32_WHITE) inks.push_back(corner.col);
            }
        }
        ASSERT_EQ(inks.size(), 12U) << "three characters";
        EXPECT_GE(contrast(inks[0], color), 4.5);
    }
}

TEST_F(CellGridTest, InvalidInputDoesNoHarm) {
    start_grid();
    for (const glm::ivec2& size :
         {glm::ivec2(0, 0), glm::ivec2(-3, -4), glm::ivec2(4, 0), glm::ivec2(100'000, 100'000), glm::ivec2(65, 64)}) {
        columns = size.x;
        rows = size.y;
        fill(12, "1");
        ui.frames(2);
        ui.click("grid/grid");
        EXPECT_EQ(hovered, -1);
        EXPECT_EQ(selected, -1);
        EXPECT_FALSE(ui.has("grid/cell/0/0"));
    }
    columns = 4;
    rows = 3;
    fill(5, "1");
    cells[1].text = {};
    cells[1].color = 0;
    cells[2].unwritten = cells[2].accent = true;
    for (const int odd : {-7, 5, 12, 1 << 30}) {
        selected = style.lit = odd;
        changes = 0;
        ui.frames(2);
        EXPECT_EQ(selected, odd);
        EXPECT_EQ(changes, 0);
    }
    EXPECT_TRUE(ui.has("grid/cell/0/1"));
    EXPECT_FALSE(ui.has("grid/cell/1/1")) << "a missing one";
    ui.hover("grid/grid", 0.9F, 0.9F);
    expect_finite_picture();
}

TEST_F(CellGridTest, ManyCellsDoNotMakeALargePicture) {
    for (const glm::ivec2& size : {glm::ivec2(64, 64), glm::ivec2(32, 32), glm::ivec2(4096, 1)}) {
        columns = size.x;
        rows = size.y;
        fill(columns * rows, "0.1234");
        for (Cell& cell : cells) cell.unwritten = true;
        for_every_look(context, ui, [&](float scale) {
            style.size = ImVec2(1200, 700);
            ui.frames(1);
            expect_finite_picture();
            style.size = ImVec2(200.0F * scale, 120.0F * scale);
            ui.frames(1);
            expect_finite_picture();
        });
        start_grid();
        expect_finite_picture();
    }
}

class DividerTest : public WidgetTest {
protected:
    float share = 0.5F;
    ImVec2 min{50, 40}, max{450, 240};
    DividerStyle style{.left = "standard", .right = "reversed"};
    int picture_clicks = 0;

    void start_divider() {
        start([this] {
            const ImVec2 before = ImGui::GetCursorScreenPos();
            const bool changed = Divider("pictures", min, max, share, style);
            EXPECT_EQ(ImGui::GetCursorScreenPos().x, before.x);
            EXPECT_EQ(ImGui::GetCursorScreenPos().y, before.y);
            ImGui::SetCursorScreenPos(min);
            picture_clicks += ImGui::InvisibleButton("picture", ImVec2(400, 200)) ? 1 : 0;
            Record("picture");
            return changed;
        });
    }
};

TEST_F(DividerTest, IsAtItsShareAndCanBeDragged) {
    share = 0.25F;
    start_divider();
    EXPECT_NEAR(center(ui, "pictures/divider").x, 150.0F, 0.51F);
    ui.drag("pictures/divider", 100.0F);
    EXPECT_NEAR(share, 0.5F, 0.003F);
    ui.drag("pictures/divider", 1000.0F);
    EXPECT_EQ(share, 1.0F);
    ui.drag("pictures/divider", -1000.0F);
    EXPECT_EQ(share, 0.0F);
    ui.right_click("pictures/divider");
    EXPECT_EQ(share, 0.5F);
    ui.hover("pictures/divider");
    EXPECT_EQ(picture_clicks, 0) << "the line takes clicks before the picture";
    const int before = changes;
    ui.hover("picture", 0.2F);
    ui.press();
    ui.release();
    EXPECT_EQ(picture_clicks, 1) << "the rest belongs to the picture";
    EXPECT_EQ(changes, before);
}

TEST_F(DividerTest, NamesAppearOnTheirSidesWhenTheyFit) {
    start_divider();
    EXPECT_LT(ui.find("pictures/left").max.x, 250.0F);
    EXPECT_GT(ui.find("pictures/right").min.x, 250.0F);
    share = 0.05F;
    ui.frames(2);
    EXPECT_FALSE(ui.has("pictures/left"));
    EXPECT_TRUE(ui.has("pictures/right"));
    share = 1.0F;
    ui.frames(2);
    EXPECT_TRUE(ui.has("pictures/left"));
    EXPECT_FALSE(ui.has("pictures/right"));
}

TEST_F(DividerTest, InvalidInputDoesNoHarm) {
    start_divider();
    for (const float wild : {std::numeric_limits<float>::quiet_NaN(), -3.0F, 7.0F}) {
        share = wild;
        changes = 0;
        for_every_look(context, ui, [](float) { expect_finite_picture(); });
        EXPECT_EQ(changes, 0);
        ui.drag("pictures/divider", 20.0F);
        ui.drag("pictures/divider", -40.0F);
        EXPECT_TRUE(share >= 0.0F && share <= 1.0F);
    }
    max = min;
    ui.frames(2);
    EXPECT_FALSE(ui.has("pictures/divider"));
}

}  // namespace
}  // namespace widgets::test
