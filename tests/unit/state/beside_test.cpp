// Settings of the second picture: the fields that they may change, their errors, and the states that they can show.
#include "state/file/beside.h"

#include <gtest/gtest.h>

#include "state/file/state_json.h"
#include "trials.h"
#include "unit/state/random_params.h"

namespace viewing {
namespace {

Result<Params> with(const std::string& set) {
    const std::string settings[] = {"view.beside.shows=settings", "view.beside.set=" + set};
    return apply_settings({}, settings);
}

TEST(BesideSettings, ChangeTheSecondPictureAlone) {
    const Result<Params> params =
        with(R"({"depth.test": false, "camera.look_at": {"eye": [0, 0, 9], "center": [0, 0, 0]}})");
    ASSERT_TRUE(params) << params.error();
    const Params other = beside_params(*params);
    EXPECT_TRUE(params->depth.test);
    EXPECT_FALSE(other.depth.test);
    EXPECT_EQ(other.camera.position, glm::dvec3(0, 0, 9));
    EXPECT_EQ(other.lights, params->lights);
    Params off = *params;
    off.view.beside.shows = Beside::nothing;
    EXPECT_EQ(beside_params(off), off);
}

TEST(BesideSettings, AreRefusedWithTheirPath) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"projection.nea": 1})", "projection.nea: no such field; did you mean projection.near?"},
        {R"({"depth.test": 3})", "depth.test: must be true or false, got the number 3"},
        {R"({"scene": "room"})", "scene: is the same in both pictures"},
        {R"({"ui.theme": "dark"})", "ui.theme: is the same in both pictures"},
        {R"({"view.beside.share": 0.1})", "view.beside.share: is the same in both pictures"},
        {R"({"camera": {"yaw": 3}})", "camera: no such field"},
        {R"({"light.position[0]": 3})", "light.position[0]: no such field"},
        {R"(["depth.test=false"])", "must be an object of paths and values"}};
    for (const auto& [set, expected] : cases) {
        const Result<Params> params = with(set);
        ASSERT_FALSE(params) << set;
        EXPECT_NE(params.error().find(expected), std::string::npos) << params.error();
        EXPECT_NE(params.error().find("view.beside.set"), std::string::npos) << params.error();
    }
}

TEST(BesideSettings, FitTheStateThatControlsMayReach) {
    Params params = *with(R"({"projection.near": 50, "view.light": 3})");
    params.projection.far = 20.0;
    const Params other = beside_params(params);
    EXPECT_EQ(other.projection.near, 50.0);
    EXPECT_GT(other.projection.far, 50.0);
    EXPECT_EQ(other.view.light, 1);
}

TEST(BesideSettings, ShowAnyOtherStateOfTheScene) {
    constexpr unsigned seed = 3507;
    RecordProperty("seed", seed);
    testing::RandomParams random(seed);
    for (int trial = 0; trial < testing::trials(is_sanitized ? 50 : 200); ++trial) {
        Params params = random.make(), other = random.make();
        clamp_to_ranges(params);
        clamp_to_ranges(other);
        // The fields that both pictures share, copied from the documentation.
        other.scene = params.scene;
        other.ui = params.ui;
        other.view.layout = params.view.layout;
        other.view.lower_left = params.view.lower_left;
        other.view.lower_right = params.view.lower_right;
        ASSERT_TRUE(show_beside(params, other));
        other.view.beside = params.view.beside;
        EXPECT_EQ(beside_params(params), other) << "seed " << seed << ", trial " << trial;
        const Result<Params> read = parse_state(write_state(params), "state.json");
        ASSERT_TRUE(read) << read.error();
        EXPECT_EQ(*read, params);
    }
}

TEST(BesideSettings, WithoutADifferenceNothingChanges) {
    Params params, other;
    other.ui.theme = Theme::projector;
    other.view.lower_left = Topic::depth;
    const Params before = params;
    EXPECT_FALSE(show_beside(params, other));
    EXPECT_EQ(params, before);
}

}  // namespace
}  // namespace viewing
