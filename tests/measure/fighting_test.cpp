// Compares the depth fighting counted in GL's pictures with the formulas' predictions: the smallest gap that each
// format and mapping resolves, and each cure. VIEWING_LONG_TESTS=N searches N times as many cases.
#include <cmath>
#include <cstdlib>
#include <map>

#include "gl/gl_test.h"
#include "state/presets.h"
#include "topics/depth/measured/fighting_measure.h"
#include "topics/depth/measured/minimum_gap.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

constexpr glm::ivec2 fighting_px(640, 360);

/// Returns the number of codes between the near plane and a distance, or a million for a float format.
double codes_before(const Params& params, double z) {
    const double n = params.projection.near, f = params.projection.far;
    const DepthPrecision precision = precision_of(params.depth.format);
    double depth = f / (f - n) - f * n / ((f - n) * z);
    if (params.projection.type == ProjectionType::orthographic) depth = (z - n) / (f - n);
    if (params.depth.mapping == DepthMapping::logarithmic) depth = std::log(z / n) / std::log(f / n);
    return precision.is_float ? 1e6 : depth * (std::exp2(precision.bits) - 1.0);
}

class Fighting : public testing::GlTest {
protected:
    static MinimumGap search(const Params& params, double distance) {
        const Result<MinimumGap> found = find_minimum_gap(renderer(), params, distance);
        EXPECT_TRUE(found) << found.error();
        return *found;
    }

    static FightingCounts count(const std::string& preset) {
        const Result<LoadedState> state = load_state(preset);
        EXPECT_TRUE(state) << state.error();
        const Scene scene = testing::scene_named(std::get<std::string>(state->params.scene));
        return count(state->params, scene);
    }
    static FightingCounts count(const Params& params, const Scene& scene) {
        const auto counts = count_fighting(renderer(), params, scene, near_coplanar_pairs(scene), fighting_px);
        EXPECT_TRUE(counts) << counts.error();
        return *counts;
    }
};

Params random_depth(Random& random, DepthFormat format, DepthMapping mapping, bool orthographic) {
    Params params;
    params.depth.format = format;
    params.depth.mapping = mapping;
    params.depth.func = random.number(0, 1) < 0.5 ? CompareFunc::less : CompareFunc::lequal;
    ProjectionParams& projection = params.projection;
    projection.type = orthographic ? ProjectionType::orthographic : ProjectionType::perspective;
    projection.fovy = random.number(15.0, 90.0);
    projection.height = random.number(1.0, 30.0);
    projection.near = std::exp(random.number(std::log(1e-3), std::log(5.0)));
    projection.far = projection.near * std::exp(random.number(std::log(3.0), std::log(1e5)));
    return params;
}

TEST_F(Fighting, BeginsWithinAFactorOfThreeOfThePrediction) {
    Random random(seed);
    const int cases = testing::trials(6);
    for (int format = 0; format < 12; ++format) {
        for (const DepthMapping mapping : {DepthMapping::standard, DepthMapping::reversed, DepthMapping::logarithmic}) {
            double lowest = 1e9, highest = 0.0;
            for (int trial = 0; trial < cases; ++trial) {
                const Params params = random_depth(random, static_cast<DepthFormat>(format), mapping, trial % 3 == 2);
                const double near = params.projection.near, far = params.projection.far;
                double distance = near;
                do {
                    distance = near * std::pow(far / near, random.number(0.2, 0.98));
                } while (codes_before(params, distance) < 2.5);  // otherwise no position is a whole code nearer
                const MinimumGap found = search(params, distance);
                const std::string what = "seed " + std::to_string(seed) + " format " + std::to_string(format) +
                                         " mapping " + std::to_string(static_cast<int>(mapping)) + " near " +
                                         std::to_string(near) + " far " + std::to_string(far) + " z " +
                                         std::to_string(distance);
                ASSERT_TRUE(found.gap) << what << ": " << found.problem;
                const double ratio = *found.gap / found.predicted.gap();
                EXPECT_GE(ratio, 1.0 / 3.0) << what;
                EXPECT_LE(ratio, 3.0) << what;
                lowest = std::min(lowest, ratio);
                highest = std::max(highest, ratio);
            }
            std::printf("format %d mapping %d: measured over predicted %.2f to %.2f\n", format,
                        static_cast<int>(mapping), lowest, highest);
        }
    }
}

