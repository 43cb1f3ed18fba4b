// Tests the depth fighting view in its own window, with reports made here: its texts, and the columns that it drops
// when it is narrow. Everything must stay inside the view.
#include "topics/depth/shown/fighting_view.h"

#include <algorithm>

#include "desk.h"
#include "ui/parts/look.h"

namespace viewing::test {
namespace {

class FightingView : public ::testing::Test {
protected:
    Session session = session_of("depth-fighting");
    widgets::Context context;
    Rect rect{{20, 20}, {620, 250}};
    std::shared_ptr<FightingReport> report;
    widgets::test::Harness ui{context, [this] { draw(); }, {1000, 700}};

    FightingView() {
        context.palette = widgets::palette_of(widgets::ThemeKind::dark);
        context.scale = 1.0F;
        context.fonts = load_fonts(1.0F);
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        widgets::ApplyStyle(context);
    }

    void draw() {
        widgets::NewFrame(context);
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({1000, 700});
        ImGui::Begin("view", nullptr, ImGuiWindowFlags_NoDecoration);
        draw_fighting_view(session, report.get(), rect);
        ImGui::End();
    }

    /// Makes a report of the six pairs; a quarter of the last pair's pixels are wrong.
    void make_report() {
        const Derived derived = derive(session.params, session.scene(), {});
        FightingCounts counts;
        for (const FlatPair& pair : near_coplanar_pairs(session.scene()))
            counts.pairs.push_back({.pair = pair, .pixels = 12000});
        counts.pairs.back().wrong = 3000;
        counts.wrong_elsewhere = counts.bleeding_elsewhere = 77;
        counts.pixels_elsewhere = 1000;
        report = std::make_shared<FightingReport>(
            fighting_report(std::move(counts), session.params, derived, session.scene(), {640, 360}));
        report->minimum_gap.emplace();
        report->minimum_gap->distance = 14.0;
        report->minimum_gap->predicted = {0.05, 0.01, true};
        report->minimum_gap->gap = 0.036;
    }
    /// Returns whether anything in this color is drawn within an item whose label contains `part`.
    bool paints(std::string_view part, ImU32 color) const {
        for (const RecordedItem& item : context.recorded) {
            if (item.label.find(part) == std::string::npos) continue;
            const auto is_painted = [&](const ImDrawVert& vertex) {
                return vertex.col == color && vertex.pos.x >= item.min.x && vertex.pos.x <= item.max.x &&
                       vertex.pos.y >= item.min.y && vertex.pos.y <= item.max.y;
            };
            const ImDrawData& drawn = *ImGui::GetDrawData();
            for (int list = 0; list < drawn.CmdListsCount; ++list)
                if (std::ranges::any_of(drawn.CmdLists[list]->VtxBuffer, is_painted)) return true;
        }
        return false;
    }
    bool says(std::string_view part) const {
        return std::ranges::any_of(
            context.recorded, [part](const RecordedItem& item) { return item.label.find(part) != std::string::npos; });
    }
    bool is_found(const std::string& name) const {
        return std::ranges::find(context.targets.found, name, &widgets::Targets::Found::name) !=
               context.targets.found.end();
    }
};

TEST_F(FightingView, CoveredColumnsAndTheirHintsShowNothing) {
    make_report();
    rect = {{20, 20}, {980, 400}};
    ui.frames(3);
    ASSERT_TRUE(says("minimum gap") && says("all pairs"));
    context.targets.covered = {"column:fighting.safe_gap", "column:fighting.counted"};
    ui.frames(3);
    EXPECT_FALSE(says("minimum gap"));
    EXPECT_FALSE(says("all pairs"));
    for (const RecordedItem& item : context.recorded) EXPECT_EQ(item.label.find(" %"), std::string::npos) << item.label;
    EXPECT_TRUE(says(": ?"));
}

TEST_F(FightingView, EveryColumnIsFoundByName) {
    make_report();
    rect = {{20, 20}, {980, 400}};
    std::vector<std::string>& names = context.targets.highlighted;
    for (const char* name :
         {"pair", "z", "gap", "step", "safe_gap", "predicted", "trembling", "counted", "wrong_pixels"})
        names.push_back(std::string("column:fighting.") + name);
    ui.frames(3);
    for (const std::string& name : names) EXPECT_TRUE(is_found(name)) << name;
}

TEST_F(FightingView, SaysThatItCountsBeforeTheFirstResult) {
    ui.frames(2);
    EXPECT_TRUE(says("Counting…"));
}

TEST_F(FightingView, HasARowForEachPairAndATotal) {
    make_report();
    ui.frames(3);
    EXPECT_TRUE(says("back / front quad at 4: 0.0%"));
    EXPECT_TRUE(says("back / front quad at 84: 25.0%"));
    EXPECT_TRUE(says("all pairs: 4.2% wrong"));
    EXPECT_TRUE(says("77 bleed through"));
    EXPECT_TRUE(says("640 × 360 pixels"));
    EXPECT_TRUE(says("predicted 0.06"));
    EXPECT_TRUE(says("counted 0.036"));
    EXPECT_TRUE(says("safe gap"));
}

/// A mean would say nothing about one camera's count: 0.6 is far from 0.3.
TEST_F(FightingView, ShowsTheCountedRangeWhereNothingIsPredicted) {
    make_report();
    for (FightingReport::Row& row : report->rows) row.predicted.wrong_share.reset();
    for (const double share : {0.1, 0.2, 0.6}) report->rows.front().spread.take(share);
    rect.max.x = rect.min.x + 980.0F;
    ui.frames(3);
    EXPECT_TRUE(says("back / front quad at 4: ≈ 10 – 60%"));
    EXPECT_TRUE(says("back / front quad at 84: –"));
}

TEST_F(FightingView, ShowsIntervalSpreadAndVanishedPixels) {
    make_report();
    report->rows.front().predicted.wrong_share = ShareInterval{0.25, 0.605};
    for (const double share : {0.1, 0.2, 0.6}) report->rows.front().spread.take(share);
    report->counts.pairs.front().vanished = 1234;
    rect.max.x = rect.min.x + 980.0F;
    ui.frames(3);
    EXPECT_TRUE(says("1,234 show the background"));
    EXPECT_TRUE(says("jittered"));
    EXPECT_NEAR(report->rows.front().spread.mean(), 0.3, 1e-12);
    EXPECT_EQ(report->rows.front().spread.least, 0.1);
    EXPECT_EQ(report->rows.front().spread.most, 0.6);
}

TEST_F(FightingView, UsesTheTroubleColorOnlyForWrongPixels) {
    make_report();
    ui.frames(3);
    EXPECT_TRUE(paints("all pairs", palette().trouble));
    EXPECT_TRUE(paints("bleed through", palette().trouble));
    report->counts.wrong_elsewhere = report->counts.bleeding_elsewhere = 0;
    ui.frames(3);
    EXPECT_TRUE(paints("all pairs", palette().trouble));
    EXPECT_FALSE(paints("elsewhere: 0", palette().trouble));
    EXPECT_TRUE(paints("elsewhere: 0", palette().text));
    EXPECT_TRUE(paints("640 × 360 pixels", palette().quiet));
    report->counts.pairs.back().wrong = 0;
    ui.frames(3);
    EXPECT_FALSE(paints("all pairs", palette().trouble));
}

TEST_F(FightingView, SaysWhatIsStillBeingCounted) {
    make_report();
    report->counts_are_behind = report->gap_is_behind = true;
    ui.frames(3);
    EXPECT_TRUE(says("counting…"));
    EXPECT_TRUE(says("searching"));
    EXPECT_FALSE(says("all pairs"));
    EXPECT_TRUE(says("back / front quad at 84: 25.0%")) << "the old counts, grayed out";
}

/// A lesson must not frame a column that is not drawn.
TEST_F(FightingView, KeepsTheColumnThatALessonNames) {
    make_report();
    for (const char* name : {"column:fighting.step", "column:fighting.gap", "column:fighting.predicted"})
        for (float width = 330.0F; width <= 700.0F; width += 37.0F) {
            rect = {{20, 20}, {20 + width, 250}};
            context.targets.highlighted = {name};
            ui.frames(3);
            EXPECT_TRUE(is_found(name)) << name << " at " << width;
        }
}

TEST_F(FightingView, DropsColumnsWhenNarrowButKeepsTheCounts) {
    make_report();
    for (const float width : {180.0F, 230.0F, 300.0F, 420.0F, 620.0F, 900.0F}) {
        rect.max.x = rect.min.x + width;
        ui.frames(4);
        EXPECT_TRUE(says("back / front quad at 84: 25.0%")) << width;
        EXPECT_EQ(says("safe gap"), width >= 230.0F) << width;
        const bool has_pixels = std::ranges::any_of(
            context.recorded, [](const RecordedItem& item) { return item.label.ends_with("wrong pixels"); });
        EXPECT_EQ(has_pixels, width >= 620.0F) << width;
        for (const RecordedItem& item : context.recorded) {
            EXPECT_GE(item.min.x, rect.min.x) << item.label << " at " << width;
            EXPECT_LE(item.max.x, rect.max.x + 1.0F) << item.label << " at " << width;
        }
    }
}

TEST_F(FightingView, ShowsTheResultOfEachCureAndAppliesIt) {
    make_report();
    ASSERT_EQ(report->cured.size(), 7U);
    FightingCounts& reversed = report->cured[2].counts.emplace(report->counts);
    FightingCounts& stencil = report->cured[6].counts.emplace(report->counts);
    reversed.wrong_elsewhere = 0;
    stencil.pairs.back().wrong = 0;
    ui.frames(3);
    EXPECT_TRUE(says("reversed: 4.2%"));
    EXPECT_FALSE(says("reversed: +"));
    EXPECT_TRUE(says("stencil: 0.0%"));
    EXPECT_TRUE(says("stencil: +77"));
    EXPECT_TRUE(says("near 3.4: …")) << "not counted yet";
    EXPECT_TRUE(paints("reversed: 4.2%", palette().trouble));
    EXPECT_FALSE(paints("stencil: 0.0%", palette().trouble));
    ui.click("fighting/reversed");
    EXPECT_EQ(session.params, report->cured[2].cure.params);
    EXPECT_EQ(session.params.depth.mapping, DepthMapping::reversed);
}

TEST_F(FightingView, OffersASceneThatFights) {
    session.params.scene = std::string("torus-and-boxes");
    report = std::make_shared<FightingReport>();
    ui.frames(2);
    EXPECT_TRUE(says("no depth fighting"));
    ui.click("fighting/Open coplanar");
    EXPECT_EQ(std::get<std::string>(session.params.scene), "coplanar");
}

}  // namespace
}  // namespace viewing::test
