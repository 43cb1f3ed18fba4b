// Compares each preset that breaks the picture with the same preset after its own fix: the fix must have a visible
// effect. The reference pictures belong to the suite beside this file, which tests/golden/check runs. Read
// window_test.cpp next.
#include "app/picture.h"
#include "gl/gl_test.h"
#include "image/compare.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

class FixedPreset : public testing::GlTest {
protected:
    static Image picture_of(const LoadedState& state) {
        const Result<Scene> scene = load_scene(state.params.scene, state.base, state.params.coplanar);
        EXPECT_TRUE(scene) << scene.error();
        Result<Image> image = draw_picture(renderer(), state, *scene, {PictureView::camera, {480, 270}, 0});
        EXPECT_TRUE(image) << image.error();
        return *std::move(image);
    }
};

TEST_F(FixedPreset, DiffersFromTheBrokenPreset) {
    int fixed = 0;
    for (const NamedFile& preset : presets()) {
        if (preset.fixed_by.empty()) continue;
        Result<LoadedState> state = load_state(preset.name);
        ASSERT_TRUE(state) << state.error();
        const Image broken = picture_of(*state);
        const Result<Params> params = apply_settings(state->params, std::vector<std::string>{preset.fixed_by});
        ASSERT_TRUE(params) << params.error();
        state->params = *params;
        EXPECT_GT(compare_images(broken, picture_of(*state), {3, 0.0}).beyond, 40) << preset.name;
        ++fixed;
    }
    EXPECT_GT(fixed, 20);
}

}  // namespace
}  // namespace viewing
