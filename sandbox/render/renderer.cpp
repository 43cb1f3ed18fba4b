// Plan in, pixels out: each pass as draw calls. Read pass_state.h and programs.h for what they are drawn with.
#include "render/renderer.h"

#include <algorithm>

#include "frame/draw_calls.h"
#include "frame/ground.h"
#include "geometry/normals.h"
#include "geometry/shapes.h"
#include "render/gpu_drawing.h"
#include "render/gpu_mesh.h"
#include "render/heat.h"
#include "render/masks.h"
#include "render/pass_state.h"
#include "render/present.h"
#include "render/programs.h"
#include "render/uniforms.h"
#include "state/fields.h"

namespace viewing {
namespace {

constexpr std::size_t most_lights = 1 + max_further_lights;

/// A number below 2^16 in the bytes of red and green.
void set_identity(const SurfaceProgram& program, int identity) {
    set_vector(program.base_color, glm::vec4(glm::vec2(identity % 256, identity / 256) / 255.0F, 0.0F, 1.0F));
}

/// Formats that GL does not have are kept exactly inside 24 bits.
bool stores_fewer_bits(DepthFormat format) {
    return precision_of(format).bits < 16;
}

gl::DepthKind kind_of(DepthFormat format) {
    if (format == DepthFormat::d16) return gl::DepthKind::d16;
    return format == DepthFormat::d32f ? gl::DepthKind::d32f_s8 : gl::DepthKind::d24_s8;
}

const std::shared_ptr<const HiddenDrawing>& drawing_of(const FramePlan& plan, const Pass& pass) {
    return pass.is_mirror_image ? plan.hidden.mirrored : plan.hidden.camera;
}

}  // namespace

struct Renderer::Implementation {
    explicit Implementation(const gl::Capabilities& used) : capabilities(used), programs(used) {}

    gl::Capabilities capabilities;
    Programs programs;
    GpuMeshes meshes;
    GpuDrawings drawings;
    GpuMesh quad = upload(quad_mesh());
    Presenter presenter{capabilities, programs};

    /// What stays the same for all passes of a frame.
    struct FrameState {
        const FramePlan& plan;
        const Scene& scene;
        const gl::Target& target;
        bool writes_depth;
        int identify;  ///< a SurfaceKind's identity, in place of colours, for reading back; 0: colours
    };

