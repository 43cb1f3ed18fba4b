// The settings that problems name to mend them: applied to the presets that break something, each takes its problem
// away.
#include <algorithm>

#include "state/presets.h"
#include "unit/frame/frame_test.h"

namespace viewing {
namespace {

using testing::problems_of;

const Viewport viewport{{480, 270}};

TEST(Mending, TakesTheProblemOfEachPresetAway) {
    const std::vector<NamedFile> all = presets();
    ASSERT_GT(all.size(), 90U);
    int mended = 0;
    for (const NamedFile& preset : all) {
        const Result<LoadedState> state = load_state(preset.name);
        ASSERT_TRUE(state) << state.error();
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        ASSERT_TRUE(scene) << scene.error();
        for (const Problem& problem : problems_of(state->params, *scene, viewport)) {
            if (problem.mended_by.empty()) continue;
            SCOPED_TRACE(preset.name + ": " + problem.sentence);
            EXPECT_TRUE(problem.breaks_picture);
            const Result<Params> right =
                apply_settings(state->params, std::vector<std::string>{std::string(problem.mended_by)});
            ASSERT_TRUE(right) << right.error();
            EXPECT_FALSE(std::ranges::any_of(problems_of(*right, *scene, viewport), [&](const Problem& left) {
                return left.sentence == problem.sentence;
            })) << problem.mended_by;
            ++mended;
        }
    }
    EXPECT_GT(mended, 30);
}

}  // namespace
}  // namespace viewing
