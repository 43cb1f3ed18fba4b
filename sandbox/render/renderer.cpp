// Turns a plan into pixels: each pass becomes draw calls. Read pass_state.h and programs.h for states and programs.
#include "render/renderer.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <utility>

#include "frame/ground.h"
#include "frame/plan/draw_calls.h"
#include "geometry/shapes.h"
#include "gl/dialect.h"
#include "render/gpu_drawing.h"
#include "render/gpu_mesh.h"
#include "render/masks.h"
#include "render/pass_state.h"
#include "render/present.h"
#include "render/shared_tests.h"
#include "render/sight.h"
#include "render/stored_depth.h"
#include "render/surface_uniforms.h"

namespace viewing {
namespace {

gl::DepthKind kind_of(DepthFormat format) {
    if (format == DepthFormat::d16) return gl::DepthKind::d16;
    return format == DepthFormat::d32f ? gl::DepthKind::d32f_s8 : gl::DepthKind::d24_s8;
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
    std::map<gl::DepthKind, std::optional<StoredDepth>> stored_depths;
    bool has_drawn = false;

    Status draw_frame(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view,
                      std::optional<Shading> identify = {});
    Status draw_passes(const FramePlan& plan, const Scene& scene, const gl::Target& target, bool clear_depth,
                       std::optional<Shading> identify);
    void begin_frame(const FrameState& frame, const gl::Target& target, bool clear_depth) const;
    bool shows_anything(const FrameState& frame, const Pass& pass);
    /// Whether the pass has clip planes that cut nothing off, so that it needs no program with clipping.
    bool cuts_in_vain(const FrameState& frame, const Pass& pass);
    Status draw_pass(const FrameState& frame, const Pass& pass, const MaskUse& mask, int first_call);
    void draw_objects(const FrameState& frame, const Pass& pass, const SurfaceProgram& program, int first_call);
    void draw_ordered(const FrameState& frame, const Pass& pass, const SurfaceProgram& program);
    void draw_pixels(const FrameState& frame, const Pass& pass, const SurfaceProgram& program);
    Status draw_difference(const FramePlan& plan);
    void draw_one(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                  const glm::dmat4& world_from_model, const GpuMesh& mesh, const DepthOffset& own_offset,
                  int call) const;
};

void Renderer::Implementation::begin_frame(const FrameState& frame, const gl::Target& target, bool clear_depth) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target.draw_framebuffer());
    glViewport(0, 0, target.size_px().x, target.size_px().y);
    restore_defaults(capabilities);
    const bool counts = frame.identify || frame.plan.shows == Shows::overdraw;
    const glm::vec3 background = counts ? glm::vec3(0.0F) : srgb(frame.plan.background);
    glClearColor(background.r, background.g, background.b, 1.0F);
    gl::set_clear_depth(frame.plan.clear_depth_value);
    glClearStencil(0);
    glStencilMask(0xFF);
    glDepthMask(clear_depth ? GL_TRUE : GL_FALSE);  // glClear() obeys the mask
    const bool asks_to_clear = clear_depth || frame.plan.clear_depth;
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | (asks_to_clear ? GL_DEPTH_BUFFER_BIT : 0U));
    if (target.mask()) target.mask().clear();
    if (capabilities.clip_control && frame.plan.clip_zero_to_one) gl::set_clip_depths_from_zero(true);
}

void Renderer::Implementation::draw_one(const FrameState& frame, const Pass& pass, const SurfaceProgram& program,
                                        const glm::dmat4& world_from_model, const GpuMesh& mesh,
                                        const DepthOffset& own_offset, int call) const {
    const int triangles = triangles_drawn(frame.plan.limit, call, mesh.triangle_count());
    if (triangles == 0 || is_out_of_sight(mesh.bounds, pass, world_from_model)) return;
    set_placement(program, frame, pass, world_from_model);
    set_offset(program, frame, pass, pass.offset.value_or(own_offset));
    mesh.draw(triangles);
}

void Renderer::Implementation::draw_ordered(const FrameState& frame, const Pass& pass, const SurfaceProgram& program) {
    const std::shared_ptr<const HiddenDrawing>& hidden = frame.plan.drawing_of(pass);
    const GpuDrawing& drawing = drawings.of(hidden);
    set_placement(program, frame, pass, glm::translate(glm::dmat4(1.0), hidden->origin_world));
    for (const HiddenDrawing::Run& run : hidden->runs) {
        set_offset(program, frame, pass, pass.offset.value_or(run.is_decal ? frame.plan.decal_offset : DepthOffset{}));
        drawing.draw(run.first_vertex, run.vertex_count);
    }
}

