// The precision chart and the ticks of codes under real input: near and far stay apart whatever is dragged, lines are
// where the axis says, the readout follows the curve's formula, and invalid input does no harm.
#include <cmath>
#include <limits>
#include <random>

#include "picture_checks.h"
#include "widgets/depth.h"

namespace widgets::test {
namespace {

class PrecisionChartTest : public WidgetTest {
protected:
    double near = 0.1, far = 100.0;
    std::vector<glm::dvec2> straight;  ///< Δz = z²·10⁻⁶: a straight line on these axes
    std::vector<ChartCurve> curves;
    PrecisionChartStyle style{.x = {.title = "z", .min = 0.01, .max = 1000}, .size = ImVec2(560, 400)};

    void start_chart() {
        straight = {{0.01, 1e-10}, {1000, 1.0}};
        curves = {{.name = "current", .color = IM_COL32_WHITE, .points = straight, .emphasized = true}};
        start([this] { return PrecisionChart("chart", curves, near, far, style); });
    }
    /// Returns the number that follows `begin` in a readout, up to the end of that line.
    static double number_behind(const std::string& readout, const std::string& begin) {
        const std::size_t at = readout.find(begin) + begin.size();
        return ParseNumber(readout.substr(at, readout.find('\n', at) - at)).value_or(nan);
    }
    float x_of(double z) const {
        const float from = center(ui, "chart/x/0.1").x, to = center(ui, "chart/x/100").x;
        return from + static_cast<float>((std::log10(z) + 1.0) / 3.0) * (to - from);
    }
};

TEST_F(PrecisionChartTest, LinesAreAtTheirDistances) {
    start_chart();
    EXPECT_NEAR(center(ui, "chart/near").x, x_of(0.1), 1.01);
    EXPECT_NEAR(center(ui, "chart/far").x, x_of(100.0), 1.01);
    near = 3.0;
    ui.frame();
    EXPECT_NEAR(center(ui, "chart/near").x, x_of(3.0), 1.51);
    EXPECT_EQ(ui.text_of("chart/near"), "3.00");
    EXPECT_EQ(ui.text_of("chart/name/near"), "near 3.00");
    EXPECT_EQ(changes, 0);
}

TEST_F(PrecisionChartTest, DraggingFollowsTheAxis) {
    start_chart();
    const float decade = x_of(10.0) - x_of(1.0);
    ui.drag("chart/near", decade);
    EXPECT_NEAR(near, 1.0, 0.03);
    EXPECT_EQ(far, 100.0);
    ui.drag("chart/far", -decade);
    EXPECT_NEAR(far, 10.0, 0.3);
    EXPECT_GT(changes, 2);
    const int before = changes;
    ui.click("chart/near");
    ui.hover("chart/far");
    ui.frames(60);
    EXPECT_EQ(changes, before) << "hovering and clicking change nothing";
    EXPECT_FALSE(ui.has("chart/readout")) << "over a line, the pointer means the line";
    EXPECT_TRUE(ui.text_of("chart/tooltip").starts_with("Far\n"));
}

TEST_F(PrecisionChartTest, RandomDragsKeepNearLessThanFar) {
    start_chart();
    std::mt19937 random(3);
    std::uniform_real_distribution<float> pixels(-700.0F, 700.0F);
    for (int i = 0; i < 60; ++i) {
        ui.drag(random() % 2 == 0 ? "chart/near" : "chart/far", pixels(random), 0.0F, 3);
        ASSERT_LT(near, far);
        ASSERT_GE(near, 0.0099);
        ASSERT_LE(far, 1001.0);
    }
}

TEST_F(PrecisionChartTest, CoincidentLinesCanBePulledApart) {
    near = 1.0;
    far = 1.001;
    start_chart();
    ui.frame(1.0F);
    const ImVec2 at = center(ui, "chart/far");
    ui.move_to(ImVec2(at.x + 3.0F, at.y));
    ui.press();
    ui.move_to(ImVec2(at.x + 80.0F, at.y));
    ui.release();
    EXPECT_EQ(near, 1.0);
    EXPECT_GT(far, 2.0);
    far = 1.001;
    ui.frame(1.0F);
    ui.move_to(ImVec2(at.x - 3.0F, at.y));
    ui.press();
    ui.move_to(ImVec2(at.x - 80.0F, at.y));
    ui.release();
    EXPECT_LT(near, 0.5);
    EXPECT_EQ(far, 1.001);
}

TEST_F(PrecisionChartTest, ARightClickResets) {
    near = 2.0;
    far = 30.0;
    style.default_near = 0.5;
    style.default_far = 40.0;
    start_chart();
    ui.right_click("chart/near");
    EXPECT_EQ(near, 0.5);
    EXPECT_EQ(far, 30.0);
    ui.right_click("chart/far");
    EXPECT_EQ(far, 40.0);
    EXPECT_EQ(changes, 2);
    near = 60.0;
    far = 70.0;
    ui.frame();
    ui.right_click("chart/far");
    EXPECT_EQ(near, 0.5) << "near exceeds far's default";
    EXPECT_EQ(far, 40.0);
}

TEST_F(PrecisionChartTest, ThePointerShowsTheStepBetweenPoints) {
    const std::vector<glm::dvec2> constant = {{0.01, 0.5}, {1000, 0.5}};
    const ChartCurve terms[] = {{.name = "term", .color = IM_COL32_WHITE, .points = constant}};
    style.terms = terms;
    start_chart();
    for (const double z : {0.3, 1.0, 42.0}) {
        ui.move_to(ImVec2(x_of(z), center(ui, "chart/y/0.01").y));
        const std::string readout = ui.text_of("chart/readout");
        ASSERT_TRUE(readout.starts_with("current\nz: ")) << readout;
        const double shown_z = number_behind(readout, "\nz: "), step = number_behind(readout, "Δz: ");
        EXPECT_NEAR(shown_z, z, 0.04 * z) << "up to a pixel";
        EXPECT_NEAR(step, 1e-6 * shown_z * shown_z, 0.02 * step);
        EXPECT_EQ(number_behind(readout, "term: "), 0.5);
    }
    curves[0].emphasized = false;
    ui.frame();
    EXPECT_FALSE(ui.has("chart/readout"));
}

TEST_F(PrecisionChartTest, MarksAreAtTheirDistances) {
    const DepthMark marks[] = {{"teapot", 3.0}, {"wall", 30.0}, {"behind", -2.0}, {"nowhere", nan}, {"far off", 1e8}};
    style.marks = marks;
    style.cursor_z = 7.0;
    start_chart();
    EXPECT_NEAR(center(ui, "chart/mark/teapot").x, x_of(3.0), 1.51);
    EXPECT_NEAR(center(ui, "chart/mark/wall").x, x_of(30.0), 1.51);
    EXPECT_NEAR(center(ui, "chart/mark/pixel").x, x_of(7.0), 1.51);
    for (const char* absent : {"chart/mark/behind", "chart/mark/nowhere", "chart/mark/far off"}) {
        EXPECT_FALSE(ui.has(absent));
    }
    EXPECT_TRUE(ui.has("chart/name/teapot"));
}

TEST_F(PrecisionChartTest, NamesOfLinesDoNotOverlap) {
    std::vector<DepthMark> marks;
    for (int i = 0; i < 12; ++i) marks.push_back({"a thing", 2.0 + 0.2 * i});
    style.marks = marks;
    start_chart();
    std::vector<RecordedItem> names;
    for (const RecordedItem& item : context.recorded) {
        if (item.label.starts_with("chart/name/")) names.push_back(item);
    }
    EXPECT_GT(names.size(), 4U);
    expect_apart(names);
}

TEST_F(PrecisionChartTest, InvalidInputDoesNoHarm) {
    start_chart();
    for (const glm::dvec2& range : {glm::dvec2(nan, nan), glm::dvec2(-1, 100), glm::dvec2(0, inf), glm::dvec2(50, 2),
                                    glm::dvec2(1e-30, 1e30), glm::dvec2(1, inf), glm::dvec2(5e-324, 1e-323)}) {
        near = range.x;
        far = range.y;
        changes = 0;
        ui.frames(3);
        ui.hover("chart/chart");
        expect_finite_picture();
        EXPECT_EQ(changes, 0);
        EXPECT_EQ(ui.has("chart/near"), range.x > 0);
        EXPECT_EQ(ui.has("chart/far"), range.y > 0 && std::isfinite(range.y));
    }
    near = 50;
    far = 2;
    ui.frame();
    ui.drag("chart/near", 5);
    EXPECT_LT(near, far);
    EXPECT_EQ(far, 2.0);
    for (const ChartAxis& axis : {ChartAxis{"", nan, 1}, ChartAxis{"", 0, 0}, ChartAxis{"", 5, 5}}) {
        style.x = axis;
        near = 0.1;
        far = 100;
        ui.frames(2);
        EXPECT_TRUE(ui.has("chart/x/10⁴")) << "the standard axis";
    }
    straight = {{nan, 1}, {1, 0}, {-1, 2}, {3, inf}};
    curves[0].points = straight;
    ui.frames(2);
    ui.hover("chart/chart");
    expect_finite_picture();
}

TEST_F(PrecisionChartTest, SmallAndLargeInEveryTheme) {
    start_chart();
    for_every_look(context, ui, [&](float scale) {
        style.size = ImVec2(200.0F * scale, 120.0F * scale);
        ui.frames(2);
        EXPECT_TRUE(ui.has("chart/near"));
        expect_finite_picture();
    });
}

class CodeTicksTest : public WidgetTest {
protected:
    std::vector<double> eye_distances;
    double near = 1.0, far = 5.0;
    CodeTicksStyle style{.size = ImVec2(500, 160)};
    int hovered = -1;

