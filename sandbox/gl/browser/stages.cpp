// WebGL 2 has no separable programs: make_stage() fails, and the other functions do nothing.
#include "gl/stages.h"

namespace viewing::gl {

void DeletePipeline::operator()(GLuint /*name*/) const {}

Result<Program> make_stage(GLenum /*stage*/, std::string_view /*source*/, std::string_view /*defines*/) {
    return Error{"this GL dialect has no separable programs"};
}

Pipeline make_pipeline(const Program& /*vertex*/, const Program& /*fragment*/) {
    return {};
}

void use(const Pipeline& /*pipeline*/) {}

void address(const Pipeline& /*pipeline*/, GLuint /*stage*/) {}

}  // namespace viewing::gl
