// States and their scenes for tests that draw pictures.
#pragma once

#include "gl/gl_test.h"
#include "state/file/state_json.h"
#include "state/presets.h"
#include "state/scene.h"

namespace viewing::testing {

class PictureTest : public GlTest {
protected:
    static LoadedState state_with(const std::vector<std::string>& settings, const std::string& preset = "") {
        Result<LoadedState> state = load_state(preset);
        EXPECT_TRUE(state) << state.error();
        const Result<Params> params = apply_settings(state->params, settings);
        EXPECT_TRUE(params) << params.error();
        state->params = *params;
        return *state;
    }
    static Scene scene_of(const LoadedState& state) {
        const Result<Scene> scene = load_scene(state.params.scene, state.base, state.params.coplanar);
        EXPECT_TRUE(scene) << scene.error();
        return *scene;
    }
};

}  // namespace viewing::testing
