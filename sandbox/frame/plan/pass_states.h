// Named states for passes: which fragments pass and which values they write. plan_stencil.cpp decides which pass has
// which state.
#pragma once

#include "state/depth_params.h"

namespace viewing {

enum class StencilOp { keep, replace, increment, decrement, invert, zero };

/// The stencil's low four bits identify the patch, or the mirror depth; the high four mark missing lights.
inline constexpr int stencil_region_bits = 0x0F, stencil_light_bits = 0xF0;

struct StencilState {
    bool test = false;
    CompareFunc func = CompareFunc::always;
    int reference = 0;
    StencilOp on_pass = StencilOp::keep;  ///< if the stencil and depth tests pass; otherwise the value is kept
    int read_bits = 0xFF;                 ///< bits to compare: the mask of glStencilFunc
    int write_bits = 0xFF;                ///< bits that on_pass may change: glStencilMask
    bool operator==(const StencilState&) const = default;
};

struct DepthState {
    bool test = true;
    CompareFunc func = CompareFunc::less;
    bool write = true;
    bool operator==(const DepthState&) const = default;
};

/// Neither tests nor writes depth: for passes that cover the whole picture.
inline constexpr DepthState without_depth{.test = false, .func = CompareFunc::always, .write = false};

/// Marks a patch of the real world, whatever the stencil contains, so that later passes can stay inside it.
constexpr StencilState marks(int region) {
    return {.test = true, .reference = region, .on_pass = StencilOp::replace};
}

/// Passes only inside a region, whether or not lights are missing there. Used for mirror images, the patch over its
/// image, and shadows whose overlaps are not counted.
constexpr StencilState inside(int region) {
    return {.test = true, .func = CompareFunc::equal, .reference = region, .read_bits = stencil_region_bits};
}

/// Passes only outside a marked patch: objects behind a mirror must not show through it.
constexpr StencilState outside(int region) {
    return {.test = true, .func = CompareFunc::notequal, .reference = region};
}

/// Marks a patch seen in a mirror with the mirror's region value plus one.
constexpr StencilState enters_from(int region) {
    StencilState state = inside(region);
    state.on_pass = StencilOp::increment;
    return state;
}

/// Undoes enters_from(), so that the next patch in the mirror can use the value.
constexpr StencilState leaves(int region) {
    StencilState state = inside(region);
    state.on_pass = StencilOp::decrement;
    return state;
}

/// Draws each pixel of the region once per light, so that overlapping casters make one shadow.
constexpr StencilState counts_once(int region, int light_bit) {
    return {.test = true,
            .func = CompareFunc::equal,
            .reference = region,
            .on_pass = StencilOp::invert,
            .read_bits = stencil_region_bits | light_bit,
            .write_bits = light_bit};
}

/// Draws each pixel once per light, in any region: overlapping casters still make one shadow, but the shadow extends
/// beyond its receiver.
constexpr StencilState counts_once_anywhere(int light_bit) {
    return {.test = true,
            .func = CompareFunc::equal,
            .on_pass = StencilOp::invert,
            .read_bits = light_bit,
            .write_bits = light_bit};
}

/// Passes only where the stencil holds exactly `value`: a region with the bits of its missing lights or, for a decal,
/// its object's mark.
constexpr StencilState exactly(int value) {
    return {.test = true, .func = CompareFunc::equal, .reference = value};
}

/// Clears the marks of missing lights in a region, because the next patch in the mirror uses the same region value.
constexpr StencilState forgets_lights(int region) {
    StencilState state = inside(region);
    state.on_pass = StencilOp::zero;
    state.write_bits = stencil_light_bits;
    return state;
}

/// Clears all marks, before marks of another kind are set.
constexpr StencilState wipes_marks() {
    return {.test = true, .on_pass = StencilOp::zero};
}

}  // namespace viewing
