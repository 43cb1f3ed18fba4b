// The uniforms of a program as a table: each is one line of the program's struct in programs.h, with type, count and
// name. That line determines how the uniform is found and uploaded; a test compares it with the uniforms that the
// driver reports.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>
#include <span>
#include <vector>

#include "gl/objects.h"
#include "gl/stages.h"
#include "state/scene_description.h"

namespace viewing {

/// The location of a uniform; −1 if the program does not use it. `stage` is 0 in a linked program.
struct UniformPlace {
    GLint location = -1;
    GLuint stage = 0;
};

/// A row of the table. `place` points to a member of the uniform.
struct UniformEntry {
    const char* name;
    GLenum type;
    GLint count;
    UniformPlace* place;
};

/// A program, either linked or made of two stages, with the table of its uniforms, which is filled during construction.
/// The object must not move, because the table points into it.
class ShaderProgram {
public:
    ShaderProgram() = default;
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void take(gl::Program linked);                               ///< also finds the locations of the uniforms
    void take(const gl::Program& vertex, gl::Program fragment);  ///< `vertex` must outlive this object
    void use() const { pipeline_ ? gl::use(pipeline_) : glUseProgram(program_.name()); }

    /// Returns the GL programs that contain the uniforms: the linked program, or the two stages.
    std::vector<GLuint> programs() const;
    const std::vector<UniformEntry>& uniforms() const { return uniforms_; }

private:
    template <typename Value, std::size_t count>
    friend class Uniform;

    /// Makes glUniform*() set the uniforms of the stage in `place`; the program must be current.
    void address(const UniformPlace& place) const {
        if (place.stage == 0 || place.stage == addressed_) return;
        gl::address(pipeline_, place.stage);
        addressed_ = place.stage;
    }

    gl::Program program_;  ///< the linked program, or the fragment stage
    GLuint vertex_stage_ = 0;
    gl::Pipeline pipeline_;
    mutable GLuint addressed_ = 0;  ///< the stage whose uniforms the pipeline sets
    std::vector<UniformEntry> uniforms_;
};

/// The texture unit of a sampler2D.
struct Sampler {
    GLint unit;
};

/// GL's type for a C++ type, and a function that uploads its values.
template <typename Value>
struct UniformType;
template <>
struct UniformType<float> {
    static constexpr GLenum name = GL_FLOAT;
    static void upload(GLint at, GLsizei count, const float* values) { glUniform1fv(at, count, values); }
};
template <>
struct UniformType<glm::vec2> {
    static constexpr GLenum name = GL_FLOAT_VEC2;
    static void upload(GLint at, GLsizei count, const glm::vec2* values) {
        glUniform2fv(at, count, glm::value_ptr(*values));
    }
};
template <>
struct UniformType<glm::vec3> {
    static constexpr GLenum name = GL_FLOAT_VEC3;
    static void upload(GLint at, GLsizei count, const glm::vec3* values) {
        glUniform3fv(at, count, glm::value_ptr(*values));
    }
};
template <>
struct UniformType<glm::vec4> {
    static constexpr GLenum name = GL_FLOAT_VEC4;
    static void upload(GLint at, GLsizei count, const glm::vec4* values) {
        glUniform4fv(at, count, glm::value_ptr(*values));
    }
};
template <>
struct UniformType<glm::mat3> {
    static constexpr GLenum name = GL_FLOAT_MAT3;
    static void upload(GLint at, GLsizei count, const glm::mat3* values) {
        glUniformMatrix3fv(at, count, GL_FALSE, glm::value_ptr(*values));
    }
};
template <>
struct UniformType<glm::mat4> {
    static constexpr GLenum name = GL_FLOAT_MAT4;
    static void upload(GLint at, GLsizei count, const glm::mat4* values) {
        glUniformMatrix4fv(at, count, GL_FALSE, glm::value_ptr(*values));
    }
};
template <>
struct UniformType<int> {
    static constexpr GLenum name = GL_INT;
    static void upload(GLint at, GLsizei count, const int* values) { glUniform1iv(at, count, values); }
};
template <>
struct UniformType<bool> {
    static constexpr GLenum name = GL_BOOL;
    static void upload(GLint at, GLsizei, const bool* value) { glUniform1i(at, *value ? 1 : 0); }
};
template <>
struct UniformType<Sampler> {
    static constexpr GLenum name = GL_SAMPLER_2D;
    static void upload(GLint at, GLsizei, const Sampler* sampler) { glUniform1i(at, sampler->unit); }
};

/// A uniform: one value, or an array of `count` values. Its program must be current when it is set; if the program does
/// not use the uniform, setting it does nothing.
template <typename Value, std::size_t count = 1>
class Uniform {
public:
    Uniform(ShaderProgram& program, const char* name) : program_(program) {
        program.uniforms_.push_back({name, UniformType<Value>::name, static_cast<GLint>(count), &place_});
    }
    Uniform(const Uniform&) = delete;
    Uniform& operator=(const Uniform&) = delete;

    /// Converts `from` to the uniform's type and sets it. This is the only place where double becomes float.
    template <typename From>
    void set(const From& from) const {
        static_assert(count == 1);
        const auto value = static_cast<Value>(from);
        program_.address(place_);
        UniformType<Value>::upload(place_.location, 1, &value);
    }

    /// Sets the first elements of an array.
    void set_first(std::span<const Value> values) const {
        assert(values.size() <= count);
        program_.address(place_);
        if (!values.empty())
            UniformType<Value>::upload(place_.location, static_cast<GLsizei>(values.size()), values.data());
    }

private:
    const ShaderProgram& program_;
    UniformPlace place_;
};

inline glm::vec3 srgb(const Color& color) {
    return glm::vec3(color.r, color.g, color.b) / 255.0F;
}

template <std::size_t count>
std::array<glm::vec3, count> srgb(const std::array<Color, count>& colors) {
    std::array<glm::vec3, count> made;
    std::transform(colors.begin(), colors.end(), made.begin(), [](const Color& color) { return srgb(color); });
    return made;
}

}  // namespace viewing
