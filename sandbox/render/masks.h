// Stencil tests for targets without a stencil (gl/stencil_mask.h): the fragment shader compares with the mask and
// writes it beside the colour. What stencil does to overlapping triangles of one pass, where the first one decides,
// is done in two strokes: the pass changes the mask, and then its one colour fills the pixels that have changed.
#pragma once

#include "frame/plan.h"
#include "gl/target.h"
#include "render/present.h"
#include "render/programs.h"

namespace viewing {

/// What becomes of a pass's stencil test in a target. All false where the target has a stencil, or samples: in a frame
/// with samples no 16-bit pass tests it (plan()).
struct MaskUse {
    bool tests = false;   ///< fragments are discarded where the comparison fails
    bool writes = false;  ///< the mask becomes what stencil's value would become
    bool fills = false;   ///< its colour comes afterwards, from fill_changed()
};
MaskUse mask_use(const Pass& pass, const gl::Target& target);

/// After apply_state(): binds the framebuffer for the pass, and the mask that it is compared with.
void begin_mask(const Pass& pass, const MaskUse& use, const gl::Target& target);

/// What the stencil would do, for a program in use that may test or write the mask.
void set_mask(const SurfaceProgram& program, const StencilState& stencil, int reference);

/// Lays the pass's flat colour over the pixels whose mask it has changed.
void fill_changed(const Pass& pass, const gl::Target& target, const FillProgram& program, const Fullscreen& fullscreen,
                  const gl::Capabilities& capabilities);

}  // namespace viewing
