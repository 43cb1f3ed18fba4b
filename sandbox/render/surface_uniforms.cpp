#include "render/surface_uniforms.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/normals.h"
#include "render/pass_state.h"

namespace viewing {
namespace {

/// Returns the translation that moves a point to the origin.
glm::dmat4 moved_to_origin(const glm::dvec3& point) {
    return glm::translate(glm::dmat4(1.0), -point);
}

/// Converts a plane from world space to the space of relative positions.
glm::dvec4 for_relative(const glm::dvec4& plane_world, const Pass& pass) {
    return {glm::dvec3(plane_world), glm::dot(plane_world, glm::dvec4(relative_origin(pass), 1.0))};
}

void set_lights(const SurfaceProgram& program, const Pass& pass) {
    const glm::dmat4 relative_from_world = moved_to_origin(relative_origin(pass));
    std::array<glm::vec4, most_lights> lights;
    const std::size_t count = pass.lights_world.size();
    for (std::size_t light = 0; light < count; ++light) lights[light] = relative_from_world * pass.lights_world[light];
    program.lights_relative.set_first(std::span(lights).first(count));
    program.light_strength.set(pass.light_strength);
    program.eye_relative.set(relative_from_world * pass.eye_world);
    program.sky_world.set(pass.sky_world);
}

/// Sets the heat map; a plan without one has no pairs of surfaces to color. Read topics/depth/numbers/heat_map.h for
/// its numbers.
void set_heat(const SurfaceProgram& program, const FramePlan& plan, const Pass& pass) {
    program.heat_view_from_relative.set(pass.view_from_world * glm::inverse(moved_to_origin(relative_origin(pass))));
    program.heat_tones.set_first(srgb(heat_colors));
    if (!plan.heat) return;
    program.heat_near_far.set(glm::dvec2(plan.heat->near, plan.heat->far));
    std::array<glm::vec4, HeatMap::entry_count / 4> logarithms;
    for (std::size_t entry = 0; entry < HeatMap::entry_count; ++entry)
        logarithms[entry / 4][static_cast<int>(entry % 4)] = static_cast<float>(std::log(plan.heat->onsets[entry]));
    program.heat_onsets.set_first(logarithms);
}

void set_depth(const SurfaceProgram& program, const FramePlan& plan) {
    const bool logarithmic = plan.depth_mapping == DepthMapping::logarithmic && !plan.has_logarithm_per_vertex();
    const double levels = precision_of(plan.depth_format).greatest_code();
    program.depth_levels.set(stores_fewer_bits(plan.depth_format) ? static_cast<int>(levels) : 0);
    program.logarithmic_range.set(
        glm::dvec2(logarithmic ? plan.lens.logarithmic_near() : 0.0, plan.lens.logarithmic_far()));
    program.reverses_depth.set(plan.depth_mapping == DepthMapping::reversed);
}

/// Returns the unit normal, toward the eye, of a square in the xz plane of its model; zero if the square is flattened.
glm::dvec3 patch_normal(const Pass& pass, const glm::dmat4& placed_from_model) {
    const glm::dvec3 normal = normal_matrix(glm::dmat3(placed_from_model))[1];
    const double length = glm::length(normal);
    if (length == 0.0) return normal;
    const glm::dvec3 to_eye = glm::dvec3(pass.eye_world) - pass.eye_world.w * glm::dvec3(placed_from_model[3]);
    return normal / (glm::dot(normal, to_eye) < 0.0 ? -length : length);
}

/// Returns the coefficients of x, y and 1 in the window depth of a shadow's plane, where x and y are in pixels from the
/// lower left; 0 if the plane is seen edge-on.
glm::dvec3 depth_in_plane(const FrameState& frame, const Pass& pass) {
    const PlanePatch& patch = frame.plan.patches[pass.plane];
    glm::dmat3 columns(1.0);
    glm::dvec3 depths(0.0);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 way = i == 0 ? glm::dvec3(0.0) : patch.extent * (i == 1 ? patch.u : patch.v);
        const glm::dvec4 clip = pass.clip_from_world * pass.world_from_scene * glm::dvec4(patch.center + way, 1.0);
        columns[i] = glm::dvec3(clip.x, clip.y, clip.w);
        depths[i] = frame.plan.clip_zero_to_one ? clip.z : 0.5 * (clip.z + clip.w);
    }
    if (glm::determinant(columns) == 0.0) return glm::dvec3(0.0);
    const glm::dvec3 of_clip = depths * glm::inverse(columns);  // depth = of_clip · (x, y, w) ÷ w
    const glm::dvec2 per_pixel = glm::dvec2(of_clip) * 2.0 / glm::dvec2(frame.target.size_px());
    return {per_pixel, of_clip.z - of_clip.x - of_clip.y};
}

}  // namespace

