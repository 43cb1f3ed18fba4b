#include "render/programs.h"

#include <string>

#include "embedded/shaders.h"
#include "frame/depth/depth_colors.h"

namespace viewing {
namespace {

Result<gl::Program> load(const char* vertex, const char* fragment, std::string_view defines = "") {
    Result<gl::Program> made = gl::make_program(embedded_shader(vertex), embedded_shader(fragment), defines);
    if (!made) return Error{std::string(fragment) + ": " + made.error()};
    return made;
}

GLint uniform(const gl::Program& program, const char* name) {
    return glGetUniformLocation(program.name(), name);
}

}  // namespace

Result<const SurfaceProgram*> Programs::surface(const SurfaceKind& kind) {
    if (const auto found = surfaces_.find(kind); found != surfaces_.end()) return &found->second;
    std::string defines = "#define SHADING " + std::to_string(kind.shading) + "\n";
    if (kind.lights > 0) defines += "#define LIGHTS " + std::to_string(kind.lights) + "\n";
    if (kind.is_patch) defines += "#define IS_PATCH\n";
    if (kind.has_gloss) defines += "#define HAS_GLOSS\n";
    if (kind.forces_sign) defines += "#define FORCE_SIGN\n";
    if (kind.shading == static_cast<int>(Shading::heat))
        defines += "#define HEAT_ENTRIES " + std::to_string(HeatMap::entry_count) + "\n";
    if (kind.write_depth) defines += "#define WRITE_DEPTH\n";
    if (kind.logarithm_per_vertex) defines += "#define LOGARITHM_PER_VERTEX\n";
    if (kind.clips && kind.source != SurfaceKind::Source::picture)
        defines += capabilities_.clip_distance ? "#define CLIP_DISTANCE\n" : "#define CLIP_BY_DISCARD\n";
    if (kind.source == SurfaceKind::Source::vertices) defines += "#define PER_VERTEX\n";
    if (kind.mask_test) defines += "#define MASK_TEST\n";
    if (kind.mask_write) defines += "#define MASK_WRITE\n";
    const bool from_picture = kind.source == SurfaceKind::Source::picture;
    if (from_picture) defines += "#define FROM_PICTURE\n";
    Result<gl::Program> program = load(from_picture ? "fullscreen.vert" : "surface.vert", "surface.frag", defines);
    if (!program) return Error{program.error()};
    SurfaceProgram& made = surfaces_[kind];
    made.program = std::move(*program);

    struct Location {
        GLint SurfaceProgram::*member;
        const char* name;
    };
    static constexpr Location locations[] = {
        {&SurfaceProgram::clip_from_model, "clip_from_model"},
        {&SurfaceProgram::world_from_model, "world_from_model"},
        {&SurfaceProgram::world_from_normal, "world_from_normal"},
        {&SurfaceProgram::clip_plane_model, "clip_plane_model"},
        {&SurfaceProgram::lights_world, "lights_world"},
        {&SurfaceProgram::light_strength, "light_strength"},
        {&SurfaceProgram::eye_world, "eye_world"},
        {&SurfaceProgram::sky_world, "sky_world"},
        {&SurfaceProgram::base_color, "base_color"},
        {&SurfaceProgram::alpha, "alpha"},
        {&SurfaceProgram::patch_tones, "patch_tones"},
        {&SurfaceProgram::patch_extent, "patch_extent"},
        {&SurfaceProgram::facing_colors, "facing_colors"},
        {&SurfaceProgram::view_z_of_model, "view_z_of_model"},
        {&SurfaceProgram::view_w_of_model, "view_w_of_model"},
        {&SurfaceProgram::depth_levels, "depth_levels"},
        {&SurfaceProgram::logarithmic_range, "logarithmic_range"},
        {&SurfaceProgram::depth_offset, "depth_offset"},
        {&SurfaceProgram::vertex_near_far, "vertex_near_far"},
        {&SurfaceProgram::surface_positions, "surface_positions"},
        {&SurfaceProgram::surface_normals, "surface_normals"},
        {&SurfaceProgram::surface_colors, "surface_colors"},
        {&SurfaceProgram::surface_counts, "surface_counts"},
        {&SurfaceProgram::mask_texture, "mask_texture"},
        {&SurfaceProgram::mask_func, "mask_func"},
        {&SurfaceProgram::mask_reference, "mask_reference"},
        {&SurfaceProgram::mask_read_bits, "mask_read_bits"},
        {&SurfaceProgram::mask_write_bits, "mask_write_bits"},
        {&SurfaceProgram::mask_op, "mask_op"},
        {&SurfaceProgram::caster_w, "caster_w"},
        {&SurfaceProgram::caster_side, "caster_side"},
        {&SurfaceProgram::caster_colors, "caster_colors"},
        {&SurfaceProgram::heat_view_from_world, "heat_view_from_world"},
        {&SurfaceProgram::heat_near_far, "heat_near_far"},
        {&SurfaceProgram::heat_onsets, "heat_onsets"},
        {&SurfaceProgram::heat_colors, "heat_colors"},
        {&SurfaceProgram::heat_gap, "heat_gap"},
    };
    for (const Location& location : locations) made.*location.member = uniform(made.program, location.name);
    return &made;
}

Result<const ShowDepthProgram*> Programs::show_depth() {
    if (show_depth_.program) return &show_depth_;
    const std::string defines = "#define BANDS " + std::to_string(depth_bands.size()) + "\n";
    Result<gl::Program> program = load("fullscreen.vert", "show_depth.frag", defines);
    if (!program) return Error{program.error()};
    show_depth_.mapping = uniform(*program, "mapping");
    show_depth_.linear_scale = uniform(*program, "linear_scale");
    show_depth_.orthographic = uniform(*program, "orthographic");
    show_depth_.near_far = uniform(*program, "near_far");
    show_depth_.shown_first = uniform(*program, "shown_first");
    show_depth_.shown_slope = uniform(*program, "shown_slope");
    show_depth_.shows_bands = uniform(*program, "shows_bands");
    show_depth_.bands = uniform(*program, "bands");
    show_depth_.cleared = uniform(*program, "cleared");
    show_depth_.unwritten_color = uniform(*program, "unwritten_color");
    show_depth_.program = std::move(*program);
    return &show_depth_;
}

Result<const ShowStencilProgram*> Programs::show_stencil() {
    if (show_stencil_.program) return &show_stencil_;
    Result<gl::Program> program = load("fullscreen.vert", "show_stencil.frag");
    if (!program) return Error{program.error()};
    show_stencil_.stencil_colors = uniform(*program, "stencil_colors");
    show_stencil_.program = std::move(*program);
    return &show_stencil_;
}

Result<const ShowOverdrawProgram*> Programs::show_overdraw() {
    if (show_overdraw_.program) return &show_overdraw_;
    Result<gl::Program> program = load("fullscreen.vert", "show_overdraw.frag");
    if (!program) return Error{program.error()};
    show_overdraw_.overdraw_colors = uniform(*program, "overdraw_colors");
    show_overdraw_.program = std::move(*program);
    return &show_overdraw_;
}

Result<const gl::Program*> Programs::show_picture() {
    if (show_picture_) return &show_picture_;
    Result<gl::Program> program = load("fullscreen.vert", "show_picture.frag");
    if (!program) return Error{program.error()};
    show_picture_ = std::move(*program);
    return &show_picture_;
}

Result<const gl::Program*> Programs::read_depth() {
    if (read_depth_) return &read_depth_;
    Result<gl::Program> program = load("fullscreen.vert", "read_depth.frag");
    if (!program) return Error{program.error()};
    read_depth_ = std::move(*program);
    return &read_depth_;
}

Result<const ConstantProgram*> Programs::constant() {
    if (constant_.program) return &constant_;
    Result<gl::Program> program = load("fullscreen.vert", "constant.frag");
    if (!program) return Error{program.error()};
    constant_.value = uniform(*program, "value");
    constant_.program = std::move(*program);
    return &constant_;
}

Result<const FillProgram*> Programs::fill() {
    if (fill_.program) return &fill_;
    Result<gl::Program> program = load("fullscreen.vert", "fill_changed.frag");
    if (!program) return Error{program.error()};
    fill_.previous_mask = uniform(*program, "previous_mask");
    fill_.changed_mask = uniform(*program, "changed_mask");
    fill_.value = uniform(*program, "value");
    fill_.program = std::move(*program);
    return &fill_;
}

}  // namespace viewing
