#include "gl/facts.h"

#include "gl/dialect.h"
#include "gl/gl.h"

namespace viewing::gl {
namespace {

std::string gl_string(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

}  // namespace

ContextFacts context_facts() {
    return {gl_string(GL_VERSION), gl_string(GL_RENDERER), gl_string(GL_VENDOR), gl_string(GL_SHADING_LANGUAGE_VERSION),
            has_debug_output()};
}

}  // namespace viewing::gl
