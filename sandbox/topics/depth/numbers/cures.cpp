#include "topics/depth/numbers/cures.h"

#include "topics/depth/numbers/decals.h"
#include "topics/depth/numbers/near_advice.h"

namespace viewing {
namespace {

Cure near_for_what_is_seen(const Params& params, const Derived& derived, const Scene& scene) {
    Cure cure{CureKind::near, {}, {}, params};
    const std::vector<SeenThing> seen = seen_things(params, derived, scene);
    cure.params.projection.move_near(largest_near(seen).value_or(params.projection.near));
    cure.name = message("near {near}", "near"_a = figures(cure.params.projection.near, 3));
    cure.explanation = message(
        "The near plane, moved as far away as the view allows: to nine tenths of the nearest visible distance.");
    return cure;
}

Cure with_mapping(const Params& params, CureKind kind, DepthMapping mapping, DepthFormat format, Message name,
                  Message explanation) {
    Cure cure{kind, std::move(name), std::move(explanation), params};
    DepthParams& depth = cure.params.depth;
    depth.mapping = mapping;
    depth.format = format;
    depth.clear_value = 1.0;
    depth.reversed_zero_to_one = depth.reversed_clear = depth.reversed_offset = true;
    depth.logarithm_per_vertex = false;
    return cure;
}

Cure for_decals(const Params& params, CureKind kind, DecalMethod method, Message name, Message explanation) {
    Cure cure{kind, std::move(name), std::move(explanation), params};
    cure.params.depth.decals = method;
    if (method == DecalMethod::offset) {
        cure.params.depth.offset = {-1.0, -1.0};
        cure.params.depth.reversed_offset = true;
    }
    return cure;
}

}  // namespace

std::vector<Cure> cures(const Params& params, const Derived& derived, const Scene& scene) {
    const DepthFormat format = params.depth.format == DepthFormat::d32f ? DepthFormat::d24 : params.depth.format;
    std::vector<Cure> all{
        near_for_what_is_seen(params, derived, scene),
        with_mapping(
            params, CureKind::float_format, DepthMapping::standard, DepthFormat::d32f, message("float"),
            message("Standard depth as a 32-bit float. It is finest near 0, at the near plane; near 1, where most "
                    "visible surfaces lie, it is no finer than 24 bits.")),
        with_mapping(
            params, CureKind::reversed_float, DepthMapping::reversed, DepthFormat::d32f, message("reversed"),
            message("Reversed depth as a 32-bit float, clip range 0 … 1: the finest steps, those near 0, fall on "
                    "large distances.")),
        with_mapping(params, CureKind::logarithmic, DepthMapping::logarithmic, format, message("log"),
                     message("Logarithmic depth: the same number of codes for each tenfold increase in distance.")),
    };
    if (!has_decals(scene)) return all;
    all.push_back(for_decals(params, CureKind::offset, DecalMethod::offset, message("offset"),
                             message("glPolygonOffset(−1, −1) for the surface on top.")));
    all.push_back(
        for_decals(params, CureKind::equal, DecalMethod::equal, "GL_EQUAL",
                   message("The surface on top is drawn last, where its depth equals that of the surface below: "
                           "this works only for identical triangles without a gap.")));
    all.push_back(
        for_decals(params, CureKind::stencil, DecalMethod::stencil, message("stencil"),
                   message("The surface below marks its pixels; the one on top is drawn only there, without a "
                           "depth test, so any part that sticks out is lost.")));
    return all;
}

}  // namespace viewing
