// The uniforms of a program as a table: each is one line of the program's struct in programs.h, with type, count and
// name. Location and upload come from that line, and so does the test that holds it against what the driver finds.
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

/// Where a uniform is: location −1 in a program that does not use it. `stage`: 0 in a linked program.
struct UniformPlace {
    GLint location = -1;
    GLuint stage = 0;
};

/// A line of the table. `place` is the uniform's own.
struct UniformEntry {
    const char* name;
    GLenum type;
    GLint count;
    UniformPlace* place;
};

/// A program, linked or of two stages, with its table, which it fills while it is made. It stays where it is: the table
/// points into it.
class ShaderProgram {
public:
    ShaderProgram() = default;
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void take(gl::Program linked);                               ///< and finds the uniforms' places in it
    void take(const gl::Program& vertex, gl::Program fragment);  ///< `vertex` must outlive it
    void use() const { pipeline_ ? gl::use(pipeline_) : glUseProgram(program_.name()); }

    /// What its uniforms are in: the linked program, or its stages.
    std::vector<GLuint> programs() const;
    const std::vector<UniformEntry>& uniforms() const { return uniforms_; }

private:
    template <typename Value, std::size_t count>
    friend class Uniform;

    /// Of uniforms of the program in use.
    void address(const UniformPlace& place) const {
        if (place.stage == 0 || place.stage == addressed_) return;
        gl::address(pipeline_, place.stage);
        addressed_ = place.stage;
    }

    gl::Program program_;  ///< the whole, or the fragment stage
    GLuint vertex_stage_ = 0;
    gl::Pipeline pipeline_;
    mutable GLuint addressed_ = 0;  ///< the stage whose uniforms the pipeline sets
    std::vector<UniformEntry> uniforms_;
};

/// The texture unit of a sampler2D.
struct Sampler {
    GLint unit;
};

/// What GL calls a type of C++, and how its values are uploaded.
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

/// One uniform, or an array of `count`. Setting needs its program in use; where that does not use it, nothing happens.
template <typename Value, std::size_t count = 1>
class Uniform {
public:
    Uniform(ShaderProgram& program, const char* name) : program_(program) {
        program.uniforms_.push_back({name, UniformType<Value>::name, static_cast<GLint>(count), &place_});
    }
    Uniform(const Uniform&) = delete;
    Uniform& operator=(const Uniform&) = delete;

    /// From what converts to it: double becomes float here and nowhere else.
    template <typename From>
    void set(const From& from) const {
        static_assert(count == 1);
        const auto value = static_cast<Value>(from);
        program_.address(place_);
        UniformType<Value>::upload(place_.location, 1, &value);
    }

    /// The first ones of an array.
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
