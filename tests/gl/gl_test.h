// Shared by all tests that draw: a software EGL context, a renderer that uses it, and the rule that any GL error fails
// the test. Next, read ray_caster.h, which computes the expected pictures.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "frame/plan/plan.h"
#include "gl/debug.h"
#include "gl/egl_context.h"
#include "render/renderer.h"
#include "trials.h"
#include "unit/frame/frame_test.h"

namespace viewing::testing {

using Rgb = glm::ivec3;

inline Rgb rgb_at(const Image& image, glm::ivec2 pixel) {
    const std::uint8_t* at = image.pixel(pixel.x, pixel.y);
    return {at[0], at[1], at[2]};
}

inline int worst_channel(const Rgb& a, const Rgb& b) {
    const glm::ivec3 difference = glm::abs(a - b);
    return std::max({difference.r, difference.g, difference.b});
}

/// Returns the number of pixels that differ by more than `worst` in some channel.
inline int pixels_beyond(const Image& a, const Image& b, int worst) {
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) count += worst_channel(rgb_at(a, {x, y}), rgb_at(b, {x, y})) > worst ? 1 : 0;
    return count;
}

/// Returns the pixel that shows a world point, counted from the top left.
inline glm::ivec2 pixel_of(const glm::dvec3& point, const Derived& derived, glm::ivec2 size_px) {
    const glm::dvec4 clip = derived.clip_from_world * glm::dvec4(point, 1.0);
    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
    return glm::ivec2(glm::floor((ndc * glm::dvec2(0.5, -0.5) + 0.5) * glm::dvec2(size_px)));
}

/// Returns a setting such as "depth.format=d24", in the form that params_with() takes.
inline std::string setting(const std::string& path, std::string_view value) {
    return path + "=" + std::string(value);
}

class GlTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        Result<gl::EglContext> context = gl::EglContext::make();
        ASSERT_TRUE(context) << context.error();
        shared_ = std::make_unique<Shared>(*std::move(context));
        Result<Renderer> renderer = Renderer::make();
        ASSERT_TRUE(renderer) << renderer.error();
        shared_->renderer = std::make_unique<Renderer>(*std::move(renderer));
    }
    static void TearDownTestSuite() { shared_.reset(); }

    void SetUp() override { ASSERT_TRUE(shared_ && shared_->renderer) << "no GL context"; }

    void TearDown() override {
        if (!shared_) return;
        const std::vector<std::string>& errors = shared_->log.errors();
        for (; shared_->seen < errors.size(); ++shared_->seen) ADD_FAILURE() << "GL: " << errors[shared_->seen];
    }

    /// Ignores the GL errors so far, for tests that provoke errors.
    static void forget_errors() { shared_->seen = shared_->log.errors().size(); }

    static Renderer& renderer() { return *shared_->renderer; }

    static Derived derive_for(const Params& params, const Scene& scene, glm::ivec2 size_px) {
        return derive(params, scene, {size_px, renderer().capabilities().clip_control});
    }

    static std::vector<Problem> problems_of(const Params& params, const Scene& scene, glm::ivec2 size_px) {
        return testing::problems_of(params, scene, {size_px, renderer().capabilities().clip_control});
    }

    static Image draw(const FramePlan& frame, const Scene& scene, glm::ivec2 size_px, Renderer& with, View& view) {
        const Status drawn = with.draw(frame, scene, size_px, view);
        EXPECT_TRUE(drawn) << drawn.error();
        return with.read(view);
    }
    static Image draw(const FramePlan& frame, const Scene& scene, glm::ivec2 size_px) {
        View view;
        return draw(frame, scene, size_px, renderer(), view);
    }
    /// Draws the camera's picture of a state.
    static Image draw(const Params& params, const Scene& scene, glm::ivec2 size_px) {
        return draw(plan(params, derive_for(params, scene, size_px)), scene, size_px);
    }

private:
    struct Shared {
        explicit Shared(gl::EglContext made) : context(std::move(made)) {}
        gl::EglContext context;
        gl::DebugLog log;
        std::unique_ptr<Renderer> renderer;
        std::size_t seen = 0;
    };
    inline static std::unique_ptr<Shared> shared_;
};

/// Loads a scene from assets/scenes.
inline Scene scene_named(const std::string& name) {
    const Result<Scene> scene = load_scene(name, "");
    EXPECT_TRUE(scene) << scene.error();
    return *scene;
}

}  // namespace viewing::testing
