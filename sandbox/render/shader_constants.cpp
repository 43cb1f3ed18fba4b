#include "render/shader_constants.h"

#include "frame/depth_colors.h"
#include "frame/ground.h"
#include "frame/lighting.h"
#include "frame/plan/plan.h"
#include "render/programs.h"
#include "text/numbers.h"

namespace viewing {
namespace {

template <typename Value>
constexpr ShaderConstant constant(const char* name, Value value) {
    return {name, static_cast<double>(value)};
}

constexpr ShaderConstant constants[] = {
    constant("SHADING_LIT", Shading::lit),
    constant("SHADING_UNLIT", Shading::unlit),
    constant("SHADING_FLAT", Shading::flat),
    constant("SHADING_FACING", Shading::facing),
    constant("SHADING_HEAT", Shading::heat),
    constant("SHADING_CASTER_W", Shading::caster_w),
    constant("SHADING_IDENTITY", Shading::identity),
    constant("SHADING_POLYGON_IDENTITY", Shading::polygon_identity),

    constant("STENCIL_INCREMENT", StencilOp::increment),
    constant("STENCIL_DECREMENT", StencilOp::decrement),
    constant("STENCIL_INVERT", StencilOp::invert),
    constant("STENCIL_ZERO", StencilOp::zero),
    constant("STENCIL_REGION_BITS", stencil_region_bits),
    constant("STENCIL_LIGHT_BITS", stencil_light_bits),

    constant("COMPARE_LESS", CompareFunc::less),
    constant("COMPARE_EQUAL", CompareFunc::equal),
    constant("COMPARE_GREATER", CompareFunc::greater),

    constant("MAPPING_REVERSED", DepthMapping::reversed),
    constant("MAPPING_LOGARITHMIC", DepthMapping::logarithmic),

    constant("AMBIENT_LIGHT", ambient_light),
    constant("SKY_LIGHT", sky_light),
    constant("DIFFUSE_LIGHT", diffuse_light),
    constant("HIGHLIGHT_LIGHT", highlight_light),

    constant("CLIP_PLANES", most_clip_planes),
    constant("PATCH_TONES", patch_tone_count),
    constant("HEAT_ENTRIES", HeatMap::entry_count),
    constant("HEAT_COLORS", heat_colors.size()),
    constant("CASTER_COLORS", caster_colors.size()),
    constant("BANDS", depth_bands.size()),
    constant("STENCIL_COLORS", stencil_colors.size()),
    constant("OVERDRAW_COLORS", overdraw_colors.size()),
};

/// Whether the enumerator's value is the bit set of the relations for which the comparison passes, as surface_mask.glsl
/// assumes.
constexpr bool is_set_of(CompareFunc func, bool less, bool equal, bool greater) {
    return static_cast<int>(func) == (less ? static_cast<int>(CompareFunc::less) : 0) +
                                         (equal ? static_cast<int>(CompareFunc::equal) : 0) +
                                         (greater ? static_cast<int>(CompareFunc::greater) : 0);
}
static_assert(is_set_of(CompareFunc::never, false, false, false) && is_set_of(CompareFunc::lequal, true, true, false) &&
              is_set_of(CompareFunc::notequal, true, false, true) &&
              is_set_of(CompareFunc::gequal, false, true, true) && is_set_of(CompareFunc::always, true, true, true));

}  // namespace

std::span<const ShaderConstant> shader_constants() {
    return constants;
}

const std::string& shader_constant_lines() {
    static const std::string lines = [] {
        std::string made;
        for (const ShaderConstant& each : constants)
            made += std::string("#define ") + each.name + " " + format_number(each.value) + "\n";
        return made;
    }();
    return lines;
}

}  // namespace viewing
