// Values of the parameters as a shader's uniforms. The program must be in use.
#pragma once

#include <glm/gtc/type_ptr.hpp>

#include "gl/gl.h"
#include "state/scene_description.h"

namespace viewing {

inline glm::vec3 srgb(const Color& color) {
    return glm::vec3(color.r, color.g, color.b) / 255.0F;
}

inline void set_matrix(GLint location, const glm::dmat4& matrix) {
    const glm::mat4 uploaded(matrix);
    glUniformMatrix4fv(location, 1, GL_FALSE, glm::value_ptr(uploaded));
}

inline void set_vector(GLint location, const glm::vec3& value) {
    glUniform3fv(location, 1, glm::value_ptr(value));
}
inline void set_vector(GLint location, const glm::vec4& value) {
    glUniform4fv(location, 1, glm::value_ptr(value));
}

/// An array of vec3.
template <std::size_t count>
void set_colors(GLint location, const std::array<Color, count>& colors) {
    glm::vec3 uploaded[count];
    for (std::size_t i = 0; i < count; ++i) uploaded[i] = srgb(colors[i]);
    glUniform3fv(location, static_cast<GLsizei>(count), glm::value_ptr(uploaded[0]));
}

}  // namespace viewing
