// Pairs of objects that can fight, and the gap at which the formulas predict fighting: worked examples, and properties
// that hold for any lens.
#include "topics/depth/numbers/fighting.h"

#include "topics/depth/numbers/pair_prediction.h"

#include "unit/frame/frame_test.h"
#include "unit/geometry/random.h"

namespace viewing {
namespace {

using testing::object;
using testing::params_with;
using testing::scene_of;

/// Makes a square of side 2 in the plane y = height, moved along x.
SceneObject square(double height, double x = 0.0) {
    return object("square", quad_mesh(), {x, height, 0.0});
}

SceneObject turned(SceneObject square, const Angles& angles) {
    square.world_from_model = world_from_model(square.description.position, angles, glm::dvec3(1.0));
    return square;
}

TEST(FightingPairs, OfCoplanarAreItsSixNeighbors) {
    const Result<Scene> scene = load_scene("coplanar", "");
    ASSERT_TRUE(scene) << scene.error();
    const std::vector<FlatPair> pairs = near_coplanar_pairs(*scene);
    ASSERT_EQ(pairs.size(), 6U);
    for (int index = 0; index < 6; ++index) {
        const FlatPair& pair = pairs[static_cast<std::size_t>(index)];
        EXPECT_EQ(pair.first, 2 * index);
        EXPECT_EQ(pair.second, 2 * index + 1);
        EXPECT_NEAR(pair.offset, 0.01, 2e-4);
        EXPECT_NEAR(glm::length(pair.normal_world), 1.0, 1e-12);
    }
}

TEST(FightingPairs, AreParallelCloseAndOverlapping) {
    const auto pairs_of = [](const SceneObject& other) {
        return near_coplanar_pairs(scene_of({square(0.0), other})).size();
    };
    EXPECT_EQ(pairs_of(square(0.15)), 1U);
    EXPECT_EQ(pairs_of(square(0.25)), 0U) << "an eighth of the side apart";
    EXPECT_EQ(pairs_of(square(0.1, 1.9)), 1U);
    EXPECT_EQ(pairs_of(square(0.1, 2.1)), 0U) << "side by side";
    EXPECT_EQ(pairs_of(square(0.0, 2.0)), 0U) << "a shared edge";
    EXPECT_EQ(pairs_of(turned(square(0.1), {0.0, 0.5, 0.0})), 1U);
    EXPECT_EQ(pairs_of(turned(square(0.1), {0.0, 2.0, 0.0})), 0U);
    EXPECT_EQ(pairs_of(turned(square(0.1), {0.0, 180.0, 0.0})), 1U) << "back to back";
    EXPECT_EQ(pairs_of(object("box", box_mesh(), {0.0, -1.0, 0.0})), 0U) << "not flat";
    EXPECT_EQ(pairs_of(object("corner", triangle_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}}), {0.0, 0.05, 0.0})), 1U);
}

TEST(FightingPairs, KnowWhichSquareIsOnTop) {
    const auto pair_of = [](const SceneObject& first, const SceneObject& second) {
        const std::vector<FlatPair> pairs = near_coplanar_pairs(scene_of({first, second}));
        EXPECT_EQ(pairs.size(), 1U);
        return pairs.at(0);
    };
    EXPECT_NEAR(pair_of(square(0.0), square(0.1, 1.0)).offset, 0.1, 1e-12);
    EXPECT_NEAR(pair_of(square(0.1), square(0.0)).offset, -0.1, 1e-12);
    EXPECT_NEAR(pair_of(square(0.0), turned(square(0.1), {0.0, 180.0, 0.0})).offset, 0.1, 1e-12);
    const glm::dvec3 center = pair_of(square(0.0), square(0.1, 1.0)).center_world;
    EXPECT_NEAR(glm::distance(center, {0.5, 0.0, 0.0}), 0.0, 1e-9) << "the center of the overlap on the first";
    EXPECT_EQ(pair_of(square(0.0), square(0.0)).offset, 0.0);
    EXPECT_FALSE(pair_of(square(0.0), square(0.0)).first_lies_on_top());
    SceneObject decal = square(0.0);
    decal.description.decal = true;
    EXPECT_TRUE(pair_of(decal, square(0.0)).first_lies_on_top());
    EXPECT_FALSE(pair_of(square(0.0), decal).first_lies_on_top());
}

