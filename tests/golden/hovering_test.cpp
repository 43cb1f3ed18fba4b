// The status bar while the pointer is over the camera's picture. On screen, nothing waits for GL, but the bar ends up
// with the text that an offscreen picture shows immediately. The test needs no reference pictures.
#include <chrono>
#include <thread>

#include "app/studio.h"
#include "gl/gl_test.h"

namespace viewing {
namespace {

constexpr glm::ivec2 window_px(1280, 720);

class HoveringTest : public testing::GlTest {
protected:
    static std::unique_ptr<Studio> studio_over(ImVec2 pointer) {
        const Result<LoadedState> state = load_state("");
        const Result<Scene> scene = load_scene(state->params.scene, state->base, state->params.coplanar);
        auto made = std::make_unique<Studio>(renderer(), Session(*state, *scene));
        ImGui::GetIO().MousePos = pointer;
        return made;
    }
    /// Runs frames until none is requested; returns their number.
    static int rest(Studio& studio, bool is_on_screen) {
        int frames = 0;
        do {
            studio.frame({.size_px = window_px, .device_scale = 1.0, .shows_time = is_on_screen, .input = {}});
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } while (++frames < 3 || (studio.redraw_in_s() >= 0.0 && studio.redraw_in_s() < 0.1 && frames < 5000));
        return frames;
    }
    /// Returns the pixels of the status bar without the frame time.
    static std::vector<std::uint8_t> status_bar(Studio& studio) {
        constexpr int height_px = 20, first_px = 84;
        const Image window = studio.read();
        std::vector<std::uint8_t> bytes;
        for (int y = window_px.y - height_px; y < window_px.y; ++y)
            bytes.insert(bytes.end(), window.row(y) + 4 * first_px, window.row(y) + 4 * window_px.x);
        return bytes;
    }
};

TEST_F(HoveringTest, ReportsTheSamePixelOnScreenAndOffscreen) {
    std::vector<std::vector<std::uint8_t>> told;
    for (const ImVec2 pointer : {ImVec2{640.0F, 250.0F}, ImVec2{560.0F, 330.0F}, ImVec2{-1e6F, -1e6F}}) {
        std::unique_ptr<Studio> studio = studio_over(pointer);
        rest(*studio, false);
        const std::vector<std::uint8_t> at_once = status_bar(*studio);
        studio.reset();
        studio = studio_over(pointer);
        EXPECT_LT(rest(*studio, true), 5000) << "the window does not come to rest";
        EXPECT_EQ(status_bar(*studio), at_once);
        told.push_back(at_once);
    }
    EXPECT_NE(told[0], told[1]);
    EXPECT_NE(told[1], told[2]) << "no pixel is reported";
}

}  // namespace
}  // namespace viewing
