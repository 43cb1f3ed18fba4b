// Stencil tests for targets without a stencil buffer (gl/stencil_mask.h): the fragment shader tests against the mask
// and writes the mask together with the color. With a stencil buffer, the first of several overlapping triangles in a
// pass excludes the others. With a mask, this takes two steps: the pass changes only the mask, and then its single
// color fills the pixels whose mask has changed.
#pragma once

#include "frame/plan/plan.h"
#include "gl/target.h"
#include "render/present.h"
#include "render/programs.h"

namespace viewing {

/// How a pass emulates its stencil test in a target. All fields are false if the target has a stencil or multisampling:
/// plan() never lets a pass test the stencil in a multisampled 16-bit frame.
struct MaskUse {
    bool tests = false;   ///< fragments are discarded if the comparison fails
    bool writes = false;  ///< fragments write to the mask what the stencil would get
    bool fills = false;   ///< fill_changed() draws the color afterward
};
MaskUse mask_use(const Pass& pass, const gl::Target& target);

/// Binds the framebuffer for the pass, and the mask to compare with. Call after apply_state().
void begin_mask(const Pass& pass, const MaskUse& use, const gl::Target& target);

/// Sets the stencil test that the shader emulates. `program` must be current; a program that does not use the mask is
/// left unchanged.
void set_mask(const SurfaceProgram& program, const StencilState& stencil, int reference);

/// Draws the pass's single color over the pixels whose mask it has changed.
void fill_changed(const Pass& pass, const gl::Target& target, const FillProgram& program, const Fullscreen& fullscreen,
                  const gl::Capabilities& capabilities);

}  // namespace viewing
