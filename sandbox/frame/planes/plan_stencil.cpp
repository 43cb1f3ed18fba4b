// Where the stencil lets each pass over a plane draw, and what the pass leaves in it. Read pass_states.h for the
// states.
#include "frame/plan_parts.h"

namespace viewing {

int light_bit(const Params& params, std::size_t light) {
    constexpr int first = stencil_region_bits + 1;
    return params.shadow.own_stencil ? first << light : first;
}

StencilState stencil_of_level(const Level& level) {
    return level.region == 0 ? StencilState{} : inside(level.region);
}

StencilState stencil_of_mask(const Level& level, std::size_t plane) {
    return level.is_real() ? marks(level.region_of(plane)) : enters_from(level.region);
}

StencilState stencil_of_surface(const Level& level, std::size_t plane, bool blends) {
    if (blends && level.params.reflection.stencil) return inside(level.region_of(plane));
    const bool is_receiver = level.is_real() || !level.casting_lights(plane).empty();
    return is_receiver ? stencil_of_mask(level, plane) : stencil_of_level(level);
}

StencilState stencil_of_shadow(const Level& level, std::size_t plane, std::size_t light) {
    const ShadowParams& shadow = level.params.shadow;
    const int region = level.region_of(plane), bit = light_bit(level.params, light);
    const bool clips = shadow.clip_to_receiver || !level.is_real();  // never out of the mirror that shows it
    if (clips) return shadow.stencil_once ? counts_once(region, bit) : inside(region);
    return shadow.stencil_once ? counts_once_anywhere(bit) : StencilState{};
}

}  // namespace viewing