/// With C uploaded as V and no rotation, the picture and its fighting are those of a camera at the negated position.
TEST(PairPredictions, UseTheUploadedMatrix) {
    const Scene scene = scene_of({turned(square(0.0), {0.0, 90.0, 0.0}), turned(square(0.006), {0.0, 90.0, 0.0})});
    const std::vector<FlatPair> pairs = near_coplanar_pairs(scene);
    ASSERT_EQ(pairs.size(), 1U);
    const auto prediction = [&](const std::vector<std::string>& camera) {
        std::vector<std::string> settings = {"camera.yaw=0",     "camera.pitch=0",      "camera.roll=0",
                                             "depth.format=d16", "projection.near=0.5", "projection.far=100"};
        settings.insert(settings.end(), camera.begin(), camera.end());
        const Params params = params_with(settings);
        return predict_pair(pairs[0], params, derive(params, scene, {{640, 360}, true}), {640, 360});
    };
    const PairPrediction right = prediction({"camera.position=[0.5,0.25,20]"});
    const PairPrediction slip = prediction({"camera.position=[-0.5,-0.25,-20]", "slips.camera_as_view=true"});
    ASSERT_TRUE(right.wrong_share);
    ASSERT_TRUE(slip.wrong_share);
    EXPECT_EQ(slip.distance, right.distance);
    EXPECT_NEAR(slip.wrong_share->least, right.wrong_share->least, 1e-9);
    EXPECT_NEAR(slip.wrong_share->most, right.wrong_share->most, 1e-9);
}

TEST(FightingOnset, IsAboutAStepForWideCodes) {
    // Rows of the table in unit/geometry/projection_test.cpp: near, far, z and the step at 16 bits.
    const double rows[][4] = {{20, 100, 60, 2.197e-3},
                              {1, 100, 10, 1.511e-3},
                              {1, 100, 100, 1.511e-1},
                              {0.1, 100, 10, 1.524e-2},
                              {0.01, 100, 10, 1.526e-1}};
    for (const auto& [near, far, z, step] : rows) {
        const DepthCoding coding{{.near = near, .far = far}, DepthMapping::standard, {16, false}, false};
        const FightingOnset onset = fighting_onset(coding, z);
        EXPECT_NEAR(onset.quantization, step, step * 0.02);
        EXPECT_GT(onset.arithmetic, 0.0);
        EXPECT_LT(onset.arithmetic, 0.03 * step);
        EXPECT_TRUE(onset.is_reachable);
    }
}

TEST(FightingOnset, IsArithmeticAtTheFarEndOfReversedFloats) {
    // At z = 99.99, a code is only about 1e-9 wide, but float32 arithmetic limits the onset to about 1e-5.
    for (const double near : {1.0, 0.1, 0.001}) {
        const DepthCoding coding{{.near = near, .far = 100.0}, DepthMapping::reversed, {32, true}, true};
        const FightingOnset onset = fighting_onset(coding, 99.99);
        EXPECT_LT(onset.quantization, 1e-8);
        EXPECT_GT(onset.arithmetic, 3e-6);
        EXPECT_LT(onset.arithmetic, 3e-5);
    }
}

TEST(FightingOnset, IsExactlyOneCodeTowardTheEye) {
    Random random(seed);
    for (int trial = 0; trial < 500; ++trial) {
        const double n = std::exp(random.number(std::log(1e-3), std::log(10.0)));
        const double f = n * std::exp(random.number(std::log(1.5), std::log(1e5)));
        const double z = n * std::pow(f / n, random.number(0.01, 1.0));
        const int bits = 4 + trial % 9;
        const double levels = std::exp2(bits) - 1.0;
        const auto depth = [n, f](double distance) { return f / (f - n) - f * n / ((f - n) * distance); };
        const DepthMapping mapping = trial % 2 == 0 ? DepthMapping::standard : DepthMapping::reversed;
        const FightingOnset onset = fighting_onset({{.near = n, .far = f}, mapping, {bits, false}, true}, z);
        SCOPED_TRACE("seed " + std::to_string(seed) + " trial " + std::to_string(trial));
        EXPECT_GE(z - onset.quantization, n * (1.0 - 1e-9));
        if (!onset.is_reachable) {
            EXPECT_LT((depth(z) - depth(n)) * levels, 1.0 + 1e-3);
        } else {
            EXPECT_NEAR((depth(z) - depth(z - onset.quantization)) * levels, 1.0, 1e-5);
        }
    }
}

