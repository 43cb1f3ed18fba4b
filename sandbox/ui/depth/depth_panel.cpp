#include "ui/depth/depth_panel.h"

#include "frame/depth/decals.h"
#include "ui/parts/controls.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

constexpr const char* format_names[] = {"4 bit",  "5 bit",  "6 bit",  "7 bit",  "8 bit",  "9 bit",
                                        "10 bit", "11 bit", "12 bit", "16 bit", "24 bit", "32 bit float"};

void mapping_switches(Params& params) {
    if (params.depth.mapping == DepthMapping::reversed) {
        control(params, "depth.reversed_zero_to_one", {.label = "Clip range 0 … 1"});
        control(params, "depth.reversed_clear", {.label = "Clear to 0"});
        control(params, "depth.reversed_offset", {.label = "Turn the offset's sign"});
    } else if (params.depth.mapping == DepthMapping::logarithmic) {
        control(params, "depth.logarithm_per_vertex", {.label = "Per vertex"});
    }
}

void decal_controls(Params& params) {
    static constexpr const char* methods[] = {"Offset", "GL_EQUAL", "Stencil"};
    ImGui::TextUnformatted("Decals by");
    control(params, "depth.decals", {.segments = true, .names = methods, .label = "##decals"});
    if (params.depth.decals != DecalMethod::offset) return;
    control(params, "depth.offset.factor", {.label = "decal factor"});
    control(params, "depth.offset.units", {.label = "decal units"});
}

void coplanar_controls(Params& params) {
    control(params, "coplanar.gap", {.decimals = 4, .slider = true, .min = 0.0, .max = 0.1});
    control(params, "coplanar.tilt", {.decimals = 1, .slider = true, .min = 0.0, .max = 60.0});
    control(params, "coplanar.distance", {.decimals = 1, .slider = true, .min = 1.0, .max = 40.0});
}

void beside_controls(Params& params) {
    static constexpr const char* pictures[] = {"nothing", "the depth buffer", "another depth"};
    static constexpr const char* layouts[] = {"Two halves", "Divider"};
    control(params, "view.beside.shows", {.width = 150.0F, .names = pictures, .label = "beside it"});
    if (params.view.beside.shows == Beside::nothing) return;
    control(params, "view.beside.layout", {.segments = true, .names = layouts, .label = "##layout"});
    if (params.view.beside.shows != Beside::other_depth) return;
    control(params, "view.beside.format", {.width = 130.0F, .names = format_names, .label = "other format"});
    control(params, "view.beside.mapping", {.width = 130.0F, .label = "other mapping"});
}

}  // namespace

void draw_depth_section(Session& session) {
    if (!widgets::Section("Depth buffer", false)) return;
    const widgets::Group group("buffer");
    Params& params = session.params;
    control(params, "depth.format", {.width = 130.0F, .names = format_names});
    control(params, "depth.mapping", {.width = 130.0F});
    mapping_switches(params);
    control(params, "depth.write_while_clearing", {.label = "Mask on while clearing"});
    if (has_decals(session.scene())) decal_controls(params);
    if (session.scene().made_from) coplanar_controls(params);
    static constexpr const char* scales[] = {"Window", "Linear"};
    static constexpr const char* colors[] = {"Grey", "Bands"};
    control(params, "view.depth_scale", {.segments = true, .names = scales, .label = "##scale"});
    control(params, "view.depth_colors", {.segments = true, .names = colors, .label = "##colors"});
    beside_controls(params);
    control(params, "animation.jiggle", {.label = "Jiggle the camera"});
}

}  // namespace viewing
