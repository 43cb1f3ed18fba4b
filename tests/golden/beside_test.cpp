// The second picture, drawn with other settings, is identical, pixel by pixel, to the picture of a state with those
// settings. This holds both for GL's depth buffer and for hidden-surface methods in software.
#include "app/picture.h"
#include "gl/gl_test.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

class BesideTest : public testing::GlTest {
protected:
    Image picture(const LoadedState& state, glm::ivec2 size_px, bool labels) {
        const Scene scene = *load_scene(state.params.scene, state.base, state.params.coplanar);
        PictureRequest request{PictureView::camera, size_px, {}};
        request.labels = labels;
        const Result<Image> drawn = draw_picture(renderer(), state, scene, request);
        EXPECT_TRUE(drawn) << drawn.error();
        return drawn ? *drawn : Image{};
    }
};

TEST_F(BesideTest, EqualsThePictureOfTheStateWithTheseSettings) {
    struct Case {
        const char *preset, *set;
    };
    for (const Case& one : {Case{"opening", R"({"projection.near": 7, "light.position": [1, 6, 1, 1]})"},
                            Case{"opening", R"({"camera.look_at": {"eye": [1, 2, 7], "center": [0, 1, 0]}})"},
                            Case{"depth-fighting", R"({"depth.format": "d32f", "depth.mapping": "reversed"})"},
                            Case{"mirror-off-the-edge", R"({"reflection.stencil": true, "view.shows": "stencil"})"},
                            Case{"painter-cycle", R"({"visibility.method": "newell"})"},
                            Case{"painter-cycle", R"({"visibility.method": "depth_buffer"})"}}) {
        SCOPED_TRACE(std::string(one.preset) + " " + one.set);
        LoadedState state = *load_state(one.preset);
        const std::string both[] = {"view.beside.shows=settings", "view.beside.layout=halves",
                                    std::string("view.beside.set=") + one.set, "view.samples=0", "view.pin=null"};
        state.params = *apply_settings(state.params, both);
        state.params.follow.reset();
        const Image whole = picture(state, {960, 480}, true);
        LoadedState other = state;
        other.params.view.beside = {};
        std::vector<std::string> settings = state.params.view.beside.set.all;
        other.params = *apply_settings(other.params, settings);
        // Halves are equally large; the gap between them is at least two pixels wide.
        int best = -1;
        for (int width = 470; width <= 479 && best != 0; ++width) {
            const Image alone = picture(other, {width, whole.height}, false);
            int differing = 0;
            for (int y = 0; y < whole.height; ++y)
                for (int x = 0; x < width; ++x)
                    if (!std::equal(alone.row(y) + 4 * x, alone.row(y) + 4 * x + 3,
                                    whole.row(y) + 4 * (whole.width - width + x)))
                        ++differing;
            best = best < 0 ? differing : std::min(best, differing);
        }
        EXPECT_EQ(best, 0) << "pixels that differ";
    }
}

}  // namespace
}  // namespace viewing