glm::dvec3 relative_origin(const Pass& pass) {
    if (pass.eye_world.w != 0.0) return glm::dvec3(pass.eye_world) / pass.eye_world.w;
    const glm::dmat3 turned(pass.view_from_world);
    if (glm::determinant(turned) == 0.0) return glm::dvec3(0.0);
    return glm::inverse(turned) * -glm::dvec3(pass.view_from_world[3]);
}

void set_uniforms(const SurfaceProgram& program, const FrameState& frame, const Pass& pass) {
    const FramePlan& plan = frame.plan;
    set_lights(program, pass);
    program.base_color.set(pass.color);
    program.alpha.set(pass.color.a);
    const std::array<glm::vec3, patch_tone_count> tones{
        linear_from_srgb(plan.patch_light), linear_from_srgb(plan.patch_dark), linear_from_srgb(plan.patch_line)};
    program.patch_tones.set_first(tones);
    program.front_color.set(srgb(front_color));
    program.back_color.set(srgb(back_color));
    if (pass.subject == Subject::patch) program.patch_extent.set(plan.patches[pass.plane].extent);
    if (pass.shading == Shading::caster_w) {
        program.caster_w.set(for_relative(plan.caster_w, pass));
        program.caster_side.set(for_relative(plan.caster_side, pass));
        program.caster_tones.set_first(srgb(caster_colors));
    }
    program.vertex_near_far.set(glm::dvec2(plan.lens.logarithmic_near(), plan.lens.logarithmic_far()));
    if (frame.shading_of(pass) == Shading::heat) set_heat(program, plan, pass);
    if (frame.takes_depth_of_plane(pass)) program.depth_in_plane.set(depth_in_plane(frame, pass));
    if (frame.shader_writes_depth(pass)) set_depth(program, plan);
}

void set_placement(const SurfaceProgram& program, const FrameState& frame, const Pass& pass,
                   const glm::dmat4& world_from_model) {
    const glm::dmat4 placed_from_model = pass.world_from_scene * world_from_model;
    program.clip_from_model.set(pass.clip_from_world * placed_from_model);
    program.relative_from_model.set(moved_to_origin(relative_origin(pass)) * placed_from_model);
    if (pass.shading != Shading::flat) program.world_from_normal.set(normal_matrix(glm::dmat3(placed_from_model)));
    if (pass.subject == Subject::patch) program.patch_normal.set(patch_normal(pass, placed_from_model));
    std::array<glm::vec4, most_clip_planes> planes_model;
    planes_model.fill(glm::vec4(0.0F, 0.0F, 0.0F, 1.0F));  // no point is behind this plane
    for (std::size_t plane = 0; plane < pass.clip_planes.size(); ++plane)
        planes_model[plane] = glm::vec4(pass.clip_planes[plane] * world_from_model);
    program.clip_plane_model.set_first(planes_model);
    if (!frame.shader_writes_depth(pass) && !frame.plan.has_logarithm_per_vertex()) return;
    const glm::dmat4 rows = glm::transpose(pass.view_from_world * placed_from_model);
    program.view_z_of_model.set(rows[2]);
    program.view_w_of_model.set(rows[3]);
}

void set_turned_normals(const SurfaceProgram& program, const Pass& pass) {
    const glm::dmat3 scene(pass.world_from_scene);
    program.world_from_normal.set(normal_matrix(scene) * (glm::determinant(scene) < 0.0 ? -1.0 : 1.0));
}

void set_offset(const SurfaceProgram& program, const FrameState& frame, const Pass& pass, const DepthOffset& offset) {
    if (frame.writes_depth || frame.takes_depth_of_plane(pass)) {
        const double step = 1.0 / ((1 << std::min(precision_of(frame.plan.depth_format).bits, 24)) - 1);
        program.depth_offset.set(glm::dvec2(offset.factor, offset.units * step));
        return;
    }
    enable(GL_POLYGON_OFFSET_FILL, offset != DepthOffset{});
    glPolygonOffset(static_cast<float>(offset.factor), static_cast<float>(offset.units));
}

void set_identity(const SurfaceProgram& program, int identity) {
    program.base_color.set(glm::vec4(glm::vec2(identity % 256, identity / 256) / 255.0F, 0.0F, 1.0F));
}

void set_heat_gap(const SurfaceProgram& program, const FramePlan& plan, std::size_t object) {
    const bool is_known = plan.heat && object < plan.heat->gap_of_object.size();
    const std::optional<FlatGap> flat = is_known ? plan.heat->gap_of_object[object] : std::nullopt;
    program.heat_gap.set(flat ? glm::dvec4(flat->normal_view, flat->gap) : glm::dvec4(0.0, 0.0, 0.0, -1.0));
}

}  // namespace viewing