    Status draw_frame(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view, int identify);
    Status draw_passes(const FramePlan& plan, const Scene& scene, const gl::Target& target, bool clear_depth,
                       int identify);
    void begin_frame(const FrameState& frame, const gl::Target& target, bool clear_depth) const;
    Status draw_pass(const FrameState& frame, const Pass& pass, const MaskUse& mask, int first_call);
    void draw_objects(const FrameState& frame, const Pass& pass, const SurfaceProgram& program, int first_call);
    void set_uniforms(const FrameState& frame, const Pass& pass, const SurfaceProgram& program) const;
    void set_placement(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                       const glm::dmat4& world_from_model) const;
    void draw_ordered(const FrameState& frame, const Pass& pass, const SurfaceProgram& program);
    void draw_pixels(const FrameState& frame, const Pass& pass, const SurfaceProgram& program);
    Status draw_difference(const FramePlan& plan);
    void draw_one(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                  const glm::dmat4& world_from_model, const GpuMesh& mesh, const DepthOffset& own_offset,
                  int call) const;
    void set_offset(const FrameState& frame, const SurfaceProgram& program, const DepthOffset& offset) const;
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
    glDepthMask(clear_depth ? GL_TRUE : GL_FALSE);  // which a clear obeys
    const bool asks_to_clear = clear_depth || frame.plan.clear_depth;
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | (asks_to_clear ? GL_DEPTH_BUFFER_BIT : 0U));
    if (target.mask()) target.mask().clear();
    if (capabilities.clip_control && frame.plan.clip_zero_to_one) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void Renderer::Implementation::set_uniforms(const FrameState& frame, const Pass& pass,
                                            const SurfaceProgram& program) const {
    glUseProgram(program.program.name());
    glm::vec4 lights_world[most_lights];
    for (std::size_t light = 0; light < pass.lights_world.size(); ++light)
        lights_world[light] = glm::vec4(pass.lights_world[light]);
    glUniform4fv(program.lights_world, static_cast<GLsizei>(pass.lights_world.size()), glm::value_ptr(lights_world[0]));
    glUniform1f(program.light_strength, static_cast<float>(pass.light_strength));
    set_vector(program.eye_world, glm::vec4(pass.eye_world));
    set_vector(program.sky_world, glm::vec3(pass.sky_world));
    set_vector(program.base_color, glm::vec4(pass.color));
    glUniform1f(program.alpha, static_cast<float>(pass.color.a));
    const glm::vec3 tones[] = {linear_from_srgb(frame.plan.patch_light), linear_from_srgb(frame.plan.patch_dark),
                               linear_from_srgb(frame.plan.patch_line)};
    glUniform3fv(program.patch_tones, 3, glm::value_ptr(tones[0]));
    const glm::vec3 facing[] = {srgb(front_color), srgb(back_color)};
    glUniform3fv(program.facing_colors, 2, glm::value_ptr(facing[0]));
    if (pass.subject == Subject::patch)
        glUniform1f(program.patch_extent, static_cast<float>(frame.plan.patches[pass.plane].extent));
    if (pass.shading == Shading::caster_w) {
        set_vector(program.caster_w, glm::vec4(frame.plan.caster_w));
        set_vector(program.caster_side, glm::vec4(frame.plan.caster_side));
        set_colors(program.caster_colors, caster_colors);
    }
    const Lens& lens = frame.plan.lens;
    glUniform2f(program.vertex_near_far, static_cast<float>(lens.near), static_cast<float>(lens.far));
    if (frame.identify == 0 && pass.shading == Shading::heat) set_heat(program, frame.plan, pass);
    if (!frame.writes_depth) return;
    const bool logarithmic =
        frame.plan.depth_mapping == DepthMapping::logarithmic && !frame.plan.has_logarithm_per_vertex();
    const int bits = precision_of(frame.plan.depth_format).bits;
    glUniform1f(program.depth_levels,
                stores_fewer_bits(frame.plan.depth_format) ? static_cast<float>((1 << bits) - 1) : 0.0F);
    glUniform2f(program.logarithmic_range, logarithmic ? static_cast<float>(lens.near) : 0.0F,
                static_cast<float>(lens.far));
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
    if (!frame.writes_depth && !frame.plan.has_logarithm_per_vertex()) return;
    const glm::dmat4 rows = glm::transpose(pass.view_from_world * placed_from_model);
    set_vector(program.view_z_of_model, glm::vec4(rows[2]));
    set_vector(program.view_w_of_model, glm::vec4(rows[3]));
}

void Renderer::Implementation::draw_one(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                                        const glm::dmat4& world_from_model, const GpuMesh& mesh,
                                        const DepthOffset& own_offset, int call) const {
    const int triangles = triangles_drawn(frame.plan.limit, call, mesh.triangle_count());
    if (triangles == 0) return;
    set_placement(frame, pass, program, world_from_model);
    set_offset(frame, program, pass.offset.value_or(own_offset));
    mesh.draw(triangles);
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
    presenter.fullscreen().draw(program.program);
}

Status Renderer::Implementation::draw_difference(const FramePlan& plan) {
    Result<const gl::Program*> program = programs.show_picture();
    if (!program) return Error{program.error()};
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, drawings.texture_of(plan.hidden.difference));
    presenter.fullscreen().draw(**program);
    return std::monostate{};
}

Status Renderer::Implementation::draw_pass(const FrameState& frame, const Pass& pass, const MaskUse& mask,
                                           int first_call) {
    if (pass.subject == Subject::difference)
        return frame.identify != 0 ? Status(std::monostate{}) : draw_difference(frame.plan);
    const bool is_patch = pass.subject == Subject::patch;
    using Source = SurfaceKind::Source;
    const Source source = pass.subject == Subject::ordered  ? Source::vertices
                          : pass.subject == Subject::pixels ? Source::picture
                                                            : Source::object;
    const int shading = frame.identify != 0 ? frame.identify : static_cast<int>(pass.shading);
    const bool is_lit = frame.identify == 0 && pass.shading == Shading::lit;
    const int lights = is_lit ? static_cast<int>(pass.lights_world.size()) : 0;
    Result<const SurfaceProgram*> found = programs.surface(
        {shading, is_patch, !pass.clip_planes.empty(), frame.writes_depth && source != Source::picture, source,
         mask.tests, mask.writes, frame.plan.has_logarithm_per_vertex() && source != Source::picture, lights,
         is_patch && lights > 0 && pass.has_gloss, pass.forces_sign});
    if (!found) return Error{found.error()};
    const SurfaceProgram& program = **found;
    set_uniforms(frame, pass, program);
    set_mask(program, pass.stencil, pass.stencil.reference);
    if (source == Source::vertices) draw_ordered(frame, pass, program);
    if (source == Source::picture) draw_pixels(frame, pass, program);
    if (source != Source::object) return std::monostate{};
    if (is_patch) {
        if (frame.identify != 0) set_identity(program, patch_identity + static_cast<int>(pass.plane));
        draw_one(frame, pass, program, frame.plan.patches[pass.plane].world_from_patch(), quad, {}, first_call);
        return std::monostate{};
    }
    if (pass.subject == Subject::backdrop) {
        draw_one(frame, pass, program, glm::dmat4(1.0), quad, {}, first_call);
        return std::monostate{};
    }
    draw_objects(frame, pass, program, first_call);
    return std::monostate{};
}

