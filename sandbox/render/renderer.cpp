// Plan in, pixels out. Every pass sets every piece of state it depends on, and after the last one all of it is
// GL's default again, so that nothing leaks into the next pass or into the user interface.
#include "render/renderer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "frame/ground.h"
#include "geometry/normals.h"
#include "geometry/shapes.h"
#include "render/gpu_drawing.h"
#include "render/gpu_mesh.h"
#include "render/programs.h"

namespace viewing {
namespace {

glm::vec3 srgb(const Color& color) {
    return glm::vec3(color.r, color.g, color.b) / 255.0F;
}

GLenum gl_enum(CompareFunc func) {
    return GL_NEVER + static_cast<GLenum>(func);
}

void enable(GLenum capability, bool on) {
    on ? glEnable(capability) : glDisable(capability);
}

void set_matrix(GLint location, const glm::dmat4& matrix) {
    const glm::mat4 uploaded(matrix);
    glUniformMatrix4fv(location, 1, GL_FALSE, glm::value_ptr(uploaded));
}

void set_vector(GLint location, const glm::vec3& value) {
    glUniform3fv(location, 1, glm::value_ptr(value));
}
void set_vector(GLint location, const glm::vec4& value) {
    glUniform4fv(location, 1, glm::value_ptr(value));
}

/// A number below 2^16 in the bytes of red and green.
void set_identity(const SurfaceProgram& program, int identity) {
    set_vector(program.base_color, glm::vec4(glm::vec2(identity % 256, identity / 256) / 255.0F, 0.0F, 1.0F));
}

bool stores_fewer_bits(DepthFormat format) {
    return format != DepthFormat::d24 && format != DepthFormat::d32f;
}

void apply_state(const Pass& pass, const gl::Capabilities& capabilities) {
    enable(GL_DEPTH_TEST, pass.depth.test);
    glDepthFunc(gl_enum(pass.depth.func));
    glDepthMask(pass.depth.write ? GL_TRUE : GL_FALSE);

    enable(GL_CULL_FACE, pass.cull.enabled);
    static constexpr GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
    glCullFace(faces[static_cast<std::size_t>(pass.cull.face)]);
    glFrontFace(pass.cull.front_face == FrontFace::ccw ? GL_CCW : GL_CW);

    enable(GL_STENCIL_TEST, pass.stencil.test);
    glStencilFunc(gl_enum(pass.stencil.func), pass.stencil.reference, 0xFF);
    static constexpr GLenum ops[] = {GL_KEEP, GL_REPLACE, GL_INCR};
    glStencilOp(GL_KEEP, GL_KEEP, ops[static_cast<std::size_t>(pass.stencil.on_pass)]);

    enable(GL_BLEND, pass.blend != Blend::none);
    if (pass.blend == Blend::add)
        glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    else
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    const GLboolean writes = pass.color_write ? GL_TRUE : GL_FALSE;
    glColorMask(writes, writes, writes, writes);

    if (capabilities.clip_distance)
        for (std::size_t plane = 0; plane < 2; ++plane)
            enable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(plane), plane < pass.clip_planes.size());
}

const std::shared_ptr<const HiddenDrawing>& drawing_of(const FramePlan& plan, const Pass& pass) {
    return pass.is_mirror_image ? plan.hidden.mirrored : plan.hidden.camera;
}

void restore_defaults(const gl::Capabilities& capabilities) {
    Pass defaults;
    defaults.depth.test = false;
    defaults.cull = CullParams{};
    apply_state(defaults, capabilities);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.0F, 0.0F);
    glBlendFunc(GL_ONE, GL_ZERO);
    glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    glClearDepth(1.0);
    if (capabilities.clip_control) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glBindVertexArray(0);
    glUseProgram(0);
}

}  // namespace

struct Renderer::Implementation {
    explicit Implementation(const gl::Capabilities& used) : capabilities(used), programs(used) {}

    gl::Capabilities capabilities;
    Programs programs;
    GpuMeshes meshes;
    GpuDrawings drawings;
    GpuMesh quad = upload(quad_mesh());
    gl::VertexArray no_vertices = gl::make_vertex_array();

    /// What stays the same for all passes of a frame.
    struct FrameState {
        const FramePlan& plan;
        const Scene& scene;
        bool writes_depth;
        int identify;  ///< a SurfaceKind's identity, in place of colours, for reading back; 0: colours
    };

