// Uses the views of the depth buffer's precision: drags near and far on the chart, follows the advice, and reads the
// codes.
#include <algorithm>

#include "desk.h"

namespace viewing::test {
namespace {

class PrecisionView : public ::testing::Test {
protected:
    Desk desk{{1600, 1100}, "depth-fighting"};
    widgets::test::Harness& ui = desk.ui;
    Params& params = desk.session.params;

    void show(Topic topic) {
        params.view.lower_right = topic;
        desk.settle();
    }
    bool has(std::string_view label) const {
        return std::ranges::any_of(desk.recorded(), [&](const RecordedItem& item) { return item.label == label; });
    }
    std::string trouble() const {
        for (const RecordedItem& item : desk.recorded())
            if (item.label == "lower/trouble") return item.text;
        return "";
    }
};

TEST_F(PrecisionView, DraggingNearOnTheChartIsOneUndoStep) {
    show(Topic::precision);
    const Params before = params;
    ui.drag("lower/precision/near", 60.0F, 0.0F);
    desk.settle();
    EXPECT_EQ(differing_fields(before, params), (Paths{"projection.near"}));
    EXPECT_GT(params.projection.near, 3.0 * before.projection.near);
    ui.drag("lower/precision/near", 5000.0F, 0.0F);
    desk.settle();
    EXPECT_LT(params.projection.near, params.projection.far);
    desk.undo();
    desk.undo();
    EXPECT_EQ(params, before);
}

TEST_F(PrecisionView, RaisingNearTakesOneClick) {
    show(Topic::precision);
    const Params before = params;
    EXPECT_TRUE(trouble().starts_with("Nothing is nearer than 3.8: with near = 3.4, the safe gap")) << trouble();
    ui.click("lower/Raise near");
    desk.settle();
    EXPECT_EQ(differing_fields(before, params), (Paths{"projection.near"}));
    EXPECT_EQ(params.projection.near, 3.4);
    EXPECT_EQ(trouble(), "");
    EXPECT_FALSE(has("lower/Raise near"));
    desk.undo();
    EXPECT_EQ(params, before);

    params.projection.near = 10.0;
    desk.settle();
    EXPECT_TRUE(trouble().starts_with("near = 10 cuts into ")) << trouble();
    ui.click("lower/Lower near");
    desk.settle();
    EXPECT_EQ(params.projection.near, 3.4);
}

TEST_F(PrecisionView, MarksNearFarAndVisibleObjects) {
    desk.params().view.layout.big = ViewName::lower_right;  // large enough for names
    show(Topic::precision);
    EXPECT_TRUE(std::ranges::any_of(desk.recorded(), [](const RecordedItem& item) {
        return item.label.starts_with("lower/precision/mark/") && item.label.find("quad at 4") != std::string::npos;
    }));
    EXPECT_TRUE(has("lower/precision/name/near"));
    EXPECT_TRUE(has("lower/precision/name/far"));
}

TEST_F(PrecisionView, CodesAreSummarizedInASentence) {
    show(Topic::codes);
    const auto says = [&](std::string_view start) {
        return std::ranges::any_of(desk.recorded(), [&](const RecordedItem& item) {
            return std::string_view(item.label).starts_with("lower/" + std::string(start));
        });
    };
    EXPECT_TRUE(says("One tick every 262,144 codes. Half of all codes lie between near and z = 0.002."));
    EXPECT_TRUE(has("lower/codes/tick/64"));
    params.depth.format = DepthFormat::d4;
    desk.settle();
    EXPECT_TRUE(says("Every code has a tick."));
    EXPECT_TRUE(has("lower/codes/tick/15"));
    EXPECT_FALSE(has("lower/codes/tick/16"));
    params.depth.format = DepthFormat::d32f;
    desk.settle();
    EXPECT_TRUE(says("One tick every"));
}

/// The window is so small that the views have their smallest size.
TEST_F(PrecisionView, WorksInSmallViewsAndForAnyLens) {
    ImGui::GetIO().DisplaySize = {700, 480};
    params.view.lower_left = Topic::automatic;  // only one of the two lower views fits
    for (const Topic topic : {Topic::precision, Topic::codes}) {
        for (const char* format : {"d4", "d16", "d24", "d32f"}) {
            for (const char* mapping : {"standard", "reversed", "logarithmic"}) {
                for (const char* lens : {R"("near": 1e-6, "far": 1e9)", R"("near": 999999, "far": 1e9)",
                                         R"("type": "orthographic", "near": 0.5, "far": 0.50001)"}) {
                    SCOPED_TRACE(std::string(format) + " " + mapping + " " + lens);
                    const Result<Params> state =
                        parse_state(std::string(R"({"scene": "coplanar", "depth": {"format": ")") + format +
                                        R"(", "mapping": ")" + mapping + R"("}, "projection": {)" + lens + "}}",
                                    "lens");
                    ASSERT_TRUE(state) << state.error();
                    params.depth = state->depth;
                    params.projection = state->projection;
                    show(topic);
                    EXPECT_TRUE(has(topic == Topic::precision ? "lower/precision/chart" : "lower/codes/ticks"));
                    EXPECT_EQ(params.projection, state->projection) << "drawing changes no state";
                }
            }
        }
    }
}

}  // namespace
}  // namespace viewing::test
