// The report on the pixel under the pointer arrives without waiting for GL: each read goes into a buffer and is fetched
// once its fence is signaled. The report belongs to the pixel that it names and to the picture on screen. Here, a fake
// fence query makes GL seem slow.
#include <thread>

#include "gl/gl_test.h"
#include "state/presets.h"
#include "topics/depth/measured/depth_inspector.h"

namespace viewing {
namespace {

constexpr glm::ivec2 hovered_px(160, 90);

bool is_slow = false;  ///< if true, no fence is signaled
int waits = 0;         ///< how often the program has waited for GL
int copies = 0;        ///< number of reads into a buffer
PFNGLREADPIXELSPROC read_pixels = nullptr;
PFNGLCLIENTWAITSYNCPROC ask_fence = nullptr;
PFNGLFINISHPROC finish = nullptr;

void EPOXY_CALLSPEC counted_read(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                                 void* pixels) {
    GLint buffer = 0;
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer);
    ++(buffer != 0 ? copies : waits);
    read_pixels(x, y, width, height, format, type, pixels);
}
void EPOXY_CALLSPEC counted_finish() {
    ++waits;
    finish();
}
GLenum EPOXY_CALLSPEC slow_fence(GLsync sync, GLbitfield flags, GLuint64 timeout_ns) {
    EXPECT_EQ(timeout_ns, 0U) << "the window waits";
    return is_slow ? GL_TIMEOUT_EXPIRED : ask_fence(sync, flags, timeout_ns);
}

/// Runs with and without GL's own reads of depth and stencil. Without these reads, as in the browser, depth and stencil
/// must first be drawn into a color picture.
class Hovering : public testing::GlTest, public ::testing::WithParamInterface<bool> {
protected:
    void SetUp() override {
        GlTest::SetUp();
        gl::Capabilities capabilities = gl::Capabilities::of_current_context();
        capabilities.read_depth_stencil = GetParam();
        Result<Renderer> made = Renderer::make(capabilities);
        ASSERT_TRUE(made) << made.error();
        own_ = std::make_unique<Renderer>(*std::move(made));
        // Resolves each entry point before it is replaced.
        gl::read_pixels(gl::ColorTarget({1, 1}).framebuffer(), {1, 1});
        const GLsync sync = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        glClientWaitSync(sync, 0, 0);
        glDeleteSync(sync);
        read_pixels = std::exchange(epoxy_glReadPixels, counted_read);
        finish = std::exchange(epoxy_glFinish, counted_finish);
        ask_fence = std::exchange(epoxy_glClientWaitSync, slow_fence);
        is_slow = false;
        waits = copies = 0;
    }
    void TearDown() override {
        if (read_pixels) epoxy_glReadPixels = read_pixels;
        if (finish) epoxy_glFinish = finish;
        if (ask_fence) epoxy_glClientWaitSync = ask_fence;
        GlTest::TearDown();
    }

