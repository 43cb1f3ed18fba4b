// The logarithmic chart: decades and points are in their places, names do not overlap, the curve under the pointer is
// found, and empty curves do no harm.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "widget_test.h"
#include "widgets/diagrams.h"

namespace widgets::test {
namespace {

using Points = std::vector<glm::dvec2>;

class ChartTest : public WidgetTest {
protected:
    std::vector<Points> points;
    std::vector<std::string> names;
    std::vector<ChartCurve> curves;
    LogChartStyle style{.x = {.title = "polygons"}, .y = {.title = "time in ms"}, .size = ImVec2(560, 400)};
    int hovered = -1;

    void start_chart() {
        start([this] {
            hovered = LogChart("chart", curves, style);
            return false;
        });
    }
    void use(std::vector<Points> all) {
        points = std::move(all);
        names.clear();
        curves.clear();
        for (std::size_t i = 0; i < points.size(); ++i) names.push_back("curve " + std::to_string(i));
        for (std::size_t i = 0; i < points.size(); ++i) {
            curves.push_back({.name = names[i].c_str(), .color = IM_COL32_WHITE, .points = points[i]});
        }
    }
    ImVec2 center(const std::string& label) const {
        const RecordedItem& item = ui.find(label);
        return ImVec2(0.5F * (item.min.x + item.max.x), 0.5F * (item.min.y + item.max.y));
    }
    std::vector<RecordedItem> labels() const {
        std::vector<RecordedItem> found;
        for (const RecordedItem& item : context.recorded) {
            if (item.label.starts_with("chart/label/")) found.push_back(item);
        }
        return found;
    }
    static void expect_finite_picture() {
        const ImDrawData& picture = *ImGui::GetDrawData();
        EXPECT_LT(picture.TotalVtxCount, 60'000);
        for (int list = 0; list < picture.CmdListsCount; ++list) {
            for (const ImDrawVert& corner : picture.CmdLists[list]->VtxBuffer) {
                ASSERT_TRUE(std::isfinite(corner.pos.x) && std::isfinite(corner.pos.y));
            }
        }
    }
    void expect_labels_apart() const {
        const std::vector<RecordedItem> all = labels();
        const RecordedItem& chart = ui.find("chart/chart");
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_GE(all[i].min.y, chart.min.y);
            EXPECT_LE(all[i].max.y, chart.max.y);
            EXPECT_LE(all[i].max.x, chart.max.x);
            for (std::size_t j = 0; j < i; ++j) {
                const bool apart = all[i].max.x <= all[j].min.x || all[j].max.x <= all[i].min.x ||
                                   all[i].max.y <= all[j].min.y || all[j].max.y <= all[i].min.y;
                EXPECT_TRUE(apart) << all[i].label << " covers " << all[j].label;
            }
        }
    }
};

TEST_F(ChartTest, DecadesAreEquallySpacedAndWhole) {
    use({{{23, 0.004}, {4100, 70}}});
    start_chart();
    const float step = center("chart/x/100").x - center("chart/x/10").x;
    EXPECT_GT(step, 20.0F);
    EXPECT_NEAR(center("chart/x/1000").x - center("chart/x/100").x, step, 1.01);
    EXPECT_NEAR(center("chart/x/10⁴").x - center("chart/x/1000").x, step, 1.01) << "ticks are on whole pixels";
    EXPECT_FALSE(ui.has("chart/x/1"));
    EXPECT_FALSE(ui.has("chart/x/10⁵"));
    const float up = center("chart/y/10⁻³").y - center("chart/y/0.01").y;
    EXPECT_GT(up, 20.0F);
    EXPECT_NEAR(center("chart/y/1").y - center("chart/y/10").y, up, 1.01);
    EXPECT_NEAR(center("chart/y/10⁻³").y - center("chart/y/100").y, 5.0F * up, 4.01);
}

TEST_F(ChartTest, PointsAreBetweenTheirDecades) {
    use({{{10, 1}, {std::sqrt(1e5), 10}, {10000, 100}}});
    start_chart();
    const ImVec2 expected(0.5F * (center("chart/x/100").x + center("chart/x/1000").x), center("chart/y/10").y);
    ui.move_to(ImVec2(expected.x + 2.0F, expected.y - 3.0F));
    ui.frame();
    EXPECT_EQ(hovered, 0);
    EXPECT_EQ(ui.text_of("chart/readout"), "curve 0\npolygons: 316\ntime in ms: 10.0");
    ui.move_to(ImVec2(expected.x + 60.0F, expected.y - 10.0F));
    EXPECT_EQ(hovered, -1);
    EXPECT_FALSE(ui.has("chart/readout"));
}

TEST_F(ChartTest, ThePointerFindsTheNearestCurve) {
    use({{{10, 1}, {100, 10}}, {{10, 1}, {100, 1}}});
    start_chart();
    ui.move_to(ImVec2(center("chart/x/100").x, center("chart/y/1").y - 4.0F));
    EXPECT_EQ(hovered, 1);
    ui.move_to(ImVec2(center("chart/x/100").x, center("chart/y/10").y + 4.0F));
    EXPECT_EQ(hovered, 0);
    ui.move_to(ImVec2(-1, -1));
    EXPECT_EQ(hovered, -1);
}

TEST_F(ChartTest, NamesDoNotOverlapWhereCurvesEndTogether) {
    std::vector<Points> all;
    for (int i = 0; i < 9; ++i) all.push_back({{10, 1.0 + i}, {1000, 50.0 + 0.1 * i}});
    use(all);
    start_chart();
    EXPECT_EQ(labels().size(), 9U);
    expect_labels_apart();
}

/// Frames around two names, each up to 3 pixels wider than the name, do not touch; a low chart still has all names.
TEST_F(ChartTest, NamesHaveSpaceForFramesUnlessANameWouldBeLost) {
    std::vector<Points> all;
    for (int i = 0; i < 6; ++i) all.push_back({{10, 1.0 + i}, {1000, 50.0 + 0.1 * i}});
    use(all);
    const auto least_space = [&](float height) {
        style.size = ImVec2(560, height);
        start_chart();
        EXPECT_EQ(labels().size(), 6U) << height;
        std::vector<RecordedItem> from_top = labels();
        std::sort(from_top.begin(), from_top.end(),
                  [](const RecordedItem& a, const RecordedItem& b) { return a.min.y < b.min.y; });
        float least = 1e6F;
        for (std::size_t i = 1; i < from_top.size(); ++i)
            least = std::min(least, from_top[i].min.y - from_top[i - 1].max.y);
        return least;
    };
    EXPECT_GE(least_space(400.0F), 4.0F);
    const float low = least_space(165.0F);
    EXPECT_GE(low, 0.0F);
    EXPECT_LT(low, 4.0F);
}

TEST_F(ChartTest, NamesDoNotOverlapOnRandomCurves) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> exponent(-2.0, 5.0);
    for (int round = 0; round < 30; ++round) {
        std::vector<Points> all(1 + random() % 12);
        for (Points& curve : all) {
            for (int i = 0; i < 5; ++i) curve.emplace_back(std::pow(10.0, 1 + i), std::pow(10.0, exponent(random)));
            curve.resize(1 + random() % 5);
        }
        use(all);
        start_chart();
        expect_labels_apart();
    }
}

TEST_F(ChartTest, WithoutRoomTheEmphasizedNameStays) {
    std::vector<Points> all;
    for (int i = 0; i < 30; ++i) all.push_back({{10, 1.0}, {1000, 50.0}});
    use(all);
    curves[29].emphasized = true;
    style.size = ImVec2(200, 120);
    start_chart();
    EXPECT_LT(labels().size(), 30U);
    EXPECT_TRUE(ui.has("chart/label/curve 29"));
    expect_labels_apart();
    expect_finite_picture();
}

TEST_F(ChartTest, AGivenRangeIsKept) {
    use({{{1, 1e-30}, {1e3, 1.0}, {1e300, 1e300}}});
    style.x = {.title = "n", .min = 100, .max = 1e5};
    style.y = {.title = "t", .min = 0.1, .max = 10};
    start_chart();
    EXPECT_TRUE(ui.has("chart/x/100"));
    EXPECT_TRUE(ui.has("chart/x/10⁵"));
    EXPECT_FALSE(ui.has("chart/x/10"));
    EXPECT_TRUE(ui.has("chart/y/0.1"));
    EXPECT_FALSE(ui.has("chart/y/100"));
    expect_finite_picture();
    ui.move_to(ImVec2(center("chart/x/1000").x, center("chart/y/1").y));
    EXPECT_EQ(hovered, 0);
}

TEST_F(ChartTest, ANarrowRangeHasNumbersBetweenItsDecades) {
    use({{{2, 3}, {5, 4}}});
    start_chart();
    EXPECT_TRUE(ui.has("chart/x/2"));
    EXPECT_TRUE(ui.has("chart/x/5"));
    EXPECT_NEAR((center("chart/x/2").x - center("chart/x/1").x) / (center("chart/x/10").x - center("chart/x/1").x),
                std::log10(2.0), 0.01);
}

TEST_F(ChartTest, ManyDecadesHaveSpacedNumbers) {
    use({{{1e-300, 1e-300}, {1e300, 1e300}}});
    start_chart();
    std::vector<RecordedItem> ticks;
    for (const RecordedItem& item : context.recorded) {
        if (item.label.starts_with("chart/x/")) ticks.push_back(item);
    }
    ASSERT_GT(ticks.size(), 2U);
    for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_LT(ticks[i - 1].max.x, ticks[i].min.x);
    expect_finite_picture();
}

TEST_F(ChartTest, EmptyInputDrawsNothingInvalid) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const std::vector<std::vector<Points>> cases = {
        {},
        {{}},
        {{}, {{0, 0}, {-1, 5}, {nan, 1}, {1, nan}, {inf, 1}, {1, -inf}}},
        {{{5, 5}}},
        {{{1, 1}, {10, 0}, {100, 10}}, {}},
        {{{5e-324, 1.7e308}, {1.7e308, 5e-324}}},
    };
    for (const auto& all : cases) {
        use(all);
        start_chart();
        expect_finite_picture();
        ui.hover("chart/chart");
        expect_finite_picture();
    }
    use({{{1, 1}, {10, 0}, {100, 10}}, {}});
    ui.frames(2);
    EXPECT_TRUE(ui.has("chart/label/curve 0"));
    EXPECT_FALSE(ui.has("chart/label/curve 1")) << "an empty curve has no label";
    for (const ChartAxis& axis : {ChartAxis{"", nan, nan}, ChartAxis{"", 10, 1}, ChartAxis{"", -1, 1},
                                  ChartAxis{"", 1, inf}, ChartAxis{"", 1, 1}}) {
        style.x = axis;
        ui.frames(2);
        EXPECT_TRUE(ui.has("chart/x/100")) << "an invalid range falls back to that of the data";
        expect_finite_picture();
    }
}

TEST_F(ChartTest, TheMarkerIsAtItsValue) {
    use({{{10, 1}, {1000, 10}}});
    style.marker_x = 100;
    style.marker_label = "this scene";
    start_chart();
    EXPECT_NEAR(center("chart/marker").x, center("chart/x/100").x, 1.01);
    EXPECT_EQ(ui.text_of("chart/marker"), "this scene");
    for (const double outside : {0.0, -4.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
        style.marker_x = outside;
        ui.frames(2);
        EXPECT_FALSE(ui.has("chart/marker"));
    }
}

TEST_F(ChartTest, DrawsIntoAnyListForExport) {
    use({{{10, 1}, {1000, 10}}});
    start([this] {
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        list.PushTextureID(ImGui::GetIO().Fonts->TexID);
        list.PushClipRectFullScreen();
        DrawLogChart(&list, ImVec2(0, 0), ImVec2(1600, 900), curves, style);
        EXPECT_GT(list.VtxBuffer.Size, 200);
        return false;
    });
    EXPECT_NEAR(center("x/1000").x - center("x/100").x, center("x/100").x - center("x/10").x, 1.01);
}

}  // namespace
}  // namespace widgets::test
