// Side effects and dependencies of a frame: every kind of frame leaves GL in its default state, the same state gives
// the same bytes, and no frame depends on capabilities that a driver may lack.
#include <algorithm>

#include "gl_test.h"
#include "render/probe.h"
#include "unit/geometry/random.h"
#include "unit/state/random_params.h"

namespace viewing {
namespace {

using testing::params_with;
using testing::pixels_beyond;
using testing::scene_named;

constexpr glm::ivec2 state_px(160, 120);

class FrameState : public testing::GlTest {};

void expect_integer(GLenum name, GLint expected, const char* what) {
    GLint found[4] = {-1, -1, -1, -1};
    glGetIntegerv(name, found);
    EXPECT_EQ(found[0], expected) << what;
}
#define EXPECT_STATE(name, expected) expect_integer(name, static_cast<GLint>(expected), #name)

void expect_default_state(bool has_clip_control) {
    for (const GLenum capability :
         {GL_DEPTH_TEST, GL_CULL_FACE, GL_STENCIL_TEST, GL_BLEND, GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE,
          GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE1, GL_SCISSOR_TEST, GL_DEPTH_CLAMP, GL_COLOR_LOGIC_OP,
          GL_RASTERIZER_DISCARD, GL_PRIMITIVE_RESTART, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_FRAMEBUFFER_SRGB})
        EXPECT_FALSE(glIsEnabled(capability)) << "capability " << capability;
    EXPECT_STATE(GL_DEPTH_FUNC, GL_LESS);
    EXPECT_STATE(GL_DEPTH_WRITEMASK, GL_TRUE);
    EXPECT_STATE(GL_DEPTH_CLEAR_VALUE, 2147483647);  // a depth of 1, as the largest integer
    EXPECT_STATE(GL_STENCIL_CLEAR_VALUE, 0);
    EXPECT_STATE(GL_CULL_FACE_MODE, GL_BACK);
    EXPECT_STATE(GL_FRONT_FACE, GL_CCW);
    EXPECT_STATE(GL_POLYGON_MODE, GL_FILL);
    for (const auto& [func, reference, mask, fail, depth_fail, pass, write] :
         {std::tuple(GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_FAIL,
                     GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS, GL_STENCIL_WRITEMASK),
          std::tuple(GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK, GL_STENCIL_BACK_FAIL,
                     GL_STENCIL_BACK_PASS_DEPTH_FAIL, GL_STENCIL_BACK_PASS_DEPTH_PASS, GL_STENCIL_BACK_WRITEMASK)}) {
        EXPECT_STATE(func, GL_ALWAYS);
        EXPECT_STATE(reference, 0);
        for (const GLenum bits : {mask, write}) {
            GLint found = 0;
            glGetIntegerv(bits, &found);
            EXPECT_EQ(found & 0xFF, 0xFF);
        }
        EXPECT_STATE(fail, GL_KEEP);
        EXPECT_STATE(depth_fail, GL_KEEP);
        EXPECT_STATE(pass, GL_KEEP);
    }
    EXPECT_STATE(GL_BLEND_SRC_RGB, GL_ONE);
    EXPECT_STATE(GL_BLEND_SRC_ALPHA, GL_ONE);
    EXPECT_STATE(GL_BLEND_DST_RGB, GL_ZERO);
    EXPECT_STATE(GL_BLEND_DST_ALPHA, GL_ZERO);
    EXPECT_STATE(GL_BLEND_EQUATION_RGB, GL_FUNC_ADD);
    EXPECT_STATE(GL_CURRENT_PROGRAM, 0);
    EXPECT_STATE(GL_VERTEX_ARRAY_BINDING, 0);
    EXPECT_STATE(GL_ARRAY_BUFFER_BINDING, 0);
    EXPECT_STATE(GL_ACTIVE_TEXTURE, GL_TEXTURE0);
    GLboolean writes[4] = {};
    glGetBooleanv(GL_COLOR_WRITEMASK, writes);
    EXPECT_TRUE(std::all_of(writes, writes + 4, [](GLboolean write) { return write == GL_TRUE; }));
    GLfloat numbers[4] = {9, 9, 9, 9};
    glGetFloatv(GL_COLOR_CLEAR_VALUE, numbers);
    EXPECT_TRUE(std::all_of(numbers, numbers + 4, [](GLfloat value) { return value == 0.0F; }));
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, numbers);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, numbers + 1);
    EXPECT_EQ(numbers[0], 0.0F);
    EXPECT_EQ(numbers[1], 0.0F);
    glGetFloatv(GL_DEPTH_RANGE, numbers);
    EXPECT_EQ(numbers[0], 0.0F);
    EXPECT_EQ(numbers[1], 1.0F);
    if (has_clip_control) {
        EXPECT_STATE(GL_CLIP_ORIGIN, GL_LOWER_LEFT);
        EXPECT_STATE(GL_CLIP_DEPTH_MODE, GL_NEGATIVE_ONE_TO_ONE);
    }
}

