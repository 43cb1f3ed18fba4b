// The numbers that C++ and GLSL share, generated from enumerations and tables and inserted before every shader, so that
// no shader repeats them. See shaders/surface.frag for their use.
#pragma once

#include <span>
#include <string>

namespace viewing {

struct ShaderConstant {
    const char* name;
    double value;
};
std::span<const ShaderConstant> shader_constants();

/// Returns "#define SHADING_LIT 0" and so on, one definition per line.
const std::string& shader_constant_lines();

}  // namespace viewing
