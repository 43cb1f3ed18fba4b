// The states that passes are made of, by name: what each lets through and what it leaves behind. Which pass has which
// is decided in plan_stencil.cpp.
#pragma once

#include "state/depth_params.h"

namespace viewing {

enum class StencilOp { keep, replace, increment, decrement, invert, zero };

/// The stencil's low four bits tell which patch, or how deep in mirrors; the high ones which light is missing.
inline constexpr int stencil_region_bits = 0x0F, stencil_light_bits = 0xF0;

struct StencilState {
    bool test = false;
    CompareFunc func = CompareFunc::always;
    int reference = 0;
    StencilOp on_pass = StencilOp::keep;  ///< where stencil and depth test pass; elsewhere the value is kept
    int read_bits = 0xFF;                 ///< that are compared: the second mask of glStencilFunc
    int write_bits = 0xFF;                ///< that on_pass may change: glStencilMask
    bool operator==(const StencilState&) const = default;
};

struct DepthState {
    bool test = true;
    CompareFunc func = CompareFunc::less;
    bool write = true;
    bool operator==(const DepthState&) const = default;
};

/// Neither asks depth nor leaves any: what covers a whole picture.
inline constexpr DepthState without_depth{.test = false, .func = CompareFunc::always, .write = false};

/// Marks a patch of the real world, whatever was there: for what stays inside it afterwards.
constexpr StencilState marks(int region) {
    return {.test = true, .reference = region, .on_pass = StencilOp::replace};
}

/// Only inside a region, be it in the light or not: mirror images, the patch over its image, one shadow.
constexpr StencilState inside(int region) {
    return {.test = true, .func = CompareFunc::equal, .reference = region, .read_bits = stencil_region_bits};
}

/// Only off a marked patch: what stands behind a mirror must not show through it.
constexpr StencilState outside(int region) {
    return {.test = true, .func = CompareFunc::notequal, .reference = region};
}

/// Marks a patch that is seen in a mirror, by one more than the mirror's region.
constexpr StencilState enters_from(int region) {
    StencilState state = inside(region);
    state.on_pass = StencilOp::increment;
    return state;
}

/// Takes that one back, so that the next patch in the mirror can have it.
constexpr StencilState leaves(int region) {
    StencilState state = inside(region);
    state.on_pass = StencilOp::decrement;
    return state;
}

/// Draws each pixel of the region once for a light: overlapping casters make one shadow.
constexpr StencilState counts_once(int region, int light_bit) {
    return {.test = true,
            .func = CompareFunc::equal,
            .reference = region,
            .on_pass = StencilOp::invert,
            .read_bits = stencil_region_bits | light_bit,
            .write_bits = light_bit};
}

/// The same without a region: the shadow is one, and goes on beyond its receiver.
constexpr StencilState counts_once_anywhere(int light_bit) {
    return {.test = true,
            .func = CompareFunc::equal,
            .on_pass = StencilOp::invert,
            .read_bits = light_bit,
            .write_bits = light_bit};
}

/// Only where exactly these lights of the region are missing; or exactly this object's mark, for a decal on it.
constexpr StencilState exactly(int value) {
    return {.test = true, .func = CompareFunc::equal, .reference = value};
}

/// Forgets which lights are missing in a region: in a mirror the next patch has the same value.
constexpr StencilState forgets_lights(int region) {
    StencilState state = inside(region);
    state.on_pass = StencilOp::zero;
    state.write_bits = stencil_light_bits;
    return state;
}

/// Leaves no mark anywhere, before marks of another kind.
constexpr StencilState wipes_marks() {
    return {.test = true, .on_pass = StencilOp::zero};
}

}  // namespace viewing
