// The thumbnails beside the list of presets: each equals a snapshot of its preset and is made only once. Unreadable
// presets have none.
#include "app/preset_pictures.h"

#include <chrono>
#include <thread>

#include "app/picture.h"
#include "gl/gl_test.h"
#include "gl/objects.h"

namespace viewing {
namespace {

class PresetPicturesTest : public testing::GlTest {
protected:
    /// Requests the picture repeatedly, as the window does in each frame, until no work is left; returns it.
    static PresetPicture finished(PresetPictures& pictures, const std::string& name) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
        do {
            const PresetPicture picture = pictures.of(name, false);
            if (!pictures.is_busy()) return picture;
            std::this_thread::yield();
        } while (std::chrono::steady_clock::now() < end);
        ADD_FAILURE() << name << " is not finished";
        return {};
    }

    static Image image_of(const PresetPicture& picture) {
        const gl::Framebuffer framebuffer = gl::make_framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        const auto texture = static_cast<GLuint>(reinterpret_cast<std::intptr_t>(picture.texture));
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        return {384, 216, gl::read_pixels(framebuffer.name(), {384, 216})};
    }
};

TEST_F(PresetPicturesTest, EqualASnapshotOfThePreset) {
    PresetPictures pictures(renderer());
    EXPECT_EQ(pictures.of("", false).texture, nullptr);
    EXPECT_EQ(pictures.of("walk", false).texture, nullptr) << "the call does not wait for it";
    for (const char* name : {"walk", "painter-cycle", "newell-cycle", "depth-few-bits"}) {
        SCOPED_TRACE(name);
        const PresetPicture picture = finished(pictures, name);
        ASSERT_NE(picture.texture, nullptr);
        EXPECT_EQ(picture.name, name);
        const LoadedState state = *load_state(name);
        const Scene scene = *load_scene(state.params.scene, state.base, state.params.coplanar);
        EXPECT_EQ(image_of(picture), *draw_picture(renderer(), state, scene, {PictureView::camera, {384, 216}, {}}));
    }
    const ImTextureID kept = pictures.of("walk", false).texture;
    EXPECT_NE(kept, nullptr);
    EXPECT_FALSE(pictures.is_busy()) << "the picture is kept";
}

/// As in a picture of the window: nothing is drawn again later.
TEST_F(PresetPicturesTest, AreThereAtOnceIfTheCallWaits) {
    PresetPictures pictures(renderer());
    EXPECT_EQ(pictures.of("walk", false).texture, nullptr);
    const PresetPicture first = pictures.of("newell-cycle", true), other = pictures.of("walk", true);
    ASSERT_NE(first.texture, nullptr);
    EXPECT_NE(image_of(first), image_of(other));
    EXPECT_EQ(pictures.of("no-such-preset", true).texture, nullptr);
    EXPECT_FALSE(pictures.is_busy());
}

TEST_F(PresetPicturesTest, UnreadablePresetsHaveNone) {
    PresetPictures pictures(renderer());
    EXPECT_EQ(finished(pictures, "no-such-preset").texture, nullptr);
    EXPECT_EQ(finished(pictures, "no-such-preset").texture, nullptr);
    EXPECT_NE(finished(pictures, "walk").texture, nullptr);
}

}  // namespace
}  // namespace viewing
