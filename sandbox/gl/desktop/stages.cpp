#include "gl/stages.h"

#include <string>

#include "gl/dialect.h"

namespace viewing::gl {

void DeletePipeline::operator()(GLuint name) const {
    glDeleteProgramPipelines(1, &name);
}

Result<Program> make_stage(GLenum stage, std::string_view source, std::string_view defines) {
    std::string text(shader_opening());
    text += "#extension GL_ARB_separate_shader_objects : require\n#define SEPARATE\n";
    text += "#define AT(place) layout(location = place)\n";
    (text += defines) += source;
    const GLchar* const whole = text.c_str();
    Program program(glCreateShaderProgramv(stage, 1, &whole));
    GLint linked = GL_FALSE;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE) return Error{"a shader does not compile: " + log_of(program)};
    return program;
}

Pipeline make_pipeline(const Program& vertex, const Program& fragment) {
    GLuint name = 0;
    glGenProgramPipelines(1, &name);
    glUseProgramStages(name, GL_VERTEX_SHADER_BIT, vertex.name());
    glUseProgramStages(name, GL_FRAGMENT_SHADER_BIT, fragment.name());
    return Pipeline(name);
}

void use(const Pipeline& pipeline) {
    glUseProgram(0);  // a current program would take precedence over the pipeline
    glBindProgramPipeline(pipeline.name());
}

void address(const Pipeline& pipeline, GLuint stage) {
    glActiveShaderProgram(pipeline.name(), stage);
}

}  // namespace viewing::gl
