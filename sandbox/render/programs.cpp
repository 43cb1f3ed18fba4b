#include "render/programs.h"

#include <string>

#include "embedded/shaders.h"
#include "render/shader_constants.h"

namespace viewing {

void ShaderProgram::take(gl::Program program) {
    program_ = std::move(program);
    for (const UniformEntry& entry : uniforms_) *entry.location = glGetUniformLocation(program_.name(), entry.name);
}

Result<gl::Program> Programs::load(const char* vertex, const char* fragment, const std::string& defines) {
    Result<gl::Program> made =
        gl::make_program(embedded_shader(vertex), embedded_shader(fragment), shader_constant_lines() + defines);
    if (!made) return Error{std::string(fragment) + ": " + made.error()};
    return made;
}

Result<const SurfaceProgram*> Programs::surface(const SurfaceKind& kind) {
    if (const auto found = surfaces_.find(kind); found != surfaces_.end()) return &found->second;
    std::string defines = "#define SHADING " + std::to_string(static_cast<int>(kind.shading)) + "\n";
    if (kind.lights > 0) defines += "#define LIGHTS " + std::to_string(kind.lights) + "\n";
    if (kind.is_patch) defines += "#define IS_PATCH\n";
    if (kind.has_gloss) defines += "#define HAS_GLOSS\n";
    if (kind.forces_sign) defines += "#define FORCE_SIGN\n";
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
    made.take(*std::move(program));
    return &made;
}

}  // namespace viewing