TEST(FightingOnset, OutsideTheRangeEqualsTheNearestInside) {
    const DepthCoding coding{{.near = 1.0, .far = 100.0}, DepthMapping::standard, {24, false}, false};
    EXPECT_EQ(fighting_onset(coding, 500.0).gap(), fighting_onset(coding, 100.0).gap());
    EXPECT_EQ(fighting_onset(coding, -5.0).gap(), fighting_onset(coding, 1.0).gap());
    EXPECT_FALSE(fighting_onset(coding, 1.0).is_reachable) << "no surface is nearer than near";
}

TEST(FightingShare, OfTiesFallsWithTheGapAndWidensWithArithmetic) {
    const auto expect = [](const ShareInterval& share, double least, double most) {
        EXPECT_NEAR(share.least, least, 1e-12);
        EXPECT_NEAR(share.most, most, 1e-12);
    };
    expect(share_of_random_codes(0.0, 0.0, 0.0, true), 1.0, 1.0);
    expect(share_of_random_codes(0.25, 0.5, 0.0, true), 0.5, 0.75);
    expect(share_of_random_codes(0.25, 0.25, 0.125, true), 0.625, 0.875);
    expect(share_of_random_codes(1.0, 5.0, 0.0, true), 0.0, 0.0);
    expect(share_of_random_codes(0.25, 0.25, 0.125, false), 0.0, 0.0);
    expect(share_of_random_codes(0.25, 0.25, 0.5, false), 0.0, 0.25);
    expect(share_of_random_codes(0.5, 0.5, 3.0, true), 0.0, 1.0);
}

/// Compares the predicted fraction with a simulation of rounding. The farther depths fall on every phase within a code;
/// the nearer ones are `gap` in front of them and shifted by a random bias, which represents the arithmetic error.
TEST(FightingShare, BoundsAnyArithmetic) {
    Random random(seed);
    for (int trial = 0; trial < 300; ++trial) {
        const double gap = random.number(0.0, 1.5), most = random.number(0.0, 0.6), bias = random.number(-most, most);
        const ShareInterval said[2] = {share_of_random_codes(gap, gap, most, false),
                                       share_of_random_codes(gap, gap, most, true)};
        int reversed = 0, not_nearer = 0;
        constexpr int samples = 4000;
        for (int i = 0; i < samples; ++i) {
            const double farther = 0.6180339887 * i;  // every phase within a code
            const long code = std::lround(farther), nearer = std::lround(farther - gap + bias);
            reversed += nearer > code ? 1 : 0;
            not_nearer += nearer >= code ? 1 : 0;
        }
        for (const auto& [share, interval] : {std::pair{reversed, said[0]}, std::pair{not_nearer, said[1]}}) {
            const double part = static_cast<double>(share) / samples;
            EXPECT_GE(part, interval.least - 1e-2) << "seed " << seed << " trial " << trial;
            EXPECT_LE(part, interval.most + 1e-2) << "seed " << seed << " trial " << trial;
        }
    }
}

std::optional<ShareInterval> share_of(const Scene& scene, const Params& params) {
    return predict_pair(near_coplanar_pairs(scene).at(0), params, derive(params, scene, {}), Viewport{}.size_px)
        .wrong_share;
}

TEST(FightingPrediction, CountsTiesAsWrongIfTheWrongSurfaceWins) {
    // At 8 bits, seen from 20 units above, a gap of 0.1 is far below a code, and every pixel has the same code.
    const auto share_with = [](const Scene& scene, const char* setting) {
        return share_of(scene, params_with({"camera.position=[0,20,0]", "camera.pitch=-90", "camera.yaw=0",
                                            "depth.format=d8", "projection.far=100", setting}));
    };
    const Scene back_first = scene_of({square(0.0), square(0.1)}), front_first = scene_of({square(0.1), square(0.0)});
    EXPECT_EQ(share_with(back_first, "depth.func=less")->least, 1.0);
    EXPECT_EQ(share_with(back_first, "depth.func=lequal")->most, 0.0);
    EXPECT_EQ(share_with(front_first, "depth.func=less")->most, 0.0);
    EXPECT_EQ(share_with(front_first, "depth.func=lequal")->least, 1.0);
    for (const char* const undecided : {"depth.test=false", "depth.func=always", "depth.write=false"})
        EXPECT_FALSE(share_with(back_first, undecided)) << undecided;
}

