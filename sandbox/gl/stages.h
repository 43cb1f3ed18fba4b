// Programs with one stage each, combined into pipelines, so that several pipelines can share a vertex stage. Call these
// functions only if Capabilities::shared_stages is true.
#pragma once

#include "gl/objects.h"

namespace viewing::gl {

struct DeletePipeline {
    void operator()(GLuint name) const;
};
using Pipeline = Handle<DeletePipeline>;

/// Compiles one stage. `defines` are as in make_program(). Also defines SEPARATE, and AT(n), the location at which a
/// varying passes from stage to stage. The error contains the driver's log.
Result<Program> make_stage(GLenum stage, std::string_view source, std::string_view defines);

/// The stages must outlive the pipeline.
Pipeline make_pipeline(const Program& vertex, const Program& fragment);

/// Replaces glUseProgram().
void use(const Pipeline& pipeline);

/// Selects the stage whose uniforms glUniform*() sets while the pipeline is in use.
void address(const Pipeline& pipeline, GLuint stage);

}  // namespace viewing::gl