TEST_F(FrameState, IsGlsDefaultAfterEveryKindOfFrame) {
    Scene scene = scene_named("torus-and-boxes");
    scene.objects.back().description.decal = true;  // the last object drawn has its own offset
    const std::vector<std::string> kinds[] = {
        {},
        {"depth.offset.factor=-2", "depth.offset.units=-3"},
        {"view.samples=0"},
        {"view.shows=depth"},
        {"view.shows=stencil"},
        {"view.shows=facing", "cull.enabled=true", "cull.face=front", "cull.front_face=cw"},
        {"depth.mapping=reversed", "depth.format=d32f", "depth.write=false", "depth.func=always"},
        {"depth.mapping=logarithmic", "depth.format=d16", "shadow.offset=lift"},
        {"depth.format=d4", "depth.test=false", "ui.theme=projector"},
        {"shadow.style=missing_light", "reflection.clip=oblique"},
        {"reflection.stencil=false", "shadow.clip_to_receiver=false", "shadow.stencil_once=false"},
    };
    for (const std::vector<std::string>& settings : kinds) {
        std::string what;
        for (const std::string& setting : settings) what += setting + " ";
        SCOPED_TRACE(what);
        const Params params = params_with(settings);
        draw(params, scene, state_px);
        expect_default_state(renderer().capabilities().clip_control);
        PixelProbe probe;
        const Derived derived = derive_for(params, scene, state_px);
        ASSERT_TRUE(probe.prepare(renderer(), plan(params, derived), scene, derived, state_px));
        probe.at({80, 60}, scene);
        expect_default_state(renderer().capabilities().clip_control);
    }
}

TEST_F(FrameState, DoesNotDependOnEarlierFrames) {
    const Scene scene = scene_named("torus-and-boxes");
    const Image expected = draw(Params{}, scene, state_px);
    constexpr unsigned first_seed = 9300;
    for (unsigned run = 0; run < 20; ++run) {
        SCOPED_TRACE("seed " + std::to_string(first_seed + run));
        Params other = testing::RandomParams(first_seed + run).make();
        clamp_to_ranges(other);
        draw(other, scene, state_px);
        EXPECT_EQ(draw(Params{}, scene, state_px), expected);
    }
}

TEST_F(FrameState, GivesTheSameBytesFromANewRenderer) {
    for (const char* const preset_like : {"view.samples=4", "view.samples=0", "view.shows=depth", "depth.format=d8"}) {
        const Scene scene = scene_named("curved");
        const Params params = params_with({preset_like});
        const Image first = draw(params, scene, state_px);
        EXPECT_EQ(draw(params, scene, state_px), first) << preset_like;
        Result<Renderer> fresh = Renderer::make();
        ASSERT_TRUE(fresh);
        View view;
        EXPECT_EQ(draw(plan(params, derive_for(params, scene, state_px)), scene, state_px, *fresh, view), first)
            << preset_like;
    }
}

TEST_F(FrameState, ViewsAcceptEverySize) {
    const Scene scene = scene_named("torus-and-boxes");
    View view;
    for (const glm::ivec2 size : {glm::ivec2(64, 48), glm::ivec2(1, 1), glm::ivec2(33, 77), glm::ivec2(64, 48)}) {
        for (const char* const shows : {"view.shows=color", "view.shows=depth"}) {
            const Params params = params_with({shows});
            const FramePlan frame = plan(params, derive_for(params, scene, size));
            const Image image = draw(frame, scene, size, renderer(), view);
            EXPECT_EQ(glm::ivec2(image.width, image.height), size);
            EXPECT_EQ(image, draw(frame, scene, size));
        }
    }
}

TEST_F(FrameState, FallbacksGiveNearlyTheSamePicture) {
    Result<Renderer> plain = Renderer::make({});
    ASSERT_TRUE(plain) << plain.error();
    EXPECT_FALSE(plain->capabilities().clip_distance);
    const Scene scene = scene_named("torus-and-boxes");
    for (const std::vector<std::string>& settings : {std::vector<std::string>{},
                                                     {"plane.equation=[0,1,0.2,-0.5]", "reflection.reflectance=0.8"},
                                                     {"depth.mapping=reversed"},
                                                     {"depth.mapping=logarithmic"},
                                                     {"depth.format=d12"},
                                                     {"view.samples=0"}}) {
        std::string what;
        for (const std::string& setting : settings) what += setting + " ";
        const Params params = params_with(settings);
        View view;
        const Derived without = derive(params, scene, {state_px, plain->capabilities().clip_control});
        EXPECT_FALSE(without.clip_zero_to_one);
        const Image fallback = draw(plan(params, without), scene, state_px, *plain, view);
        // Clipping per fragment instead of per sample, and different depth rounding, may change edges.
        EXPECT_LE(pixels_beyond(draw(params, scene, state_px), fallback, 3), 120) << what;
        Params unclipped = params;
        unclipped.reflection.clip = MirrorClip::none;
        unclipped.shadow.clip_casters = false;
        if (params.planes.front().equation.w != 0.0) {
            EXPECT_GT(pixels_beyond(draw(unclipped, scene, state_px), fallback, 3), 120) << "nothing to clip: " << what;
        }
    }
}