    Status draw_frame(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view, int identify);
    Status draw_passes(const FramePlan& plan, const Scene& scene, const gl::Target& target, bool clear_depth,
                       int identify);
    void begin_frame(const FrameState& frame, const gl::Target& target, bool clear_depth) const;
    Status draw_pass(const FrameState& frame, const Pass& pass);
    void set_uniforms(const FrameState& frame, const Pass& pass, const SurfaceProgram& program) const;
    void set_placement(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                       const glm::dmat4& world_from_model) const;
    void draw_ordered(const FrameState& frame, const Pass& pass, const SurfaceProgram& program);
    void draw_pixels(const FrameState& frame, const Pass& pass, const SurfaceProgram& program);
    Status draw_difference(const FramePlan& plan);
    void draw_one(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                  const glm::dmat4& world_from_model, const GpuMesh& mesh, const DepthOffset& own_offset) const;
    void set_offset(const FrameState& frame, const SurfaceProgram& program, const DepthOffset& offset) const;
    Status present_depth(const FramePlan& plan, View& view);
    Status present_stencil(View& view);
    Status present_overdraw(View& view);
    void draw_fullscreen(const gl::Program& program) const;
};

void Renderer::Implementation::begin_frame(const FrameState& frame, const gl::Target& target, bool clear_depth) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target.draw_framebuffer());
    glViewport(0, 0, target.size_px().x, target.size_px().y);
    restore_defaults(capabilities);
    const bool counts = frame.identify != 0 || frame.plan.shows == Shows::overdraw;
    const glm::vec3 background = counts ? glm::vec3(0.0F) : srgb(frame.plan.background);
    glClearColor(background.r, background.g, background.b, 1.0F);
    glClearDepth(frame.plan.clear_depth_value);
    glClearStencil(0);
    glStencilMask(0xFF);
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | (clear_depth ? GL_DEPTH_BUFFER_BIT : 0U));
    if (capabilities.clip_control && frame.plan.clip_zero_to_one) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void Renderer::Implementation::set_uniforms(const FrameState& frame, const Pass& pass,
                                            const SurfaceProgram& program) const {
    glUseProgram(program.program.name());
    set_vector(program.light_world, glm::vec4(pass.light_world));
    set_vector(program.eye_world, glm::vec4(pass.eye_world));
    set_vector(program.sky_world, glm::vec3(pass.sky_world));
    set_vector(program.base_color, glm::vec4(pass.color));
    glUniform1f(program.alpha, static_cast<float>(pass.color.a));
    const glm::vec3 tones[] = {linear_from_srgb(frame.plan.patch_light), linear_from_srgb(frame.plan.patch_dark),
                               linear_from_srgb(frame.plan.patch_line)};
    glUniform3fv(program.patch_tones, 3, glm::value_ptr(tones[0]));
    const glm::vec3 facing[] = {srgb(front_color), srgb(back_color)};
    glUniform3fv(program.facing_colors, 2, glm::value_ptr(facing[0]));
    glUniform1f(program.patch_extent, static_cast<float>(frame.plan.patch.extent));
    if (!frame.writes_depth) return;
    const bool logarithmic = frame.plan.depth_mapping == DepthMapping::logarithmic;
    const int bits = precision_of(frame.plan.depth_format).bits;
    glUniform1f(program.depth_levels,
                stores_fewer_bits(frame.plan.depth_format) ? static_cast<float>((1 << bits) - 1) : 0.0F);
    glUniform2f(program.logarithmic_range, logarithmic ? static_cast<float>(frame.plan.lens.near) : 0.0F,
                static_cast<float>(frame.plan.lens.far));
}

void Renderer::Implementation::set_offset(const FrameState& frame, const SurfaceProgram& program,
                                          const DepthOffset& offset) const {
    const bool on = offset.factor != 0.0 || offset.units != 0.0;
    if (frame.writes_depth) {
        const double step = 1.0 / ((1 << std::min(precision_of(frame.plan.depth_format).bits, 24)) - 1);
        glUniform2f(program.depth_offset, static_cast<float>(offset.factor), static_cast<float>(offset.units * step));
        return;
    }
    enable(GL_POLYGON_OFFSET_FILL, on);
    glPolygonOffset(static_cast<float>(offset.factor), static_cast<float>(offset.units));
}

