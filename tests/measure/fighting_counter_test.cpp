// Counts computed in the background equal synchronous counts, whenever they arrive. Nothing starts while the user holds
// a control, and results from an earlier state are marked as such.
#include "topics/depth/measured/fighting_counter.h"

#include <thread>

#include "gl/gl_test.h"
#include "state/presets.h"
#include "topics/depth/measured/fighting_measure.h"

namespace viewing {
namespace {

constexpr glm::ivec2 counted_px(320, 180);
constexpr bool may_wait = true, is_at_rest = true;

class Counter : public testing::GlTest {
protected:
    std::shared_ptr<const FightingReport> update(bool waits, bool rests) {
        return counter.update(renderer(), params, scene, version, counted_px, waits, rests);
    }
    /// Runs frame after frame, as a window does.
    std::shared_ptr<const FightingReport> finish() {
        auto report = update(!may_wait, is_at_rest);
        for (int frame = 0; frame < 10000 && counter.wants_frames(); ++frame) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            report = update(!may_wait, is_at_rest);
        }
        return report;
    }

    Params params = load_state("depth-fighting")->params;
    Scene scene = testing::scene_named("coplanar");
    int version = 1;
    FightingCounter counter;
};

TEST_F(Counter, EqualsTheSynchronousCountAndSearch) {
    const auto report = update(may_wait, !is_at_rest);
    ASSERT_TRUE(report);
    EXPECT_FALSE(counter.wants_frames());
    EXPECT_FALSE(report->counts_are_behind || report->gap_is_behind);
    const auto counts = count_fighting(renderer(), params, scene, near_coplanar_pairs(scene), counted_px);
    ASSERT_TRUE(counts);
    ASSERT_EQ(report->rows.size(), counts->pairs.size());
    for (std::size_t i = 0; i < counts->pairs.size(); ++i) {
        EXPECT_EQ(report->counts.pairs[i].wrong, counts->pairs[i].wrong);
        EXPECT_EQ(report->counts.pairs[i].pixels, counts->pairs[i].pixels);
    }
    EXPECT_EQ(report->rows[0].first, "back quad at 4");
    const Derived derived = derive_for(params, scene, counted_px);
    const auto found = find_minimum_gap(renderer(), params, derived.facts.target_distance);
    ASSERT_TRUE(found && report->minimum_gap);
    EXPECT_EQ(report->minimum_gap->gap, found->gap);
    EXPECT_EQ(report->minimum_gap->pictures, found->pictures);
}

TEST_F(Counter, GivesTheSameResultFrameByFrame) {
    const auto report = finish();
    ASSERT_TRUE(report);
    FightingCounter other;
    const auto at_once = other.update(renderer(), params, scene, version, counted_px, may_wait, is_at_rest);
    EXPECT_EQ(report->counts.wrong_fraction(), at_once->counts.wrong_fraction());
    EXPECT_EQ(report->minimum_gap->gap, at_once->minimum_gap->gap);
    EXPECT_FALSE(report->counts_are_behind || report->gap_is_behind);
    ASSERT_EQ(report->cured.size(), at_once->cured.size());
    for (std::size_t i = 0; i < report->cured.size(); ++i) {
        ASSERT_TRUE(report->cured[i].counts && at_once->cured[i].counts) << i;
        EXPECT_EQ(report->cured[i].counts->wrong_fraction(), at_once->cured[i].counts->wrong_fraction()) << i;
    }
    for (std::size_t i = 0; i < report->rows.size(); ++i)
        EXPECT_EQ(report->rows[i].spread.mean(), at_once->rows[i].spread.mean()) << i;
}

TEST_F(Counter, StartsNothingWhileAControlIsHeld) {
    const auto first = update(!may_wait, !is_at_rest);
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->counts_are_behind);
    EXPECT_EQ(first->counts.pairs.front().pixels, 0);
    EXPECT_FALSE(counter.wants_frames());
    const double before = finish()->counts.wrong_fraction();
    params.projection.near = 0.5;
    const auto held = update(!may_wait, !is_at_rest);
    EXPECT_TRUE(held->counts_are_behind && held->gap_is_behind);
    EXPECT_EQ(held->counts.wrong_fraction(), before);
    EXPECT_FALSE(counter.wants_frames());
    const auto after = finish();
    EXPECT_FALSE(after->counts_are_behind || after->gap_is_behind);
    EXPECT_EQ(after->counts.wrong_fraction(), 0.0);
}

TEST_F(Counter, PredictsAtOnceWhileTheCountsAreBehind) {
    const auto gaps = [&](const FightingReport& report) {
        std::vector<double> all;
        for (const FightingReport::Row& row : report.rows) all.push_back(row.predicted.onset.gap());
        return all;
    };
    const std::vector<double> of_first_state = gaps(*finish());
    const double share = update(!may_wait, !is_at_rest)->counts.wrong_fraction();
    params.projection.near *= 10.0;
    const auto held = update(!may_wait, !is_at_rest);
    EXPECT_TRUE(held->counts_are_behind);
    EXPECT_EQ(held->counts.wrong_fraction(), share);
    const std::vector<double> predicted = gaps(*held);
    FightingCounter other;
    const auto counted = other.update(renderer(), params, scene, version, counted_px, may_wait, is_at_rest);
    EXPECT_EQ(predicted, gaps(*counted));
    EXPECT_NE(predicted, of_first_state);
    params.projection.near /= 10.0;
    EXPECT_EQ(gaps(*update(!may_wait, !is_at_rest)), of_first_state);
}

TEST_F(Counter, IsUpToDateWhenTheHeldValueReturns) {
    const auto go_away_and_come_back = [&] {
        params.projection.near = 0.5;
        const auto away = update(!may_wait, !is_at_rest);
        EXPECT_TRUE(!away || (away->counts_are_behind && away->gap_is_behind));
        params.projection.near = load_state("depth-fighting")->params.projection.near;
        return update(!may_wait, !is_at_rest);
    };
    update(!may_wait, is_at_rest);
    go_away_and_come_back();  // the count or the search is still running
    EXPECT_TRUE(counter.wants_frames());
    finish();
    const auto back = go_away_and_come_back();
    EXPECT_FALSE(counter.wants_frames());
    EXPECT_FALSE(back->counts_are_behind || back->gap_is_behind);
    EXPECT_GT(back->counts.wrong_fraction(), 0.1);
}

TEST_F(Counter, RecountsOnlyForRelevantChanges) {
    finish();
    params.ui.theme = Theme::light;
    params.view.shows = Shows::depth;
    params.lights.front().position.x += 1.0;
    EXPECT_FALSE(update(!may_wait, !is_at_rest)->counts_are_behind);
    params.depth.format = DepthFormat::d16;
    EXPECT_TRUE(update(!may_wait, !is_at_rest)->counts_are_behind);
}

TEST_F(Counter, BelongsToTheCurrentScene) {
    finish();
    scene = testing::scene_named("torus-and-boxes");
    params.scene = std::string("torus-and-boxes");
    ++version;
    const auto held = update(!may_wait, !is_at_rest);
    EXPECT_EQ(held->rows.size(), 6U) << "the old rows stay until there are new ones";
    EXPECT_TRUE(held->counts_are_behind);
    EXPECT_TRUE(update(!may_wait, is_at_rest)) << "while new rows are counted";
    const auto report = finish();
    EXPECT_TRUE(report->rows.empty());
    EXPECT_EQ(report->counts.wrong_fraction(), 0.0);
}

}  // namespace
}  // namespace viewing
