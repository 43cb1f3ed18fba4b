// Programs of one stage each, put together when they are used, so that several may share a vertex stage. Only where
// Capabilities::shared_stages says that it is worth it; elsewhere nothing of this may be called.
#pragma once

#include "gl/objects.h"

namespace viewing::gl {

struct DeletePipeline {
    void operator()(GLuint name) const;
};
using Pipeline = Handle<DeletePipeline>;

/// `defines` as make_program() takes them; AT(n) is where a varying passes from stage to stage, and SEPARATE is
/// defined. The error holds the driver's log.
Result<Program> make_stage(GLenum stage, std::string_view source, std::string_view defines);

/// The stages must outlive it.
Pipeline make_pipeline(const Program& vertex, const Program& fragment);

/// In the place of glUseProgram().
void use(const Pipeline& pipeline);

/// Whose uniforms glUniform*() sets from now on, as long as the pipeline is in use.
void address(const Pipeline& pipeline, GLuint stage);

}  // namespace viewing::gl
