// The parameters of the depth buffer, the depth test and depth fighting. Read params.h for the rest.
#pragma once

#include "geometry/projection.h"

namespace viewing {

enum class CompareFunc { never, less, equal, lequal, greater, notequal, gequal, always };
enum class DepthFormat { d4, d5, d6, d7, d8, d9, d10, d11, d12, d16, d24, d32f };
enum class DecalMethod { offset, equal, stencil };

struct DepthOffset {
    double factor = 0.0, units = 0.0;
    bool operator==(const DepthOffset&) const = default;
};

struct DepthParams {
    bool buffer = true;  ///< off: no depth buffer, as in a window created without GLUT_DEPTH
    bool test = true;
    CompareFunc func = CompareFunc::less;
    bool write = true;
    bool clear = true;
    DepthFormat format = DepthFormat::d24;
    DepthMapping mapping = DepthMapping::standard;
    DepthOffset offset;
    DecalMethod decals = DecalMethod::offset;  ///< keeps objects marked "decal" from fighting with the surface below

    double clear_value = 1.0;  ///< for glClearDepth with standard depth; reversed depth clears to 1 minus this

    // These are correct by default; changing one shows the error that its default prevents.
    bool write_while_clearing = true;  ///< off: glDepthMask(GL_FALSE) while clearing, so depth is not cleared
    bool reversed_zero_to_one = true;  ///< off: reversed depth keeps the clip range −1 … 1
    bool reversed_clear = true;        ///< off: reversed depth is cleared to 1 as if it were standard
    bool reversed_offset = true;       ///< off: with reversed depth, offsets keep their sign and push away from the eye
    bool logarithm_per_vertex = false;

    /// Returns whether depth is compared; otherwise, GL does not write depth either.
    bool tests() const { return buffer && test; }
    bool operator==(const DepthParams&) const = default;
};

/// The pairs of quads in the scene `coplanar`.
struct CoplanarParams {
    double gap = 0.01;      ///< world units, along the normal
    double tilt = 8.0;      ///< degrees by which a pair is rotated out of the image plane
    double distance = 4.0;  ///< eye distance of the nearest pair; the distances of the others scale with it
    bool operator==(const CoplanarParams&) const = default;
};

}  // namespace viewing