void Renderer::Implementation::set_placement(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                                             const glm::dmat4& world_from_model) const {
    const glm::dmat4 placed_from_model = pass.world_from_scene * world_from_model;
    set_matrix(program.clip_from_model, pass.clip_from_world * placed_from_model);
    set_matrix(program.world_from_model, placed_from_model);
    if (pass.shading != Shading::flat) {
        const glm::mat3 world_from_normal(normal_matrix(glm::dmat3(placed_from_model)));
        glUniformMatrix3fv(program.world_from_normal, 1, GL_FALSE, glm::value_ptr(world_from_normal));
    }
    glm::vec4 planes_model[2] = {glm::vec4(0.0F, 0.0F, 0.0F, 1.0F), glm::vec4(0.0F, 0.0F, 0.0F, 1.0F)};
    for (std::size_t plane = 0; plane < pass.clip_planes.size(); ++plane)
        planes_model[plane] = glm::vec4(pass.clip_planes[plane] * world_from_model);
    glUniform4fv(program.clip_plane_model, 2, glm::value_ptr(planes_model[0]));
    if (!frame.writes_depth) return;
    const glm::dmat4 rows = glm::transpose(pass.view_from_world * placed_from_model);
    set_vector(program.view_z_of_model, glm::vec4(rows[2]));
    set_vector(program.view_w_of_model, glm::vec4(rows[3]));
}

void Renderer::Implementation::draw_one(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                                        const glm::dmat4& world_from_model, const GpuMesh& mesh,
                                        const DepthOffset& own_offset) const {
    set_placement(frame, pass, program, world_from_model);
    set_offset(frame, program, pass.offset.value_or(own_offset));
    mesh.draw();
}

void Renderer::Implementation::draw_ordered(const FrameState& frame, const Pass& pass, const SurfaceProgram& program) {
    const std::shared_ptr<const HiddenDrawing>& hidden = drawing_of(frame.plan, pass);
    const GpuDrawing& drawing = drawings.of(hidden);
    set_placement(frame, pass, program, glm::dmat4(1.0));
    for (const HiddenDrawing::Run& run : hidden->runs) {
        set_offset(frame, program, pass.offset.value_or(run.is_decal ? frame.plan.decal_offset : DepthOffset{}));
        drawing.draw(run.first_vertex, run.vertex_count);
    }
}

void Renderer::Implementation::draw_pixels(const FrameState& frame, const Pass& pass, const SurfaceProgram& program) {
    drawings.of(drawing_of(frame.plan, pass)).bind_textures();
    const GLint samplers[] = {program.surface_positions, program.surface_normals, program.surface_colors,
                              program.surface_counts};
    for (int unit = 0; unit < 4; ++unit) glUniform1i(samplers[unit], unit);
    set_placement(frame, pass, program, glm::dmat4(1.0));
    // The normals are turned towards the eye already: cofactors of a mirror would turn them around.
    const glm::dmat3 scene(pass.world_from_scene);
    const glm::mat3 world_from_normal(normal_matrix(scene) * (glm::determinant(scene) < 0.0 ? -1.0 : 1.0));
    glUniformMatrix3fv(program.world_from_normal, 1, GL_FALSE, glm::value_ptr(world_from_normal));
    glDisable(GL_CULL_FACE);           // the method has culled already; this triangle only brings its pixels
    if (capabilities.clip_distance) {  // and the shader clips by itself
        glDisable(GL_CLIP_DISTANCE0);
        glDisable(GL_CLIP_DISTANCE1);
    }
    draw_fullscreen(program.program);
}

Status Renderer::Implementation::draw_difference(const FramePlan& plan) {
    Result<const gl::Program*> program = programs.show_picture();
    if (!program) return Error{program.error()};
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, drawings.texture_of(plan.hidden.difference));
    draw_fullscreen(**program);
    return std::monostate{};
}