    void start_ticks() {
        start([this] {
            hovered = CodeTicks("codes", eye_distances, near, far, style);
            return false;
        });
    }
    std::vector<RecordedItem> ticks() const {
        std::vector<RecordedItem> found;
        for (const RecordedItem& item : context.recorded) {
            if (item.label.starts_with("codes/tick/")) found.push_back(item);
        }
        return found;
    }
};

TEST_F(CodeTicksTest, AreEquallySpacedAboveAndToScaleBelow) {
    eye_distances = {1.0, 1.25, 2.0, 3.0, 5.0};
    start_ticks();
    const std::vector<RecordedItem> all = ticks();
    ASSERT_EQ(all.size(), 5U);
    const float left = all[0].min.x, width = all[4].min.x - left;
    EXPECT_GT(width, 400.0F);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NEAR(all[i].min.x, left + width * static_cast<float>(i) / 4.0F, 0.01F);
        EXPECT_NEAR(all[i].max.x, left + width * static_cast<float>((eye_distances[i] - 1.0) / 4.0), 0.01F);
    }
}

TEST_F(CodeTicksTest, AreThinnedOutButKeepTheirEnds) {
    for (int i = 0; i < 65536; ++i) eye_distances.push_back(1.0 + 4.0 * i / 65535.0);
    start_ticks();
    const std::vector<RecordedItem> all = ticks();
    EXPECT_GT(all.size(), 40U);
    EXPECT_LT(all.size(), 100U);
    EXPECT_EQ(all.front().label, "codes/tick/0");
    EXPECT_EQ(all.back().label, "codes/tick/65535");
    for (std::size_t i = 2; i + 1 < all.size(); ++i) {
        EXPECT_NEAR(all[i].min.x - all[i - 1].min.x, all[1].min.x - all[0].min.x, 0.05F);
        EXPECT_GE(all[i].min.x - all[i - 1].min.x, 5.9F);
    }
}

TEST_F(CodeTicksTest, ThePointerFindsATick) {
    eye_distances = {1.0, 1.25, 2.0, 3.0, 5.0};
    const std::uint32_t codes[] = {0, 4, 8, 12, 15};
    style.codes = codes;
    start_ticks();
    const RecordedItem tick = ticks()[3];
    ui.move_to(ImVec2(0.5F * (tick.min.x + tick.max.x) + 2.0F, 0.5F * (tick.min.y + tick.max.y)));
    EXPECT_EQ(hovered, 3);
    EXPECT_EQ(ui.text_of("codes/readout"), "code 12\nz: 3.00\nto the next: 2.00");
    ui.move_to(ImVec2(-1, -1));
    EXPECT_EQ(hovered, -1);
}

TEST_F(CodeTicksTest, InvalidInputDoesNoHarm) {
    eye_distances = {nan, -inf, 1.0, 2.0, 1e300, inf, -3.0};
    start_ticks();
    ui.hover("codes/ticks");
    expect_finite_picture();
    EXPECT_EQ(ticks().size(), 7U);
    for (const glm::dvec2& range : {glm::dvec2(5, 1), glm::dvec2(1, 1), glm::dvec2(nan, 2), glm::dvec2(1, inf)}) {
        near = range.x;
        far = range.y;
        ui.frames(2);
        EXPECT_EQ(ticks().size(), 0U);
        EXPECT_EQ(hovered, -1);
    }
    near = 1.0;
    far = 5.0;
    for (const std::size_t count : {0U, 1U}) {
        eye_distances.assign(count, 1.0);
        for_every_look(context, ui, [&](float scale) {
            style.size = ImVec2(200.0F * scale, 120.0F * scale);
            ui.frames(2);
            EXPECT_EQ(ticks().size(), count);
            expect_finite_picture();
        });
    }
}

}  // namespace
}  // namespace widgets::test
