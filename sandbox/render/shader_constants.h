// The numbers that C++ and GLSL share, written from the enumerations and tables in front of every shader: none of them
// is typed in a shader. Read shaders/surface.frag for their use.
#pragma once

#include <span>
#include <string>

namespace viewing {

struct ShaderConstant {
    const char* name;
    int value;
};
std::span<const ShaderConstant> shader_constants();

/// "#define SHADING_LIT 0" and so on, a line each.
const std::string& shader_constant_lines();

}  // namespace viewing