Status Renderer::Implementation::draw_pass(const FrameState& frame, const Pass& pass) {
    apply_state(pass, capabilities);
    if (pass.subject == Subject::difference)
        return frame.identify != 0 ? Status(std::monostate{}) : draw_difference(frame.plan);
    const bool is_patch = pass.subject == Subject::patch;
    using Source = SurfaceKind::Source;
    const Source source = pass.subject == Subject::ordered  ? Source::vertices
                          : pass.subject == Subject::pixels ? Source::picture
                                                            : Source::object;
    const int shading = frame.identify != 0 ? frame.identify : static_cast<int>(pass.shading);
    Result<const SurfaceProgram*> found = programs.surface(
        {shading, is_patch, !pass.clip_planes.empty(), frame.writes_depth && source != Source::picture, source});
    if (!found) return Error{found.error()};
    const SurfaceProgram& program = **found;
    set_uniforms(frame, pass, program);
    if (source == Source::vertices) draw_ordered(frame, pass, program);
    if (source == Source::picture) draw_pixels(frame, pass, program);
    if (source != Source::object) return std::monostate{};
    if (is_patch) {
        if (frame.identify != 0) set_identity(program, patch_identity);
        draw_one(frame, pass, program, frame.plan.patch.world_from_patch(), quad, {});
        return std::monostate{};
    }
    for (std::size_t index = 0; index < frame.scene.objects.size(); ++index) {
        const SceneObject& object = frame.scene.objects[index];
        if (frame.identify != 0) {
            set_identity(program, static_cast<int>(index + 1));
        } else if (pass.shading != Shading::flat) {
            set_vector(program.base_color, glm::vec4(linear_from_srgb(object.description.color), 1.0F));
        }
        draw_one(frame, pass, program, object.world_from_model, meshes.of(object.mesh),
                 object.description.decal ? frame.plan.decal_offset : DepthOffset{});
    }
    return std::monostate{};
}

Status Renderer::Implementation::draw_passes(const FramePlan& plan, const Scene& scene, const gl::Target& target,
                                             bool clear_depth, int identify) {
    const bool writes_depth = stores_fewer_bits(plan.depth_format) || plan.depth_mapping == DepthMapping::logarithmic;
    const FrameState frame{plan, scene, writes_depth, identify};
    begin_frame(frame, target, clear_depth);
    for (const Pass& pass : plan.passes)
        if (Status drawn = draw_pass(frame, pass); !drawn) return drawn;
    restore_defaults(capabilities);
    target.resolve();
    return std::monostate{};
}

void Renderer::Implementation::draw_fullscreen(const gl::Program& program) const {
    glUseProgram(program.name());
    glBindVertexArray(no_vertices.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

Status Renderer::Implementation::present_depth(const FramePlan& plan, View& view) {
    Result<const ShowDepthProgram*> found = programs.show_depth();
    if (!found) return Error{found.error()};
    const ShowDepthProgram& program = **found;
    glBindFramebuffer(GL_FRAMEBUFFER, view.shown_.framebuffer());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, view.target_.depth_texture());
    glUseProgram(program.program.name());
    glUniform1i(program.mapping, static_cast<int>(plan.depth_mapping));
    glUniform1i(program.linear_scale, plan.depth_scale == DepthScale::linear);
    glUniform1i(program.orthographic, plan.lens.orthographic);
    glUniform2f(program.near_far, static_cast<float>(plan.lens.near), static_cast<float>(plan.lens.far));
    glUniform2f(program.shown_range, static_cast<float>(plan.shown_range.x), static_cast<float>(plan.shown_range.y));
    glUniform1f(program.cleared, static_cast<float>(plan.clear_depth_value));
    set_vector(program.unwritten_color, srgb(plan.unwritten));
    draw_fullscreen(program.program);
    restore_defaults(capabilities);
    return std::monostate{};
}

Status Renderer::Implementation::present_stencil(View& view) {
    Result<const ConstantProgram*> constant = programs.constant();
    if (!constant) return Error{constant.error()};
    Result<const ShowStencilProgram*> show = programs.show_stencil();
    if (!show) return Error{show.error()};

    // Stencil cannot be sampled everywhere: add up its bits as red, one masked test each.
    glBindFramebuffer(GL_FRAMEBUFFER, view.target_.draw_framebuffer());
    glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_STENCIL_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glUseProgram((*constant)->program.name());
    for (int bit = 1; bit <= 128; bit *= 2) {
        glStencilFunc(GL_EQUAL, bit, static_cast<GLuint>(bit));
        glUniform4f((*constant)->value, static_cast<float>(bit) / 255.0F, 0.0F, 0.0F, 0.0F);
        draw_fullscreen((*constant)->program);
    }
    restore_defaults(capabilities);

    glBindFramebuffer(GL_FRAMEBUFFER, view.shown_.framebuffer());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, view.target_.color_texture());
    glUseProgram((*show)->program.name());
    glm::vec3 colors[stencil_colors.size()];
    std::ranges::transform(stencil_colors, colors, srgb);
    glUniform3fv((*show)->stencil_colors, 4, glm::value_ptr(colors[0]));
    draw_fullscreen((*show)->program);
    restore_defaults(capabilities);
    return std::monostate{};
}

