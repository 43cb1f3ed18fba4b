// Tests the owners of GL objects, targets, programs and contexts: they free what they own when they are destroyed or
// reassigned, and they are empty without a context.
#include <type_traits>

#include "geometry/shapes.h"
#include "gl/target.h"
#include "gl_test.h"
#include "render/gpu_mesh.h"

namespace viewing {
namespace {

using testing::rgb_at;

template <typename Owner>
void expect_move_only() {
    static_assert(!std::is_copy_constructible_v<Owner> && !std::is_copy_assignable_v<Owner>);
    static_assert(std::is_nothrow_move_constructible_v<Owner> && std::is_nothrow_move_assignable_v<Owner>);
}

TEST(GlObjectsWithoutContext, AreMoveOnlyAndEmpty) {
    expect_move_only<gl::Buffer>();
    expect_move_only<gl::VertexArray>();
    expect_move_only<gl::Texture>();
    expect_move_only<gl::Renderbuffer>();
    expect_move_only<gl::Framebuffer>();
    expect_move_only<gl::Program>();
    static_assert(!std::is_copy_constructible_v<gl::Target> && std::is_move_constructible_v<gl::Target>);
    static_assert(!std::is_copy_constructible_v<gl::EglContext> && !std::is_copy_constructible_v<Renderer>);

    gl::Buffer empty;
    EXPECT_FALSE(empty);
    gl::Buffer moved = std::move(empty);
    EXPECT_EQ(moved.name(), 0U);
    gl::Target target;
    EXPECT_EQ(target.size_px(), glm::ivec2(0));
    gl::ColorTarget color_target;
    EXPECT_EQ(color_target.texture(), 0U);
    GpuMeshes meshes;
    meshes.drop_unused();
}

TEST(EglContextTest, RejectsAMissingDevice) {
    for (const char* const wish : {"99", "-1", "llvmpipe", "1x"}) {
        const Result<gl::EglContext> context = gl::EglContext::make(wish);
        ASSERT_FALSE(context) << wish;
        EXPECT_NE(context.error().find(std::string("--device ") + wish), std::string::npos) << context.error();
        EXPECT_NE(context.error().find("no such EGL device"), std::string::npos) << context.error();
    }
}

TEST(EglContextTest, IsASoftwareCoreProfileAndMovable) {
    Result<gl::EglContext> made = gl::EglContext::make();
    ASSERT_TRUE(made) << made.error();
    EXPECT_NE(made->description().find("software"), std::string::npos);
    gl::EglContext context = *std::move(made);
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_GE(epoxy_gl_version(), 33);
}

class GlObjects : public testing::GlTest {};

TEST_F(GlObjects, AreFreedWithTheirOwner) {
    GLuint name = 0;
    {
        gl::Buffer buffer = gl::make_buffer();
        name = buffer.name();
        glBindBuffer(GL_ARRAY_BUFFER, name);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        EXPECT_TRUE(glIsBuffer(name));
        gl::Buffer other = std::move(buffer);
        EXPECT_EQ(other.name(), name);
        EXPECT_FALSE(buffer);  // NOLINT(bugprone-use-after-move): the moved-from state is tested
        EXPECT_TRUE(glIsBuffer(name));
    }
    EXPECT_FALSE(glIsBuffer(name));
}

TEST_F(GlObjects, AssignmentFreesTheOldObject) {
    GLuint first_name = 0;
    gl::Texture kept = gl::make_texture();
    {
        gl::Texture first = gl::make_texture();
        first_name = first.name();
        glBindTexture(GL_TEXTURE_2D, first_name);
        glBindTexture(GL_TEXTURE_2D, 0);
        gl::Texture second = gl::make_texture();
        const GLuint second_name = second.name();
        first = std::move(second);
        EXPECT_EQ(first.name(), second_name);
        kept = std::move(first);
        EXPECT_EQ(kept.name(), second_name);
    }
    EXPECT_FALSE(glIsTexture(first_name));
}

TEST_F(GlObjects, ProgramsReportTheCompilersMessages) {
    const char* const good_vertex = "void main() { gl_Position = vec4(0.0); }";
    const char* const good_fragment = "out vec4 color; void main() { color = vec4(1.0); }";
    EXPECT_TRUE(gl::make_program(good_vertex, good_fragment));
    const Result<gl::Program> broken = gl::make_program(good_vertex, "void main() { colour = 1; }");
    ASSERT_FALSE(broken);
    EXPECT_NE(broken.error().find("does not compile"), std::string::npos);
    EXPECT_NE(broken.error().find("colour"), std::string::npos) << broken.error();
    const Result<gl::Program> unlinked =
        gl::make_program("out vec3 a; void main() { a = vec3(0.0); gl_Position = vec4(a, 1.0); }",
                         "in vec2 a; out vec4 color; void main() { color = a.xyxy; }");
    ASSERT_FALSE(unlinked);
    EXPECT_NE(unlinked.error().find("does not link"), std::string::npos) << unlinked.error();
    forget_errors();  // the driver also sends its log to the debug output
    EXPECT_TRUE(gl::make_program("#ifndef WANTED\n#error missing\n#endif\nvoid main() { gl_Position = vec4(0.0); }",
                                 good_fragment, "#define WANTED\n"));
}

TEST_F(GlObjects, TargetsStartWithFarDepthAndClearStencil) {
    for (const int samples : {0, 4}) {
        for (const gl::DepthKind kind : {gl::DepthKind::d24_s8, gl::DepthKind::d32f_s8, gl::DepthKind::d16}) {
            SCOPED_TRACE(std::to_string(samples) + " samples, kind " + std::to_string(static_cast<int>(kind)));
            const gl::Target target({{7, 5}, samples, kind});
            EXPECT_EQ(target.size_px(), glm::ivec2(7, 5));
            glBindFramebuffer(GL_FRAMEBUFFER, target.draw_framebuffer());
            EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
            GLint found = -1;
            glGetIntegerv(GL_SAMPLES, &found);
            EXPECT_EQ(found, samples);
            EXPECT_EQ(target.draw_framebuffer() == target.single_framebuffer(), samples == 0);
            EXPECT_EQ(target.depth_texture() != 0, samples == 0);
            GLint type = 0;
            glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                                  GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
            EXPECT_EQ(type, kind == gl::DepthKind::d32f_s8 ? GL_FLOAT : GL_UNSIGNED_NORMALIZED);
            const auto attached = [](GLenum attachment, GLenum component) {
                GLint bits = 0;
                glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, component, &bits);
                return bits;
            };
            const bool has_stencil = kind != gl::DepthKind::d16;
            EXPECT_EQ(attached(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE),
                      kind == gl::DepthKind::d16       ? 16
                      : kind == gl::DepthKind::d32f_s8 ? 32
                                                       : 24);
            EXPECT_EQ(target.has_stencil(), has_stencil);
            EXPECT_EQ(attached(GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE, has_stencil);
            if (samples != 0) continue;
            float depth = 0.0F;
            glReadPixels(3, 2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
            EXPECT_EQ(depth, 1.0F);
            if (!has_stencil) continue;
            std::uint8_t stencil = 77;
            glReadPixels(3, 2, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
            EXPECT_EQ(stencil, 0);
        }
    }
}

TEST_F(GlObjects, SamplesAreResolvedAndReadFromTheTop) {
    for (const int samples : {0, 4}) {
        const gl::Target target({{3, 4}, samples});
        glBindFramebuffer(GL_FRAMEBUFFER, target.draw_framebuffer());
        glClearColor(0.0F, 1.0F, 0.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 1, 1);  // bottom left
        glClearColor(1.0F, 0.0F, 0.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);
        glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
        target.resolve();
        const Image image{3, 4, gl::read_pixels(target.single_framebuffer(), target.size_px())};
        EXPECT_EQ(rgb_at(image, {0, 3}), glm::ivec3(255, 0, 0)) << samples;
        EXPECT_EQ(rgb_at(image, {0, 0}), glm::ivec3(0, 255, 0)) << samples;
        EXPECT_EQ(rgb_at(image, {2, 3}), glm::ivec3(0, 255, 0)) << samples;
    }
}

TEST_F(GlObjects, MeshesAreUploadedOnceAndFreedWithTheirScene) {
    GpuMeshes meshes;
    auto box = std::make_shared<const Mesh>(box_mesh());
    auto ball = std::make_shared<const Mesh>(sphere_mesh());
    const GLuint box_name = meshes.of(box).vertices.name(), ball_name = meshes.of(ball).vertices.name();
    EXPECT_EQ(meshes.of(box).vertices.name(), box_name);
    EXPECT_EQ(meshes.of(box).index_count, 36);
    ball.reset();
    meshes.drop_unused();
    EXPECT_TRUE(glIsBuffer(box_name));
    EXPECT_FALSE(glIsBuffer(ball_name));
    EXPECT_EQ(meshes.of(box).vertices.name(), box_name);
    box.reset();
    meshes.drop_unused();
    EXPECT_FALSE(glIsBuffer(box_name));
}

}  // namespace
}  // namespace viewing
