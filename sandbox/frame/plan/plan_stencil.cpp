// Decides where the stencil lets each pass draw and which values the pass writes to it. See pass_states.h for the
// states.
#include "frame/plan/plan_parts.h"

namespace viewing {
namespace {

/// Returns the bit that marks a light as missing. Each light has its own bit or, without own_stencil, all lights share
/// one and interfere.
int light_bit(const Params& params, std::size_t light) {
    constexpr int first = stencil_region_bits + 1;
    return params.shadow.own_stencil ? first << light : first;
}

}  // namespace

StencilState stencil_of_level(const Level& level) {
    return level.region == 0 ? StencilState{} : inside(level.region);
}

StencilState stencil_of_mask(const Level& level, std::size_t plane) {
    return level.is_real() ? marks(level.region_of(plane)) : enters_from(level.region);
}

StencilState stencil_of_patch(const Level& level, std::size_t plane) {
    return inside(level.region_of(plane));
}

StencilState stencil_of_surface(const Level& level, std::size_t plane, bool blends) {
    if (blends && level.params.reflection.stencil) return stencil_of_patch(level, plane);
    const bool is_receiver = level.is_real() || !level.casting_lights(plane).empty();
    return is_receiver ? stencil_of_mask(level, plane) : stencil_of_level(level);
}

StencilState stencil_of_shadow(const Level& level, std::size_t plane, std::size_t light) {
    const ShadowParams& shadow = level.params.shadow;
    const int region = level.region_of(plane), bit = light_bit(level.params, light);
    if (shadow.style == ShadowStyle::missing_light) return counts_once(region, bit);
    const bool clips = shadow.clip_to_receiver || !level.is_real();  // never outside the mirror that shows it
    if (clips) return shadow.stencil_once ? counts_once(region, bit) : inside(region);
    return shadow.stencil_once ? counts_once_anywhere(bit) : StencilState{};
}

StencilState stencil_of_patch_without(const Level& level, std::size_t plane, std::span<const std::size_t> missing) {
    int value = level.region_of(plane);
    for (const std::size_t light : missing) value |= light_bit(level.params, light);
    return exactly(value);
}

StencilState stencil_of_forgetting_lights(const Level& level, std::size_t plane) {
    return forgets_lights(level.region_of(plane));
}

StencilState stencil_of_leaving(const Level& level, std::size_t plane) {
    return leaves(level.region_of(plane));
}

StencilState stencil_of_objects_beyond(const Pass& mask) {
    return outside(mask.stencil.reference);
}

StencilState stencil_of_decal_bases() {
    return marks(0);
}

StencilState stencil_of_decals() {
    return exactly(0);
}

StencilState stencil_of_wiping() {
    return wipes_marks();
}

}  // namespace viewing
