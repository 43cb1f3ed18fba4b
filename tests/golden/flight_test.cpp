// A flight's pictures equal those on screen: the test flies with seeded random input, keeps each camera picture, and
// checks that the written file draws the same bytes.
#include <random>

#include "app/picture.h"
#include "app/studio.h"
#include "gl/gl_test.h"
#include "state/file/state_json.h"

namespace viewing {
namespace {

class FlightPictures : public testing::GlTest {
protected:
    struct Recorded {
        Flight flight;
        std::vector<Image> pictures;  ///< one for each frame drawn during the recording
        std::vector<double> times_s;
    };

    /// Holds keys at random, moves the light and the near plane, and toggles a few switches.
    static Recorded fly(const std::string& preset, unsigned seed, glm::ivec2 size_px) {
        std::mt19937 random(seed);
        const auto pick = [&random](unsigned count) { return static_cast<unsigned>(random() % count); };
        Result<LoadedState> state = load_state(preset);
        EXPECT_TRUE(state) << state.error();
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        EXPECT_TRUE(scene) << scene.error();
        Studio studio(renderer(), Session(*state, *scene));
        FlightRecorder& recorder = studio.workbench.recorder;
        FrameInput input;
        for (int frame = 0; frame < 5; ++frame) studio.frame({.size_px = size_px, .shows_time = true, .input = input});
        recorder.begin();
        Recorded recorded;
        for (int frame = 0; frame < testing::trials(30); ++frame) {
            input.dt_s = 0.01 + 0.001 * pick(30);
            if (pick(4) == 0) {
                static constexpr Key keys[] = {Key::w, Key::s, Key::a, Key::d, Key::r, Key::q, Key::left, Key::up};
                const auto key = static_cast<std::size_t>(keys[pick(std::size(keys))]);
                input.down[key] = !input.down[key];
            }
            Params& params = studio.session.params;
            if (pick(5) == 0) params.lights[0].position.x += 0.01 * pick(100);
            if (pick(9) == 0) params.projection.near = 0.1 + 0.01 * pick(40);
            if (pick(12) == 0) params.shadow.opacity = 0.01 * pick(100);
            if (pick(15) == 0) params.view.shows = pick(2) ? Shows::facing : Shows::color;
            if (pick(20) == 0) params.animation.light_orbit = !params.animation.light_orbit;
            studio.frame({.size_px = size_px, .shows_time = true, .input = input});
            EXPECT_FALSE(studio.session.message.is_error) << studio.session.message.text;
            recorded.pictures.push_back(renderer().read(studio.camera_view()));
            recorded.times_s.push_back(recorder.seconds());
        }
        const std::optional<Flight> flight = recorder.end();
        EXPECT_TRUE(flight);
        if (!flight) return recorded;
        const Result<StateDocument> read = parse_state_document(write_flight(*flight), "flight");
        EXPECT_TRUE(read && read->flight);
        if (read && read->flight) recorded.flight = *read->flight;
        EXPECT_EQ(recorded.flight, *flight);
        return recorded;
    }
};

TEST_F(FlightPictures, AreByteEqualToTheWindowsPictures) {
    struct Case {
        const char* preset;
        unsigned seed;
    };
    for (const Case& one : {Case{"opening", 1}, Case{"room", 2}, Case{"walkthrough", 3}, Case{"fighting-jiggle", 4}}) {
        SCOPED_TRACE(one.preset);
        const Recorded recorded = fly(one.preset, one.seed, {800, 600});
        ASSERT_GT(recorded.flight.frames.size(), 20U);
        FlightWalk walk(std::make_shared<const Flight>(recorded.flight));
        Params last;
        std::optional<Scene> scene;
        for (std::size_t i = 0; i < recorded.pictures.size(); ++i) {
            const Image& shown = recorded.pictures[i];
            // The file stores times in whole microseconds.
            const Result<Params> params = walk.at(recorded.flight.picture_at(recorded.times_s[i] + 1e-6));
            ASSERT_TRUE(params) << params.error();
            LoadedState state;
            state.params = *params;
            if (!scene || !(last.scene == params->scene && last.coplanar == params->coplanar)) {
                Result<Scene> loaded = load_scene(params->scene, {}, params->coplanar);
                ASSERT_TRUE(loaded) << loaded.error();
                scene = *std::move(loaded);
            }
            last = *params;
            const Result<Image> drawn =
                draw_picture(renderer(), state, *scene, {PictureView::camera, {shown.width, shown.height}, {}});
            ASSERT_TRUE(drawn) << drawn.error();
            ASSERT_EQ(*drawn, shown) << "frame " << i;
        }
    }
}

}  // namespace
}  // namespace viewing