TEST_F(Fighting, DependsOnTheGapInCodes) {
    // With 16 bits, arithmetic rounding is small, so the fraction of ties equals the fraction of wrong pixels.
    const Scene scene = testing::scene_named("coplanar");
    const Result<LoadedState> state = load_state("fighting-16-bit");
    ASSERT_TRUE(state) << state.error();
    for (const double near : {0.1, 0.25, 0.5, 1.0}) {
        Params params = state->params;
        params.projection.near = near;
        const FightingCounts counts = count(params, scene);
        ASSERT_EQ(counts.pairs.size(), 6U);
        for (const CountedPair& counted : counts.pairs) {
            const double z = 4.0 - counted.pair.center_world.z;  // from the camera, which looks along −z
            // A code is z² (f − n) / (f n (2¹⁶ − 1)) wide at distance z. Dividing by this gives the gap in codes.
            const double gap_codes = counted.pair.gap() / (z * z * (200.0 - near) / (200.0 * near * 65535.0));
            const double share = static_cast<double>(counted.wrong) / static_cast<double>(counted.pixels);
            EXPECT_NEAR(share, std::max(1.0 - gap_codes, 0.0), 0.06) << "near " << near << " z " << z;
        }
    }
}

TEST_F(Fighting, IsIndependentOfMethodPlaneAndShadow) {
    const Scene scene = testing::scene_named("coplanar");
    Params params = load_state("depth-fighting")->params;
    const FightingCounts alone = count(params, scene);
    EXPECT_GT(alone.wrong_fraction(), 0.1);
    params.visibility.method = VisibilityMethod::painter;
    params.shadow.enabled = params.reflection.enabled = true;
    params.view.shows = Shows::depth;
    params.planes.front().extent = 100.0;
    EXPECT_EQ(count(params, scene).wrong_fraction(), alone.wrong_fraction());
}

TEST_F(Fighting, IsCuredByRaisingNearMoreBitsReversedFloatsAndLogarithms) {
    EXPECT_GT(count("depth-fighting").wrong_fraction(), 0.1);
    EXPECT_GT(count("fighting-16-bit").wrong_fraction(), 0.3);
    for (const char* const cure : {"coplanar", "fighting-near-raised", "fighting-reversed", "fighting-logarithmic"}) {
        const FightingCounts counts = count(cure);
        EXPECT_EQ(counts.wrong_fraction(), 0.0) << cure;
        EXPECT_EQ(counts.wrong_elsewhere, 0) << cure;
        for (const CountedPair& pair : counts.pairs) EXPECT_GT(pair.pixels, 1000) << cure;
    }
}

TEST_F(Fighting, OnDecalsIsCuredByAnOffsetOfTheRightSizeAndSign) {
    EXPECT_GT(count("fighting-decals").wrong_fraction(), 0.3);
    EXPECT_EQ(count("fighting-decals").wrong_elsewhere, 0);
    const FightingCounts right = count("fighting-offset");
    ASSERT_EQ(right.pairs.size(), 4U);
    EXPECT_EQ(right.wrong_fraction(), 0.0);
    EXPECT_EQ(right.wrong_elsewhere, 0);
    // The offset is half a code, so rounding removes it at every other pixel.
    EXPECT_NEAR(count("fighting-offset-too-little").wrong_fraction(), 0.5, 0.06);
    EXPECT_EQ(count("fighting-offset-too-little").wrong_elsewhere, 0);
    const FightingCounts too_much = count("fighting-offset-too-much");
    EXPECT_EQ(too_much.wrong_fraction(), 0.0);
    EXPECT_GT(too_much.wrong_elsewhere, 300);
    EXPECT_GT(count("fighting-offset-wrong-sign").wrong_fraction(), 0.99);
}

