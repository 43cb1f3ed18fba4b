#include "gl/debug.h"

#include "gl/dialect.h"
#include "gl/gl.h"

namespace viewing::gl {
namespace {

void GLAPIENTRY receive(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* message,
                        const void* log) {
    const bool is_error = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR;
    if (!is_error && severity != GL_DEBUG_SEVERITY_HIGH) return;
    const std::string text(message, length >= 0 ? static_cast<std::size_t>(length) : std::string(message).size());
    static_cast<DebugLog*>(const_cast<void*>(log))->add(text);
}

}  // namespace

DebugLog::DebugLog() {
    if (!has_debug_output()) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(receive, this);
    has_callback_ = true;
}

const std::vector<std::string>& DebugLog::errors() {
    if (!has_callback_)
        for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
            errors_.push_back("GL error " + std::to_string(error));
    return errors_;
}

}  // namespace viewing::gl
