#include "render/programs.h"

#include <string>

#include "embedded/shaders.h"
#include "render/shader_constants.h"

namespace viewing {
namespace {

/// Returns a shader's text; for surface.frag, with its parts in the order in which they use each other.
std::string source_of(std::string_view shader) {
    if (shader != "surface.frag") return std::string(embedded_shader(shader));
    std::string all;
    for (const char* part : {"surface_point.glsl", "surface_light.glsl", "surface_heat.glsl", "surface_depth.glsl",
                             "surface_mask.glsl", "surface.frag"})
        all += embedded_shader(part);
    return all;
}

}  // namespace

void ShaderProgram::take(gl::Program linked) {
    program_ = std::move(linked);
    for (const UniformEntry& entry : uniforms_)
        entry.place->location = glGetUniformLocation(program_.name(), entry.name);
}

void ShaderProgram::take(const gl::Program& vertex, gl::Program fragment) {
    program_ = std::move(fragment);
    vertex_stage_ = vertex.name();
    pipeline_ = gl::make_pipeline(vertex, program_);
    for (const UniformEntry& entry : uniforms_)
        for (const GLuint stage : programs())
            if (const GLint location = glGetUniformLocation(stage, entry.name); location >= 0)
                *entry.place = {location, stage};
    addressed_ = program_.name();
    gl::address(pipeline_, addressed_);
}

std::vector<GLuint> ShaderProgram::programs() const {
    if (vertex_stage_ == 0) return {program_.name()};
    return {vertex_stage_, program_.name()};
}

Result<gl::Program> Programs::load(const char* vertex, const char* fragment, const std::string& defines) {
    Result<gl::Program> made = gl::make_program(source_of(vertex), source_of(fragment),
                                                "#define AT(place)\n" + shader_constant_lines() + defines);
    if (!made) return Error{std::string(fragment) + ": " + made.error()};
    return made;
}

Result<const gl::Program*> Programs::vertex_stage(const std::string& defines) {
    if (const auto found = vertex_stages_.find(defines); found != vertex_stages_.end()) return &found->second;
    Result<gl::Program> made =
        gl::make_stage(GL_VERTEX_SHADER, embedded_shader("surface.vert"), shader_constant_lines() + defines);
    if (!made) return Error{"surface.vert: " + made.error()};
    return &vertex_stages_.emplace(defines, *std::move(made)).first->second;
}

Result<const SurfaceProgram*> Programs::surface(const SurfaceKind& kind) {
    if (const auto found = surfaces_.find(kind); found != surfaces_.end()) return &found->second;
    const bool from_picture = kind.source == SurfaceKind::Source::picture;
    std::string of_both;
    if (kind.forces_sign) of_both += "#define FORCE_SIGN\n";
    if (kind.write_depth) of_both += "#define WRITE_DEPTH\n";
    if (kind.logarithm_per_vertex) of_both += "#define LOGARITHM_PER_VERTEX\n";
    if (kind.clips && !from_picture)
        of_both += capabilities_.clip_distance ? "#define CLIP_DISTANCE\n" : "#define CLIP_BY_DISCARD\n";
    if (kind.source == SurfaceKind::Source::vertices) of_both += "#define PER_VERTEX\n";

    std::string defines = of_both + "#define SHADING " + std::to_string(static_cast<int>(kind.shading)) + "\n";
    if (kind.lights > 0) defines += "#define LIGHTS " + std::to_string(kind.lights) + "\n";
    if (kind.is_patch) defines += "#define IS_PATCH\n";
    if (kind.has_gloss) defines += "#define HAS_GLOSS\n";
    if (kind.mask_test) defines += "#define MASK_TEST\n";
    if (kind.mask_write) defines += "#define MASK_WRITE\n";
    if (kind.depth_of_plane) defines += "#define DEPTH_OF_PLANE\n";
    if (from_picture) defines += "#define FROM_PICTURE\n";

    if (from_picture || !capabilities_.shared_stages) {
        Result<gl::Program> program = load(from_picture ? "fullscreen.vert" : "surface.vert", "surface.frag", defines);
        if (!program) return Error{program.error()};
        SurfaceProgram& made = surfaces_[kind];
        made.take(*std::move(program));
        return &made;
    }
    const Result<const gl::Program*> vertex = vertex_stage(of_both);
    if (!vertex) return Error{vertex.error()};
    Result<gl::Program> fragment =
        gl::make_stage(GL_FRAGMENT_SHADER, source_of("surface.frag"), shader_constant_lines() + defines);
    if (!fragment) return Error{"surface.frag: " + fragment.error()};
    SurfaceProgram& made = surfaces_[kind];
    made.take(**vertex, *std::move(fragment));
    return &made;
}

}  // namespace viewing