TEST_F(FrameState, IsDefinedForEveryDegenerateState) {
    const Scene scene = scene_named("torus-and-boxes");
    const std::vector<std::string> degenerate[] = {
        {"light.position=[3,0,-2,1]"},
        {"light.position=[3,0,-2,0]"},
        {"light.position=[0,1e-9,0,0]"},
        {"light.position=[0,0,0,1]"},
        {"light.position=[3.9,3,6.6,1]"},
        {"light.position=[3,5,2,1e-6]"},
        {"camera.position=[3.9,0,6.6]"},
        {"camera.position=[1.4,0.65,-0.65]"},
        {"camera.pitch=0", "projection.type=orthographic"},
        {"plane.extent=0.001"},
        {"plane.extent=10000"},
        {"plane.equation=[0,1,0,-1000000]"},
        {"plane.equation=[1e-6,0,0,0]"},
        {"projection.near=0.000001", "projection.far=1e9"},
        {"projection.near=1000", "projection.far=1001"},
        {"projection.fovy=179"},
        {"projection.fovy=1"},
        {"overrides.shadow_from_world=[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,0]]"},
        {"overrides.mirror_from_world=[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,0]]"},
        {"overrides.mirror_from_world=[[1,0,0,0],[0,0,0,-1],[0,0,1,0],[0,0,0,1]]", "reflection.clip=none"},
        {"overrides.mirror_from_world=[[1e12,1e12,0,0],[0,1e12,0,0],[0,0,1e12,0],[0,0,0,1]]"},
        {"overrides.shadow_from_world=[[1e12,0,0,0],[0,1e12,0,0],[0,0,1e12,0],[1e12,0,0,1]]"},
        {"overrides.view_from_world=[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,0]]"},
        {"overrides.view_from_world=[[1e12,0,0,0],[0,1e12,0,0],[0,0,0,-1e12],[0,0,1e12,0]]"},
        {"overrides.clip_from_view=[[0,0,0,0],[0,0,0,0],[0,0,0,0],[0,0,0,0]]"},
        {"overrides.clip_from_view=[[1e12,0,0,0],[0,1e12,0,0],[0,0,-1e12,-1e12],[0,0,-1e-12,0]]"},
        {"overrides.clip_from_view=[[1,0,0,0],[0,1,0,0],[0,0,-1,-1],[0,0,-1,0]]", "depth.mapping=logarithmic"},
        {"camera.position=[1e6,1e6,1e6]"},
    };
    for (const std::vector<std::string>& settings : degenerate) {
        for (const char* const clip : {"reflection.clip=clip_distance", "reflection.clip=oblique"}) {
            std::vector<std::string> all = {clip};
            all.insert(all.end(), settings.begin(), settings.end());
            std::string what;
            for (const std::string& setting : all) what += setting + " ";
            SCOPED_TRACE(what);
            const Image image = draw(params_with(all), scene, state_px);
            EXPECT_EQ(draw(params_with(all), scene, state_px), image);
            bool opaque = true;
            for (std::size_t at = 3; at < image.rgba.size(); at += 4) opaque = opaque && image.rgba[at] == 255;
            EXPECT_TRUE(opaque);
        }
    }
}

TEST_F(FrameState, ASingularMirrorMatrixStaysLit) {
    // The mirror image is flattened onto y = −1; its normals are still right although the matrix has no inverse.
    const Scene scene = scene_named("torus-and-boxes");
    const Params params = params_with({"overrides.mirror_from_world=[[1,0,0,0],[0,0,0,-1],[0,0,1,0],[0,0,0,1]]",
                                       "reflection.clip=none", "reflection.reflectance=1", "shadow.enabled=false",
                                       "light.position=[0,-5,0,1]", "reflection.reflect_light=false"});
    const Derived derived = derive_for(params, scene, state_px);
    const glm::dvec3 below_box(1.4, -1.0, -0.65);
    const glm::ivec3 color =
        testing::rgb_at(draw(params, scene, state_px), testing::pixel_of(below_box, derived, state_px));
    EXPECT_GT(color.b, 60);
    EXPECT_GT(color.b, color.r);  // the box's blue
}

}  // namespace
}  // namespace viewing
