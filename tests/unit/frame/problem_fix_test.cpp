// The settings that problems offer as fixes. Applied to the presets that break something, each fix removes its problem.
#include <algorithm>

#include "state/presets.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

using testing::problems_of;
using testing::says;

const Viewport viewport{{480, 270}};

TEST(ProblemFix, RemovesTheProblemOfEachPreset) {
    const std::vector<NamedFile> all = presets();
    ASSERT_GT(all.size(), 90U);
    int fixed = 0;
    for (const NamedFile& preset : all) {
        const Result<LoadedState> state = load_state(preset.name);
        ASSERT_TRUE(state) << state.error();
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        for (const Problem& problem : problems_of(state->params, *scene, viewport)) {
            if (problem.fixed_by.empty()) continue;
            SCOPED_TRACE(preset.name + ": " + say(problem.sentence));
            EXPECT_NE(problem.kind, ProblemKind::worth_knowing);
            const Result<Params> right =
                apply_settings(state->params, std::vector<std::string>{std::string(problem.fixed_by)});
            ASSERT_TRUE(right) << right.error();
            EXPECT_FALSE(std::ranges::any_of(problems_of(*right, *scene, viewport), [&](const Problem& left) {
                return left.sentence == problem.sentence;
            })) << problem.fixed_by;
            ++fixed;
        }
    }
    EXPECT_GT(fixed, 30);
}

TEST(ProblemFix, MatchesTheFixOfThePreset) {
    int agreeing = 0;
    for (const NamedFile& preset : presets()) {
        if (preset.fixed_by.empty()) continue;
        SCOPED_TRACE(preset.name);
        const Result<LoadedState> state = load_state(preset.name);
        ASSERT_TRUE(state) << state.error();
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        const Result<Params> right = apply_settings(state->params, std::vector<std::string>{preset.fixed_by});
        ASSERT_TRUE(right) << right.error();
        const std::vector<Problem> left = problems_of(*right, *scene, viewport);
        int gone = 0;
        std::vector<std::string> offered;
        for (const Problem& problem : problems_of(state->params, *scene, viewport)) {
            if (problem.kind != ProblemKind::wrong || says(left, problem.group, say(problem.sentence))) continue;
            ++gone;
            if (!problem.fixed_by.empty()) offered.push_back(problem.fixed_by);
        }
        EXPECT_GT(gone, 0) << "no problem explains the broken picture";
        if (offered.empty()) continue;
        EXPECT_EQ(std::count(offered.begin(), offered.end(), preset.fixed_by), 1)
            << preset.fixed_by << " is not offered, but " << offered.front();
        ++agreeing;
    }
    EXPECT_GT(agreeing, 20);
}

TEST(ProblemFix, RestoresTheDefaultOfAField) {
    EXPECT_EQ(default_setting("depth.func"), "depth.func=less");
    EXPECT_EQ(default_setting("shadow.stencil_once"), "shadow.stencil_once=true");
    EXPECT_EQ(default_setting("view.pass"), "view.pass=-1");
}

}  // namespace
}  // namespace viewing