TEST_F(Fighting, OnDecalsIsCuredByTheStencilButNotByEqualDepth) {
    const FightingCounts equal = count("fighting-decals-equal"), stencil = count("fighting-decals-stencil");
    ASSERT_EQ(equal.pairs.size(), 4U);
    ASSERT_EQ(stencil.pairs.size(), 4U);
    EXPECT_GT(equal.wrong_fraction(), 0.1);
    EXPECT_LT(equal.wrong_fraction(), 0.9);
    EXPECT_EQ(stencil.wrong_fraction(), 0.0);
    EXPECT_EQ(equal.wrong_elsewhere + stencil.wrong_elsewhere, 0);
    for (const CountedPair& pair : stencil.pairs) EXPECT_GT(pair.pixels, 1000);
}

TEST_F(Fighting, IsCountedWithEachCureAsIfSetByHand) {
    const char* const settings[][2] = {
        {"projection.near=3.4", ""},
        {"depth.format=d32f", ""},
        {"depth.format=d32f", "depth.mapping=reversed"},
        {"depth.mapping=logarithmic", ""},
        {"depth.offset.factor=-1", "depth.offset.units=-1"},
        {"depth.decals=equal", ""},
        {"depth.decals=stencil", ""},
    };
    const Params params = load_state("depth-fighting")->params;
    const Scene scene = testing::scene_named("coplanar");
    FightingReport report =
        fighting_report(count(params, scene), params, derive_for(params, scene, fighting_px), scene, fighting_px);
    ASSERT_EQ(report.cured.size(), std::size(settings));
    ASSERT_TRUE(count_cures(report, renderer(), scene));
    for (std::size_t i = 0; i < std::size(settings); ++i) {
        Params by_hand = params;
        for (const std::string setting : settings[i])
            if (!setting.empty()) by_hand = *apply_settings(by_hand, std::vector{setting});
        EXPECT_EQ(report.cured[i].cure.params, by_hand) << settings[i][0];
        EXPECT_EQ(report.cured[i].counts->wrong_fraction(), count(by_hand, scene).wrong_fraction()) << settings[i][0];
    }
    const auto share = [&](CureKind kind) {
        return report.cured[static_cast<std::size_t>(kind)].counts->wrong_fraction();
    };
    EXPECT_EQ(share(CureKind::near) + share(CureKind::reversed_float) + share(CureKind::logarithmic), 0.0);
    EXPECT_GT(share(CureKind::float_format), 0.1) << "near depth 1, a float has as many codes as 24 bits";
    EXPECT_GT(share(CureKind::equal), 0.1) << "there is a gap";
    EXPECT_EQ(share(CureKind::stencil), 0.0);
    EXPECT_GT(report.cured.back().counts->wrong_elsewhere, 1000) << "parts that stick out beside the wall are lost";
}

TEST_F(Fighting, IsCountedInTheWholeFrameAtEveryStep) {
    const Scene scene = testing::scene_named("coplanar");
    Params params = load_state("depth-fighting")->params;
    const FightingCounts whole = count(params, scene);
    params.view.call = 3;
    params.view.triangle = 1;
    params.view.shows = Shows::fighting;
    EXPECT_EQ(count(params, scene).wrong_fraction(), whole.wrong_fraction());
}

TEST_F(Fighting, MatchesSharesPredictedFromCodesAlone) {
    // Covers the cures and mistakes of the presets, with so few bits that rounding plays no part.
    for (const char* const preset : {"fighting-decals", "fighting-decals-stencil", "fighting-offset-too-little",
                                     "fighting-16-bit", "fighting-reversed", "fighting-logarithmic"}) {
        const Result<LoadedState> state = load_state(preset);
        ASSERT_TRUE(state) << state.error();
        Params params = state->params;
        params.depth.format = DepthFormat::d12;
        const Scene scene = testing::scene_named(std::get<std::string>(params.scene));
        const glm::ivec2 large_px = 2 * fighting_px;  // makes the stripes many pixels wide
        const Derived derived = derive(params, scene, {large_px, renderer().capabilities().clip_control});
        const auto counts = count_fighting(renderer(), params, scene, near_coplanar_pairs(scene), large_px);
        int said = 0;
        ASSERT_TRUE(counts) << counts.error();
        for (const CountedPair& counted : counts->pairs) {
            const auto predicted = predict_pair(counted.pair, params, derived, large_px).wrong_share;
            if (!predicted) continue;  // there are too few codes, or the code equals the clear value
            ++said;
            EXPECT_TRUE(predicted->holds(counted.wrong_fraction()))
                << preset << " z " << counted.pair.center_world.z << ": " << counted.wrong_fraction() << " and "
                << predicted->least << " to " << predicted->most;
        }
    }
}