Status Renderer::Implementation::present_overdraw(View& view) {
    Result<const ShowOverdrawProgram*> show = programs.show_overdraw();
    if (!show) return Error{show.error()};
    glBindFramebuffer(GL_FRAMEBUFFER, view.shown_.framebuffer());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, view.target_.color_texture());
    glUseProgram((*show)->program.name());
    glm::vec3 colors[overdraw_colors.size()];
    std::ranges::transform(overdraw_colors, colors, srgb);
    glUniform3fv((*show)->overdraw_colors, static_cast<GLsizei>(overdraw_colors.size()), glm::value_ptr(colors[0]));
    draw_fullscreen((*show)->program);
    restore_defaults(capabilities);
    return std::monostate{};
}

Renderer::Renderer(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::make(const gl::Capabilities& capabilities) {
    auto implementation = std::make_unique<Implementation>(capabilities);
    if (Result<const SurfaceProgram*> program = implementation->programs.surface({}); !program)
        return Error{program.error()};
    return Renderer(std::move(implementation));
}

const gl::Capabilities& Renderer::capabilities() const {
    return implementation_->capabilities;
}

Status Renderer::Implementation::draw_frame(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view,
                                            int identify) {
    const gl::TargetSpec spec{size_px, plan.samples, plan.depth_format == DepthFormat::d32f};
    const bool fresh = view.target_.spec() != spec;
    if (fresh) view.target_ = gl::Target(spec);
    meshes.drop_unused();
    drawings.drop_unused();

    // A frame that does not clear depth starts from the one before; the first one has only itself.
    if (fresh && !plan.clear_depth)
        if (Status drawn = draw_passes(plan, scene, view.target_, true, identify); !drawn) return drawn;
    return draw_passes(plan, scene, view.target_, plan.clear_depth, identify);
}

Status Renderer::draw(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view) {
    view.presents_ = plan.shows == Shows::depth || plan.shows == Shows::stencil || plan.shows == Shows::overdraw;
    if (view.presents_ && view.shown_.size_px() != size_px) view.shown_ = gl::ColorTarget(size_px);
    if (Status drawn = implementation_->draw_frame(plan, scene, size_px, view, 0); !drawn) return drawn;
    if (plan.shows == Shows::depth) return implementation_->present_depth(plan, view);
    if (plan.shows == Shows::stencil) return implementation_->present_stencil(view);
    if (plan.shows == Shows::overdraw) return implementation_->present_overdraw(view);
    return std::monostate{};
}

Image Renderer::read(const View& view) const {
    return {view.size_px().x, view.size_px().y, gl::read_pixels(view.framebuffer(), view.size_px())};
}

Status Renderer::draw_identities(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view) {
    FramePlan plain = plan;
    plain.samples = 0;
    plain.shows = Shows::color;
    std::erase_if(plain.passes, [](const Pass& pass) { return pass.is_mirror_image; });
    for (Pass& pass : plain.passes) {
        if (pass.shading == Shading::flat) pass.color_write = false;  // masks and shadows are nobody
        pass.blend = Blend::none;
    }
    return implementation_->draw_frame(plain, scene, size_px, view, SurfaceKind::identity);
}

Result<IdImage> Renderer::read_polygon_ids(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view) {
    FramePlan plain = plan;
    plain.samples = 0;
    plain.shows = Shows::color;
    std::erase_if(plain.passes,
                  [](const Pass& pass) { return pass.is_mirror_image || pass.subject != Subject::ordered; });
    if (Status drawn = implementation_->draw_frame(plain, scene, size_px, view, SurfaceKind::polygon_identity); !drawn)
        return Error{drawn.error()};
    const Image bytes = read(view);
    IdImage image(bytes.width, bytes.height);
    for (int y = 0; y < bytes.height; ++y)
        for (int x = 0; x < bytes.width; ++x) {
            const std::uint8_t* at = bytes.row(y) + 4 * static_cast<std::size_t>(x);
            image.ids[image.index(x, y)] = at[0] + 256 * at[1] + 65536 * at[2] - 1;
        }
    return image;
}

}  // namespace viewing
