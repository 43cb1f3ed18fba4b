#include "gl/objects.h"

#include <string>

#include "gl/dialect.h"

namespace viewing::gl {
namespace {

struct DeleteShader {
    void operator()(GLuint name) const { glDeleteShader(name); }
};
using Shader = Handle<DeleteShader>;

template <typename Log, typename Get>
std::string log_of(GLuint name, Get get, Log log) {
    GLint length = 0;
    get(name, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(length > 0 ? length : 1), '\0');
    log(name, length, nullptr, text.data());
    while (!text.empty() && (text.back() == '\0' || text.back() == '\n')) text.pop_back();
    return text;
}

Result<Shader> compile(GLenum stage, std::string_view defines, std::string_view source) {
    Shader shader(glCreateShader(stage));
    const std::string_view opening = shader_opening();
    const GLchar* parts[] = {opening.data(), defines.data(), source.data()};
    const GLint lengths[] = {static_cast<GLint>(opening.size()), static_cast<GLint>(defines.size()),
                             static_cast<GLint>(source.size())};
    glShaderSource(shader.name(), 3, parts, lengths);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE)
        return Error{"a shader does not compile: " + log_of(shader.name(), glGetShaderiv, glGetShaderInfoLog)};
    return shader;
}

template <typename Owner, typename Generate>
Owner generated(Generate generate) {
    GLuint name = 0;
    generate(1, &name);
    return Owner(name);
}

}  // namespace

Buffer make_buffer() {
    return generated<Buffer>(glGenBuffers);
}
VertexArray make_vertex_array() {
    return generated<VertexArray>(glGenVertexArrays);
}
Texture make_texture() {
    return generated<Texture>(glGenTextures);
}
Renderbuffer make_renderbuffer() {
    return generated<Renderbuffer>(glGenRenderbuffers);
}
Framebuffer make_framebuffer() {
    return generated<Framebuffer>(glGenFramebuffers);
}

std::string log_of(const Program& program) {
    return log_of(program.name(), glGetProgramiv, glGetProgramInfoLog);
}

Result<Program> make_program(std::string_view vertex_source, std::string_view fragment_source,
                             std::string_view defines) {
    Result<Shader> vertex = compile(GL_VERTEX_SHADER, defines, vertex_source);
    if (!vertex) return Error{vertex.error()};
    Result<Shader> fragment = compile(GL_FRAGMENT_SHADER, defines, fragment_source);
    if (!fragment) return Error{fragment.error()};

    Program program(glCreateProgram());
    glAttachShader(program.name(), vertex->name());
    glAttachShader(program.name(), fragment->name());
    glLinkProgram(program.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) return Error{"a program does not link: " + log_of(program)};
    glDetachShader(program.name(), vertex->name());
    glDetachShader(program.name(), fragment->name());
    return program;
}

Capabilities Capabilities::of_current_context() {
    GLint most_samples = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
    return {.clip_control = has_clip_control(),
            .clip_distance = has_clip_distance(),
            .read_depth_stencil = can_read_depth_stencil(),
            .multisampling = most_samples >= 4,
            .shared_stages = has_shared_stages()};
}

}  // namespace viewing::gl
