#include "topics/depth/shown/depth_panel.h"

#include <cmath>

#include "text/catalogue.h"
#include "text/numbers.h"
#include "topics/depth/numbers/decals.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/panel_parts.h"

namespace viewing {
namespace {

void mapping_switches(Params& params) {
    control(params, "depth.reversed_zero_to_one", {.label = marked("Clip range 0 … 1")});
    beside(second_column, widgets::ToggleWidth("Clear to 0"));
    control(params, "depth.reversed_clear", {.label = marked("Clear to 0")});
    control(params, "depth.reversed_offset", {.label = marked("Flip the offset's sign")});
    control(params, "depth.logarithm_per_vertex", {.label = marked("Per vertex")});
}

/// Shows how many depth codes the offset units amount to on this driver, since GL does not define the size of a unit.
/// Draws nothing if the units have no effect or have not been measured.
void offset_note(const Params& params, const Scene& scene, const StoredDepth& stored) {
    if (widgets::IsListing() && !widgets::IsHighlighted("note:offset_unit")) return;
    const DepthParams& depth = params.depth;
    const bool moves = depth.offset.units != 0.0 && depth.decals == DecalMethod::offset && has_decals(scene);
    if (!moves || !stored.unit_codes) return;
    const std::string codes = number_text(std::abs(depth.offset.units * *stored.unit_codes), 4);
    const std::string note = stored.precision.is_float ? say("on this driver: {codes} float steps", "codes"_a = codes)
                                                       : say("on this driver: {codes} codes", "codes"_a = codes);
    if (!named_note("note:offset_unit", note)) return;
    widgets::Tooltip("Offset units",
                     "The number of depth codes that these units amount to on this driver, measured by drawing. For "
                     "one unit, GL requires only the smallest difference that is sure to be resolved; drivers use one, "
                     "two, or four codes. For a float, the step is taken at the polygon's greatest depth.",
                     "offset = factor · slope + units · r");
}

void decal_controls(Params& params, const Scene& scene, const StoredDepth& stored) {
    static constexpr const char* methods[] = {marked("Offset"), "GL_EQUAL", marked("Stencil")};
    if (widgets::IsListed(target_of("depth.decals"))) ImGui::TextUnformatted(tr("Decals via"));
    control(params, "depth.decals", {.segments = true, .names = methods, .label = "##decals", .scene = &scene});
    control(params, "depth.offset.factor", {.label = marked("decal factor"), .scene = &scene});
    control(params, "depth.offset.units", {.label = marked("decal units"), .scene = &scene});
    offset_note(params, scene, stored);
}

void coplanar_controls(Params& params, const Scene& scene) {
    control(params, "coplanar.gap", {.decimals = 4, .slider = true, .min = 0.0, .max = 0.1, .scene = &scene});
    control(params, "coplanar.tilt", {.decimals = 1, .slider = true, .min = 0.0, .max = 60.0, .scene = &scene});
    control(params, "coplanar.distance", {.decimals = 1, .slider = true, .min = 1.0, .max = 40.0, .scene = &scene});
}

}  // namespace

void draw_depth_section(Session& session, const Derived& derived) {
    if (!widgets::Section("Depth buffer", false)) return;
    const widgets::Group group("buffer");
    Params& params = session.params;
    control(params, "depth.buffer", {.label = marked("Window has a buffer")});
    control(params, "depth.format", {.width = 130.0F, .names = depth_format_names});
    control(params, "depth.mapping", {.width = 130.0F, .names = depth_mapping_names});
    mapping_switches(params);
    control(params, "depth.clear_value", {.decimals = 2, .slider = true});
    control(params, "depth.write_while_clearing", {.label = marked("Mask on while clearing")});
    decal_controls(params, session.scene(), derived.stored_depth);
    coplanar_controls(params, session.scene());
    static constexpr const char* scales[] = {marked("Window"), marked("Linear")};
    static constexpr const char* colors[] = {marked("Gray"), marked("Bands")};
    control(params, "view.depth_scale", {.segments = true, .names = scales, .label = "##scale"});
    control(params, "view.depth_colors", {.segments = true, .names = colors, .label = "##colors"});
    control(params, "animation.jiggle", {.label = marked("Jitter the camera")});
}

}  // namespace viewing