void Renderer::Implementation::draw_pixels(const FrameState& frame, const Pass& pass, const SurfaceProgram& program) {
    const std::shared_ptr<const HiddenDrawing>& hidden = frame.plan.drawing_of(pass);
    drawings.of(hidden).bind_textures();
    program.picture_share.set(hidden->share);
    int unit = 0;
    for (const auto* sampler :
         {&program.surface_positions, &program.surface_normals, &program.surface_colors, &program.surface_counts})
        sampler->set(Sampler{unit++});
    set_placement(program, frame, pass, glm::translate(glm::dmat4(1.0), hidden->origin_world));
    set_turned_normals(program, pass);
    glDisable(GL_CULL_FACE);         // the method has already culled; this triangle only shows its result
    if (capabilities.clip_distance)  // the shader discards clipped points itself
        for (std::size_t plane = 0; plane < most_clip_planes; ++plane)
            glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(plane));
    presenter.fullscreen().draw(program);
}

Status Renderer::Implementation::draw_difference(const FramePlan& plan) {
    Result<const ShowPictureProgram*> program = programs.show_picture();
    if (!program) return Error{program.error()};
    (*program)->use();
    (*program)->picture.set(Sampler{0});
    (*program)->picture_share.set(plan.hidden.difference->share);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, drawings.texture_of(plan.hidden.difference));
    presenter.fullscreen().draw(**program);
    return std::monostate{};
}

bool Renderer::Implementation::shows_anything(const FrameState& frame, const Pass& pass) {
    if (pass.subject == Subject::patch)
        return !is_out_of_sight(quad.bounds, pass, frame.plan.patches[pass.plane].world_from_patch());
    if (pass.subject != Subject::objects) return true;
    return std::any_of(frame.scene.objects.begin(), frame.scene.objects.end(), [&](const SceneObject& object) {
        return is_chosen(pass.chosen, object) &&
               !is_out_of_sight(meshes.of(object.mesh).bounds, pass, object.world_from_model);
    });
}

bool Renderer::Implementation::cuts_in_vain(const FrameState& frame, const Pass& pass) {
    if (pass.clip_planes.empty()) return false;
    if (pass.subject == Subject::patch)
        return is_kept_whole(quad.bounds, {}, pass, frame.plan.patches[pass.plane].world_from_patch());
    // Passes that draw in a precomputed order draw pieces of the same objects as other passes.
    if (pass.subject != Subject::objects && pass.subject != Subject::ordered) return false;
    return std::all_of(frame.scene.objects.begin(), frame.scene.objects.end(), [&](const SceneObject& object) {
        return !is_chosen(pass.chosen, object) ||
               is_kept_whole(meshes.of(object.mesh).bounds, object.mesh->positions, pass, object.world_from_model);
    });
}

Status Renderer::Implementation::draw_pass(const FrameState& frame, const Pass& pass, const MaskUse& mask,
                                           int first_call) {
    if (pass.subject == Subject::difference)
        return frame.identify ? Status(std::monostate{}) : draw_difference(frame.plan);
    if (!shows_anything(frame, pass)) return std::monostate{};
    const bool is_patch = pass.subject == Subject::patch;
    using Source = SurfaceKind::Source;
    const Source source = pass.subject == Subject::ordered  ? Source::vertices
                          : pass.subject == Subject::pixels ? Source::picture
                                                            : Source::object;
    const bool has_vertices = source != Source::picture;
    const Shading shading = frame.shading_of(pass);
    const bool has_pattern = is_patch && (shading == Shading::lit || shading == Shading::unlit);
    const std::size_t lights = shading == Shading::lit ? pass.lights_world.size() : 0;
    Result<const SurfaceProgram*> found =
        programs.surface({.shading = shading,
                          .is_patch = has_pattern,
                          .clips = !pass.clip_planes.empty(),
                          .write_depth = frame.shader_writes_depth(pass),
                          .source = source,
                          .mask_test = mask.tests,
                          .mask_write = mask.writes,
                          .logarithm_per_vertex = frame.plan.has_logarithm_per_vertex() && has_vertices,
                          .lights = lights,
                          .has_gloss = is_patch && lights > 0 && pass.has_gloss,
                          .forces_sign = pass.forces_sign,
                          .depth_of_plane = frame.takes_depth_of_plane(pass)});
    if (!found) return Error{found.error()};
    const SurfaceProgram& program = **found;
    program.use();
    set_uniforms(program, frame, pass);
    set_mask(program, pass.stencil, pass.stencil.reference);
    if (source == Source::vertices) draw_ordered(frame, pass, program);
    if (source == Source::picture) draw_pixels(frame, pass, program);
    if (source != Source::object) return std::monostate{};
    if (is_patch) {
        if (frame.identify) set_identity(program, patch_identity + static_cast<int>(pass.plane));
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
        if (frame.identify) {
            set_identity(program, static_cast<int>(index + 1));
        } else if (pass.shading != Shading::flat) {
            program.base_color.set(glm::vec4(linear_from_srgb(object.description.color), 1.0F));
        }
        if (frame.shading_of(pass) == Shading::heat) set_heat_gap(program, frame.plan, index);
        draw_one(frame, pass, program, object.world_from_model, meshes.of(object.mesh),
                 object.description.decal ? frame.plan.decal_offset : DepthOffset{}, call++);
    }
}