TEST_F(Fighting, StaysWithinThePredictionFromEveryCamera) {
    // Draws the six pairs with random lenses, gaps, tilts and formats; the prediction must hold for each picture.
    Random random(seed);
    int said = 0, said_between = 0;
    for (int trial = 0; trial < 24; ++trial) {
        Params params = load_state("depth-fighting")->params;
        constexpr DepthFormat formats[] = {DepthFormat::d16, DepthFormat::d12, DepthFormat::d10, DepthFormat::d24};
        params.depth.format = formats[trial % 4];
        params.depth.mapping = static_cast<DepthMapping>(trial / 4 % 3);
        params.depth.func = trial % 5 != 0 ? CompareFunc::less : CompareFunc::lequal;
        params.projection.near = std::exp(random.number(std::log(0.05), std::log(2.0)));
        params.projection.far = random.number(95.0, 400.0);
        // The gap is between a tenth of a code and a whole code at a random distance among the pairs.
        const double z = random.number(4.0, 44.0), levels = std::exp2(precision_of(params.depth.format).bits) - 1.0;
        const double code = params.depth.mapping == DepthMapping::logarithmic
                                ? z * std::log(params.projection.far / params.projection.near) / levels
                                : z * z / (params.projection.near * levels);
        params.coplanar.gap = std::clamp(code * random.number(0.1, 1.0), 1e-4, 0.2);
        params.coplanar.tilt = random.number(0.0, 50.0);
        const Result<Scene> scene = load_scene(params.scene, "", params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        const Params moved = jittered(params, trial % spread_cameras);
        const FightingCounts counts = count(moved, *scene);
        const Derived derived = derive(moved, *scene, {fighting_px, renderer().capabilities().clip_control});
        for (const CountedPair& counted : counts.pairs) {
            const auto share = predict_pair(counted.pair, moved, derived, fighting_px).wrong_share;
            if (!share || counted.pixels < 300) continue;
            ++said;
            said_between += share->most > 0.02 && share->least < 0.98 ? 1 : 0;
            EXPECT_TRUE(share->holds(counted.wrong_fraction()))
                << "seed " << seed << " trial " << trial << " z " << counted.pair.center_world.z << ": "
                << counted.wrong_fraction() << " and " << share->least << " to " << share->most;
        }
    }
    std::printf("%d shares were said, %d of them between none and all\n", said, said_between);
    EXPECT_GT(said, 80);
    EXPECT_GT(said_between, 20);
}

TEST_F(Fighting, At24BitsIsPredictedOnlyWhenCertainAndVariesByCamera) {
    const Params params = load_state("depth-fighting")->params;
    const Scene scene = testing::scene_named("coplanar");
    const Derived derived = derive(params, scene, {fighting_px, true});
    FightingReport report = fighting_report(count(params, scene), params, derived, scene, fighting_px);
    ASSERT_TRUE(count_spread(report, renderer(), params, scene));
    for (const FightingReport::Row& row : report.rows) {
        EXPECT_EQ(row.spread.cameras, spread_cameras);
        EXPECT_LE(row.spread.least, row.spread.mean());
        EXPECT_LE(row.spread.mean(), row.spread.most);
        EXPECT_EQ(row.predicted.wrong_share.has_value(), row.predicted.onset.gap() < 0.01) << row.predicted.distance;
    }
    EXPECT_EQ(report.rows.front().spread.most, 0.0);
    const ShareSpread& at_24 = report.rows.at(3).spread;
    EXPECT_GT(at_24.most - at_24.least, 0.3) << "a single picture says little";
}

/// Where the formulas predict no share, the window shows the mean share of the counted jittered cameras. In almost all
/// cases, the share that a further camera sees is within 4 standard deviations of this mean, plus `rare`.
TEST_F(Fighting, IsCountedWithItsSpreadWhereNothingIsPredicted) {
    constexpr double rare = 0.03;  // the 12 counted cameras may all miss a share this small
    int checked = 0, changed = 0, outside = 0;
    double widest = 0.0;
    for (const char* const preset : {"depth-fighting", "fighting-decals", "fighting-decals-equal",
                                     "fighting-offset-too-little", "fighting-reversed-clip-range"}) {
        const auto [params, scene] = testing::preset_named(preset);
        const Derived derived = derive_for(params, scene, fighting_px);
        FightingReport report = fighting_report(count(params, scene), params, derived, scene, fighting_px);
        ASSERT_TRUE(count_spread(report, renderer(), params, scene));
        for (int fresh = 0; fresh < 4; ++fresh) {
            const FightingCounts counts = count(jittered(params, spread_cameras + fresh), scene);
            for (std::size_t i = 0; i < report.rows.size(); ++i) {
                const ShareSpread& spread = report.rows[i].spread;
                if (report.rows[i].predicted.wrong_share || counts.pairs[i].pixels == 0) continue;
                ++checked;
                changed += spread.deviation() > 0.0 ? 1 : 0;
                widest = std::max(widest, 2.0 * spread.standard_error());
                EXPECT_EQ(spread.cameras, spread_cameras);
                const double away = std::abs(counts.pairs[i].wrong_fraction() - spread.mean());
                outside += away > 4.0 * spread.deviation() + rare ? 1 : 0;
            }
        }
    }
    std::printf("%d shares without a prediction; 2 standard errors of a mean are at most %.2f\n", checked, widest);
    EXPECT_GT(checked, 80);
    EXPECT_GT(changed, 60);
    EXPECT_LE(outside, checked / 50);
    EXPECT_LT(widest, 0.35) << "narrow enough to teach";
}

/// With a gap just above the safe one, no pixel of the pair is wrong, even at its farthest corner.
TEST_F(Fighting, HasNoWrongPixelAboveTheSafeGap) {
    Random random(seed);
    int checked = 0;
    for (int trial = 0; trial < testing::trials(60); ++trial) {
        Params params = testing::preset_named("fighting-16-bit").params;
        const int kind = static_cast<int>(random.number(0.0, 3.0));
        params.depth.format = kind == 0 ? DepthFormat::d16 : kind == 1 ? DepthFormat::d24 : DepthFormat::d12;
        params.depth.mapping = static_cast<DepthMapping>(static_cast<int>(random.number(0.0, 3.0)));
        params.projection.near = std::exp(random.number(std::log(0.03), std::log(1.0)));
        params.camera.yaw = random.number(-2.5, 2.5);
        params.coplanar.tilt = random.number(0.0, 45.0);
        params.coplanar.gap = 1e-6;
        const auto scene_of_gap = [&] { return load_scene(params.scene, "", params.coplanar); };
        const auto viewed = [&](const Scene& scene) {
            return derive(params, scene, {fighting_px, renderer().capabilities().clip_control});
        };
        const Result<Scene> close = scene_of_gap();
        ASSERT_TRUE(close) << close.error();
        const std::vector<FlatPair> pairs = near_coplanar_pairs(*close);
        ASSERT_EQ(pairs.size(), 6U);
        const auto chosen = static_cast<std::size_t>(random.number(0.0, 6.0));
        const auto needed = [&](const FlatPair& pair, const Scene& scene) {
            const PairPrediction found = predict_pair(pair, params, viewed(scene), fighting_px);
            return found.onset.is_reachable ? found.onset.gap() * found.slant : 1e300;
        };
        params.coplanar.gap = 1.003 * needed(pairs[chosen], *close);
        if (params.coplanar.gap > 0.09) continue;  // beyond the slider's range
        const Result<Scene> apart = scene_of_gap();
        ASSERT_TRUE(apart) << apart.error();
        for (const CountedPair& counted : count(params, *apart).pairs) {
            if (counted.pair.gap() < 1.001 * needed(counted.pair, *apart)) continue;
            ++checked;
            EXPECT_EQ(counted.wrong, 0) << "seed " << seed << " trial " << trial << " format " << kind << " mapping "
                                        << static_cast<int>(params.depth.mapping) << " near " << params.projection.near
                                        << " tilt " << params.coplanar.tilt << " z " << counted.pair.center_world.z
                                        << " gap " << params.coplanar.gap << " of " << counted.pixels;
        }
    }
    std::printf("%d pairs above the safe gap\n", checked);
    EXPECT_GT(checked, 60);
}

TEST_F(Fighting, DistinguishesVanishingFromBleeding) {
    const FightingCounts few_bits = count("depth-few-bits");
    EXPECT_GT(few_bits.pairs.back().vanished, 1000) << "the pair at distance 84 has the clear value's code";
    EXPECT_EQ(few_bits.pairs.front().vanished, 0);
    EXPECT_EQ(few_bits.bleeding_elsewhere, 0) << "nothing is in front of it";
    EXPECT_EQ(few_bits.vanished_elsewhere, few_bits.wrong_elsewhere);
    const FightingCounts too_much = count("fighting-offset-too-much");
    EXPECT_GT(too_much.bleeding_elsewhere, 300);
    EXPECT_EQ(too_much.vanished(), 0);
}

TEST_F(Fighting, HasNoSmallestGapIfDepthDoesNotDecide) {
    for (const char* const setting :
         {"depth.test=false", "depth.func=always", "depth.write=false", "depth.func=never"}) {
        const MinimumGap found = search(testing::params_with({setting}), 5.0);
        EXPECT_FALSE(found.gap) << setting;
        EXPECT_FALSE(found.problem.empty()) << setting;
    }
    const Params params;
    EXPECT_FALSE(search(params, params.projection.near).gap) << "nothing fits in front of the near plane";
    EXPECT_FALSE(search(params, 0.0).gap);
    EXPECT_TRUE(search(params, 1e9).gap) << "counts as at the far plane";
    const Params reversed = testing::params_with({"depth.mapping=reversed", "depth.format=d32f"});
    EXPECT_TRUE(search(reversed, 1e9).gap) << "where depth is 0";
}

TEST_F(Fighting, HasASmallestGapWhenACodeSpansTheEyeDistance) {
    for (const char* const format : {"depth.format=d24", "depth.format=d32f"}) {
        const MinimumGap found = search(testing::params_with({"projection.near=1e-6", format}), 21.5);
        ASSERT_TRUE(found.gap) << format << ": " << found.problem;
        EXPECT_GT(found.predicted.quantization, 0.1 * found.distance) << format;
        EXPECT_GT(*found.gap, found.predicted.gap() / 3.0) << format;
        EXPECT_LT(*found.gap, found.predicted.gap() * 3.0) << format;
    }
}

TEST_F(Fighting, HasTheSameSmallestGapForEveryClearValue) {
    for (const char* const mapping : {"depth.mapping=standard", "depth.mapping=reversed"}) {
        const MinimumGap expected = search(testing::params_with({mapping}), 5.0);
        ASSERT_TRUE(expected.gap);
        for (const char* const slip : {"depth.clear=false", "depth.write_while_clearing=false",
                                       "depth.reversed_clear=false", "depth.clear_value=0"})
            EXPECT_EQ(search(testing::params_with({mapping, slip}), 5.0).gap, expected.gap) << mapping << " " << slip;
    }
}

TEST_F(Fighting, CanBeCanceled) {
    WorkProgress progress;
    progress.canceled = true;
    EXPECT_FALSE(find_minimum_gap(renderer(), Params{}, 5.0, &progress));
    const Scene scene = testing::scene_named("coplanar");
    EXPECT_FALSE(count_fighting(renderer(), Params{}, scene, near_coplanar_pairs(scene), fighting_px, &progress));
}

}  // namespace
}  // namespace viewing