    std::optional<PixelReport> frame(glm::ivec2 pixel) {
        const Derived derived = derive(params, scene, Viewport{hovered_px});
        const auto told = inspector.follow(renderer(), plan(params, derived), scene, derived, hovered_px, pixel);
        EXPECT_TRUE(told) << told.error();
        return told ? *told : std::nullopt;
    }
    /// Runs frame after frame until no more are requested.
    std::optional<PixelReport> rest_at(glm::ivec2 pixel) {
        std::optional<PixelReport> told = frame(pixel);
        for (int i = 0; i < 5000 && inspector.is_following(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            told = frame(pixel);
        }
        EXPECT_FALSE(inspector.is_following());
        return told;
    }
    PixelReport at_once(glm::ivec2 pixel) {
        const Derived derived = derive(params, scene, Viewport{hovered_px});
        const int before = waits;
        PixelProbe probe;
        EXPECT_TRUE(probe.prepare(renderer(), plan(params, derived), scene, derived, hovered_px));
        PixelReport report = probe.at(pixel, scene);
        EXPECT_GT(waits, before) << "waiting reads are not counted";
        waits = before;
        return report;
    }

    Renderer& renderer() { return *own_; }

    Params params = load_state("depth-cells")->params;
    Scene scene = testing::scene_named("torus-and-boxes");
    DepthInspector inspector;

private:
    std::unique_ptr<Renderer> own_;
};
INSTANTIATE_TEST_SUITE_P(Reads, Hovering, ::testing::Bool(),
                         [](const auto& tested) { return tested.param ? "DepthItself" : "DepthAsBytes"; });

void expect_same(const PixelReport& told, const PixelReport& expected) {
    EXPECT_EQ(told.pixel, expected.pixel);
    EXPECT_EQ(told.color, expected.color);
    EXPECT_EQ(told.object, expected.object);
    EXPECT_EQ(told.stored, expected.stored);
    EXPECT_EQ(told.stencil, expected.stencil);
    EXPECT_EQ(told.front_facing, expected.front_facing);
    EXPECT_EQ(told.window_depth, expected.window_depth);
    EXPECT_EQ(told.eye_z, expected.eye_z);
    EXPECT_EQ(told.world, expected.world);
}

TEST_P(Hovering, ReportsTheSameAsABlockingReadWithoutWaiting) {
    for (const DepthFormat format : {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f}) {
        params.depth.format = format;
        inspector.forget();
        for (const glm::ivec2 pixel : {glm::ivec2(80, 45), glm::ivec2(0, 0), glm::ivec2(159, 89), glm::ivec2(60, 70)}) {
            SCOPED_TRACE("format " + std::to_string(static_cast<int>(format)) + ", x " + std::to_string(pixel.x));
            const std::optional<PixelReport> told = rest_at(pixel);
            EXPECT_EQ(waits, 0);
            ASSERT_TRUE(told);
            expect_same(*told, at_once(pixel));
        }
    }
}

TEST_P(Hovering, OneReadIsPendingAndTheNewestPlaceWins) {
    ASSERT_TRUE(rest_at({80, 45}));
    is_slow = true;
    copies = 0;
    for (int x = 0; x < 20; ++x) {
        const std::optional<PixelReport> told = frame({x, 3});
        ASSERT_TRUE(told) << "the previous report stays";
        EXPECT_EQ(told->pixel, glm::ivec2(80, 45));
        EXPECT_TRUE(inspector.is_following());
    }
    EXPECT_LE(copies, 4) << "one pixel takes four reads";
    is_slow = false;
    const std::optional<PixelReport> told = rest_at({19, 3});
    ASSERT_TRUE(told);
    expect_same(*told, at_once({19, 3}));
    EXPECT_EQ(copies, 8) << "only the first and the last place are read";
}

/// Lower views that describe the pixel keep showing the previous report on the same picture until the next one arrives.
TEST_P(Hovering, LowerViewsDoNotWaitEither) {
    const auto tell = [this](glm::ivec2 pixel) {
        const Derived derived = derive(params, scene, Viewport{hovered_px});
        EXPECT_TRUE(inspector.update(renderer(), plan(params, derived), scene, 1, derived, hovered_px,
                                     {.pixel = pixel, .fragments = true}, false));
        EXPECT_TRUE(inspector.data().pixel);
        return *inspector.data().pixel;
    };
    expect_same(tell({80, 45}), at_once({80, 45}));
    waits = copies = 0;
    is_slow = true;
    const std::size_t surfaces = inspector.data().fragments.size();
    for (int x = 0; x < 5; ++x) {
        EXPECT_EQ(tell({x, 3}).pixel, glm::ivec2(80, 45));
        EXPECT_EQ(inspector.data().fragments.size(), surfaces);
        EXPECT_TRUE(inspector.is_following());
    }
    is_slow = false;
    for (int i = 0; i < 5000 && tell({60, 70}).pixel != glm::ivec2(60, 70); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(waits, 0);
    EXPECT_FALSE(inspector.is_following());
    expect_same(tell({60, 70}), at_once({60, 70}));

    // A changed picture is read immediately: nothing older is reported for it.
    params.camera.position.z += 1.0;
    inspector.forget();
    expect_same(tell({60, 70}), at_once({60, 70}));
}

TEST_P(Hovering, ReadsOfAnOlderPictureAreDropped) {
    const glm::ivec2 pixel(80, 45);
    ASSERT_TRUE(rest_at(pixel));
    is_slow = true;
    frame({81, 45});  // stays pending
    params.camera.position.z += 1.0;
    inspector.forget();
    is_slow = false;
    EXPECT_FALSE(frame(pixel));
    const std::optional<PixelReport> told = rest_at(pixel);
    ASSERT_TRUE(told);
    expect_same(*told, at_once(pixel));
    EXPECT_EQ(waits, 0);
}

/// During motion, nothing is drawn or read for the report.
TEST_P(Hovering, APictureThatChangesEveryFrameIsNotRead) {
    for (int i = 0; i < 5; ++i) {
        params.camera.position.z += 0.1;
        inspector.forget();
        EXPECT_FALSE(frame({80, 45}));
        EXPECT_TRUE(inspector.is_following());
    }
    EXPECT_EQ(copies + waits, 0);
    EXPECT_TRUE(rest_at({80, 45}));
}

}  // namespace
}  // namespace viewing