void Renderer::Implementation::draw_objects(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                                            int first_call) {
    int call = first_call;
    for (std::size_t index = 0; index < frame.scene.objects.size(); ++index) {
        const SceneObject& object = frame.scene.objects[index];
        if (!is_chosen(pass.chosen, object)) continue;
        if (pass.marks_objects) {
            apply_stencil(pass.stencil, frame.plan.mark_of(index));
            set_mask(program, pass.stencil, frame.plan.mark_of(index));
        }
        if (frame.identify != 0) {
            set_identity(program, static_cast<int>(index + 1));
        } else if (pass.shading != Shading::flat) {
            set_vector(program.base_color, glm::vec4(linear_from_srgb(object.description.color), 1.0F));
        }
        if (frame.identify == 0 && pass.shading == Shading::heat) set_heat_gap(program, frame.plan, index);
        draw_one(frame, pass, program, object.world_from_model, meshes.of(object.mesh),
                 object.description.decal ? frame.plan.decal_offset : DepthOffset{}, call++);
    }
}

Status Renderer::Implementation::draw_passes(const FramePlan& plan, const Scene& scene, const gl::Target& target,
                                             bool clear_depth, int identify) {
    const bool writes_depth = stores_fewer_bits(plan.depth_format) ||
                              (plan.depth_mapping == DepthMapping::logarithmic && !plan.has_logarithm_per_vertex());
    const FrameState frame{plan, scene, target, writes_depth, identify};
    begin_frame(frame, target, clear_depth);
    int next_call = 0, next_pass = 0;
    for (const Pass& pass : plan.passes) {
        if (plan.limit.pass >= 0 && next_pass++ > plan.limit.pass) break;
        const int first_call = next_call;
        next_call += call_count(pass, scene);
        if (identify != 0 && pass.is_mirror_image) continue;  // what is there is the mirror
        const MaskUse mask = mask_use(pass, target);
        apply_state(pass, capabilities);
        begin_mask(pass, mask, target);
        if (Status drawn = draw_pass(frame, pass, mask, first_call); !drawn) return drawn;
        if (!mask.fills) continue;
        Result<const FillProgram*> fill = programs.fill();
        if (!fill) return Error{fill.error()};
        fill_changed(pass, target, **fill, presenter.fullscreen(), capabilities);
    }
    restore_defaults(capabilities);
    target.resolve();
    return std::monostate{};
}

Renderer::Renderer(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::make(const gl::Capabilities& capabilities) {
    auto implementation = std::make_unique<Implementation>(capabilities);
    if (Result<const SurfaceProgram*> program = implementation->programs.surface({.lights = 1}); !program)
        return Error{program.error()};
    return Renderer(std::move(implementation));
}

const gl::Capabilities& Renderer::capabilities() const {
    return implementation_->capabilities;
}

Status Renderer::Implementation::draw_frame(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view,
                                            int identify) {
    const gl::TargetSpec spec{size_px, plan.samples, kind_of(plan.depth_format)};
    const bool fresh = view.target_.spec() != spec;
    if (fresh) view.target_ = gl::Target(spec);
    meshes.drop_unused();
    drawings.drop_unused();

    // A frame that does not clear depth starts from the one before; the first one has only itself.
    if (fresh && !plan.clears_depth())
        if (Status drawn = draw_passes(plan, scene, view.target_, true, identify); !drawn) return drawn;
    return draw_passes(plan, scene, view.target_, plan.clears_depth(), identify);
}

Status Renderer::draw(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view) {
    view.presents_ = plan.shows == Shows::depth || plan.shows == Shows::stencil || plan.shows == Shows::overdraw;
    if (view.presents_ && view.shown_.size_px() != size_px) view.shown_ = gl::ColorTarget(size_px);
    if (Status drawn = implementation_->draw_frame(plan, scene, size_px, view, 0); !drawn) return drawn;
    Presenter& presenter = implementation_->presenter;
    if (plan.shows == Shows::depth) return presenter.depth(plan, view.target_, view.shown_);
    if (plan.shows == Shows::stencil) return presenter.stencil(view.target_, view.shown_);
    if (plan.shows == Shows::overdraw) return presenter.overdraw(view.target_, view.shown_);
    return std::monostate{};
}

Image Renderer::read(const View& view) const {
    return {view.size_px().x, view.size_px().y, gl::read_pixels(view.framebuffer(), view.size_px())};
}

Status Renderer::draw_identities(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view) {
    FramePlan plain = plan;
    plain.samples = 0;
    plain.shows = Shows::color;
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
    std::erase_if(plain.passes, [](const Pass& pass) { return pass.subject != Subject::ordered; });
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