Status Renderer::Implementation::draw_passes(const FramePlan& plan, const Scene& scene, const gl::Target& target,
                                             bool clear_depth, std::optional<Shading> identify) {
    const bool writes_depth = writes_depth_by_shader(plan.depth_format, plan.depth_mapping, plan.logarithm_per_vertex);
    const FrameState frame{plan, scene, target, writes_depth, identify};
    begin_frame(frame, target, clear_depth);
    const bool is_first = !std::exchange(has_drawn, true);
    std::vector<StencilState> tests;
    if (!target.mask()) tests = shared_stencil_tests(plan.passes);
    std::size_t count = plan.passes.size();
    if (plan.limit.pass >= 0) count = std::min(count, static_cast<std::size_t>(plan.limit.pass) + 1);
    int next_call = 0;
    for (std::size_t index = 0; index < count; ++index) {
        const Pass& planned = plan.passes[index];
        const int first_call = next_call;
        next_call += call_count(planned, scene);
        if (identify && planned.is_mirror_image) continue;  // pixels in a mirror get the identity of the mirror
        std::optional<Pass> cheaper;
        if (cuts_in_vain(frame, planned)) cheaper.emplace(planned).clip_planes.clear();
        if (!tests.empty() && tests[index] != planned.stencil)
            (cheaper ? *cheaper : cheaper.emplace(planned)).stencil = tests[index];
        const Pass& pass = cheaper ? *cheaper : planned;
        const MaskUse mask = mask_use(pass, target);
        apply_state(pass, capabilities);
        begin_mask(pass, mask, target);
        if (Status drawn = draw_pass(frame, pass, mask, first_call); !drawn) return drawn;
        if (is_first) glFlush();  // rasterize now, while the driver compiles programs for the next pass
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

Viewport Renderer::viewport(glm::ivec2 size_px) const {
    return {size_px, capabilities().clip_control};
}

Viewport Renderer::viewport(glm::ivec2 size_px, DepthFormat measured) const {
    Viewport made = viewport(size_px);
    if (stores_fewer_bits(measured)) return made;
    const auto [kept, is_new] = implementation_->stored_depths.try_emplace(kind_of(measured));
    if (is_new)
        if (const Result<StoredDepth> stored = measure_stored_depth(capabilities(), kept->first))
            kept->second = *stored;
    made.stored_depth = kept->second;
    return made;
}

Viewport Renderer::viewport(glm::ivec2 size_px, const Params& params, const Scene& scene) const {
    return depends_on_stored_depth(params, scene) ? viewport(size_px, params.depth.format) : viewport(size_px);
}

Status Renderer::Implementation::draw_frame(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view,
                                            std::optional<Shading> identify) {
    const gl::TargetSpec spec{size_px, capabilities.multisampling ? plan.samples : 0, kind_of(plan.depth_format)};
    const bool fresh = view.target_.spec() != spec;
    if (fresh) view.target_ = gl::Target(spec);
    meshes.drop_unused();
    drawings.drop_unused();

    // A frame that does not clear depth starts with the depth of the previous frame. A fresh target has no previous
    // frame, so its first frame is drawn twice.
    if (fresh && !plan.clears_depth())
        if (Status drawn = draw_passes(plan, scene, view.target_, true, identify); !drawn) return drawn;
    return draw_passes(plan, scene, view.target_, plan.clears_depth(), identify);
}

Status Renderer::draw(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view) {
    view.presents_ = plan.shows == Shows::depth || plan.shows == Shows::stencil || plan.shows == Shows::overdraw;
    if (view.presents_ && view.shown_.size_px() != size_px) view.shown_ = gl::ColorTarget(size_px);
    if (Status drawn = implementation_->draw_frame(plan, scene, size_px, view); !drawn) return drawn;
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
        if (pass.shading == Shading::flat) pass.color_write = false;  // masks and shadows have no object ID
        pass.blend = Blend::none;
    }
    return implementation_->draw_frame(plain, scene, size_px, view, Shading::identity);
}

Result<IdImage> Renderer::read_polygon_ids(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view) {
    FramePlan plain = plan;
    plain.samples = 0;
    plain.shows = Shows::color;
    std::erase_if(plain.passes, [](const Pass& pass) { return pass.subject != Subject::ordered; });
    if (Status drawn = implementation_->draw_frame(plain, scene, size_px, view, Shading::polygon_identity); !drawn)
        return Error{drawn.error()};
    const Image bytes = read(view);
    IdImage image(bytes.width, bytes.height);
    for (int y = 0; y < bytes.height; ++y)
        for (int x = 0; x < bytes.width; ++x) {
            const std::uint8_t* at = bytes.pixel(x, y);
            image.ids[image.index(x, y)] = at[0] + 256 * at[1] + 65536 * at[2] - 1;
        }
    return image;
}

}  // namespace viewing
