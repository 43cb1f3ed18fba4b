// A pass's state reaches GL unchanged: each comparison, operation, face and clip plane is queried back from GL.
#include "render/pass_state.h"

#include "gl_test.h"

namespace viewing {
namespace {

class PassState : public testing::GlTest {
protected:
    static GLenum asked(GLenum name) {
        GLint found = -1;
        glGetIntegerv(name, &found);
        return static_cast<GLenum>(found);
    }
    static void apply(const Pass& pass) { apply_state(pass, renderer().capabilities()); }
    void TearDown() override {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        restore_defaults(renderer().capabilities());
        GlTest::TearDown();
    }
};

TEST_F(PassState, HasEveryComparison) {
    const std::pair<CompareFunc, GLenum> all[] = {
        {CompareFunc::never, GL_NEVER},   {CompareFunc::less, GL_LESS},       {CompareFunc::equal, GL_EQUAL},
        {CompareFunc::lequal, GL_LEQUAL}, {CompareFunc::greater, GL_GREATER}, {CompareFunc::notequal, GL_NOTEQUAL},
        {CompareFunc::gequal, GL_GEQUAL}, {CompareFunc::always, GL_ALWAYS}};
    for (const auto& [func, expected] : all) {
        Pass pass;
        pass.depth.func = pass.stencil.func = func;
        apply(pass);
        EXPECT_EQ(asked(GL_DEPTH_FUNC), expected);
        EXPECT_EQ(asked(GL_STENCIL_FUNC), expected);
    }
}

TEST_F(PassState, HasEveryStencilOperationOnlyWhenBothTestsPass) {
    // GL reports only as many bits of the reference as the framebuffer's stencil buffer has.
    const gl::Target target({{1, 1}, 0, gl::DepthKind::d24_s8});
    glBindFramebuffer(GL_FRAMEBUFFER, target.draw_framebuffer());
    const std::pair<StencilOp, GLenum> all[] = {{StencilOp::keep, GL_KEEP},      {StencilOp::replace, GL_REPLACE},
                                                {StencilOp::increment, GL_INCR}, {StencilOp::decrement, GL_DECR},
                                                {StencilOp::invert, GL_INVERT},  {StencilOp::zero, GL_ZERO}};
    for (const auto& [op, expected] : all) {
        Pass pass;
        pass.stencil = {.test = true, .reference = 5, .on_pass = op, .read_bits = 0x3C, .write_bits = 0x0F};
        apply(pass);
        EXPECT_EQ(asked(GL_STENCIL_PASS_DEPTH_PASS), expected);
        EXPECT_EQ(asked(GL_STENCIL_FAIL), GLenum{GL_KEEP});
        EXPECT_EQ(asked(GL_STENCIL_PASS_DEPTH_FAIL), GLenum{GL_KEEP});
        EXPECT_EQ(asked(GL_STENCIL_REF), 5U);
        EXPECT_EQ(asked(GL_STENCIL_VALUE_MASK), 0x3CU);
        EXPECT_EQ(asked(GL_STENCIL_WRITEMASK), 0x0FU);
        EXPECT_TRUE(glIsEnabled(GL_STENCIL_TEST));
    }
}

TEST_F(PassState, HasFacesAndWriteMasks) {
    const std::pair<CullFace, GLenum> faces[] = {
        {CullFace::front, GL_FRONT}, {CullFace::back, GL_BACK}, {CullFace::front_and_back, GL_FRONT_AND_BACK}};
    for (const auto& [face, expected] : faces)
        for (const bool on : {false, true}) {
            Pass pass;
            pass.cull = {.enabled = on, .face = face, .front_face = on ? FrontFace::cw : FrontFace::ccw};
            pass.depth.test = pass.depth.write = on;
            apply(pass);
            EXPECT_EQ(asked(GL_CULL_FACE_MODE), expected);
            EXPECT_EQ(asked(GL_FRONT_FACE), GLenum{on ? GLenum{GL_CW} : GLenum{GL_CCW}});
            EXPECT_EQ(glIsEnabled(GL_CULL_FACE) == GL_TRUE, on);
            EXPECT_EQ(glIsEnabled(GL_DEPTH_TEST) == GL_TRUE, on);
            EXPECT_EQ(asked(GL_DEPTH_WRITEMASK) == GL_TRUE, on);
        }
}

TEST_F(PassState, HasAsManyClipPlanesAsThePass) {
    if (!renderer().capabilities().clip_distance) GTEST_SKIP() << "no clip distances here";
    for (std::size_t count = 0; count <= most_clip_planes; ++count) {
        Pass pass;
        pass.clip_planes.resize(count);
        apply(pass);
        for (std::size_t plane = 0; plane < most_clip_planes; ++plane)
            EXPECT_EQ(glIsEnabled(GL_CLIP_DISTANCE0 + static_cast<GLenum>(plane)) == GL_TRUE, plane < count);
    }
}

}  // namespace
}  // namespace viewing