/// Returns the fraction of wrong pixels of a poster on a wall, seen from 20 units above unless the settings change the
/// camera, at 8 bits by default. Returns −1 if there is no prediction, and −2 if its interval is wider than 0.2.
double share_of_decal(const std::vector<std::string>& settings, double height = 0.0) {
    std::vector<std::string> all{"camera.position=[0,20,0]", "camera.pitch=-90", "camera.yaw=0", "depth.format=d8",
                                 "projection.far=100"};
    all.insert(all.end(), settings.begin(), settings.end());
    SceneObject poster = square(height);
    poster.description.decal = true;
    const std::optional<ShareInterval> share = share_of(scene_of({square(0.0), poster}), params_with(all));
    if (!share) return -1.0;
    return share->most - share->least > 0.2 ? -2.0 : 0.5 * (share->least + share->most);
}

TEST(FightingPrediction, KnowsTheCuresOfDecals) {
    EXPECT_EQ(share_of_decal({}), 1.0);
    EXPECT_EQ(share_of_decal({"depth.decals=equal"}), -1.0);
    EXPECT_EQ(share_of_decal({"depth.decals=stencil"}), 0.0);
    EXPECT_EQ(share_of_decal({"depth.decals=stencil"}, 0.1), 0.0);
    EXPECT_EQ(share_of_decal({"depth.decals=stencil"}, -0.1), 1.0) << "painted over the wall in front";
}

TEST(FightingPrediction, CountsTheCodesOfAnOffset) {
    // At 8 bits, the sandbox itself applies the offset, so one unit is one code.
    const auto seen_aslant = [](const char* units) {  // the pixels span some twenty codes
        return share_of_decal({"camera.position=[0,1.2,3.2]", "camera.pitch=-20", units});
    };
    EXPECT_NEAR(seen_aslant("depth.offset.units=-0.25"), 0.75, 0.05);
    EXPECT_NEAR(seen_aslant("depth.offset.units=-0.75"), 0.25, 0.05);
    EXPECT_EQ(share_of_decal({"depth.offset.units=-0.25"}), -1.0) << "every pixel has the same code";
    EXPECT_EQ(share_of_decal({"depth.offset.units=-1"}), 0.0);
    EXPECT_EQ(share_of_decal({"depth.offset.units=1"}), 1.0);
    EXPECT_EQ(share_of_decal({"depth.offset.factor=-1"}), -1.0) << "depends on the slope";
    // GL does not define how many codes a unit spans, only that it spans at least one.
    EXPECT_EQ(share_of_decal({"depth.format=d16", "depth.offset.units=-0.5"}), -1.0);
    EXPECT_EQ(share_of_decal({"depth.format=d16", "depth.offset.units=-2"}), 0.0);
    EXPECT_EQ(share_of_decal({"depth.format=d16", "depth.offset.units=2"}), 1.0);
    EXPECT_EQ(share_of_decal({"depth.format=d16", "depth.offset.units=-2", "depth.mapping=reversed"}), 0.0);
    EXPECT_EQ(share_of_decal({"depth.format=d16", "depth.offset.units=-2", "depth.mapping=reversed",
                              "depth.reversed_offset=false"}),
              1.0);
    EXPECT_EQ(share_of_decal({"depth.format=d24", "depth.offset.units=-1"}), -1.0) << "rounding may undo it";
}

TEST(FightingPrediction, IsAbsentWithoutAFormula) {
    for (const std::vector<std::string>& settings :
         std::vector<std::vector<std::string>>{{"depth.format=d24"},
                                               {"depth.mapping=logarithmic", "depth.logarithm_per_vertex=true"},
                                               {"depth.mapping=reversed", "depth.reversed_clear=false"},
                                               {"depth.clear=false"},
                                               {"depth.write_while_clearing=false"},
                                               {"projection.far=15"}})
        EXPECT_EQ(share_of_decal(settings), -1.0) << settings.front();
    EXPECT_EQ(share_of_decal({"depth.mapping=logarithmic"}), 1.0);
    EXPECT_EQ(share_of_decal({"depth.mapping=reversed"}), 1.0);
}

TEST(FightingPrediction, MeasuresAlongTheViewRay) {
    const Scene scene = scene_of({square(0.0), square(0.1)});
    // The far corners (±1, 0, −1) are 10 below the eye and 21 ÷ √2 in front of it: there, the safe gap is widest.
    const Params params = params_with({"camera.position=[0,10,10]", "camera.pitch=-45", "camera.yaw=0"});
    const PairPrediction predicted =
        predict_pair(near_coplanar_pairs(scene).at(0), params, derive(params, scene, {}), Viewport{}.size_px);
    EXPECT_NEAR(predicted.distance, 10.0 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(predicted.slant, 10.0 / (21.0 / std::sqrt(2.0)), 1e-9);
}

}  // namespace
}  // namespace viewing
