#include "topics/camera/shown/projection_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "text/catalogue.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/links.h"
#include "ui/parts/look.h"
#include "ui/parts/panel_parts.h"

namespace viewing {
namespace {

/// Returns the formula for the width of a depth code under the current projection and mapping. ε is the step between
/// adjacent floats.
const char* depth_step_formula(const Params& params) {
    const bool is_float = precision_of(params.depth.format).is_float;
    if (params.depth.mapping == DepthMapping::logarithmic)
        return is_float ? "Δz = ε(d) z ln(f/n)" : "Δz = z ln(f/n)/(2^b - 1)";
    if (params.projection.is_orthographic()) return is_float ? "Δz = ε(d) (f - n)" : "Δz = (f - n)/(2^b - 1)";
    if (std::isinf(params.projection.far)) return is_float ? "Δz = ε(d) z^2/n" : "Δz = z^2/(n (2^b - 1))";
    return is_float ? "Δz = ε(d) z^2 (f - n)/(f n)" : "Δz = z^2 (f - n)/(f n (2^b - 1))";
}

/// Draws the choice between perspective and orthographic; switching keeps the window.
void type_control(Params& params) {
    ProjectionParams& projection = params.projection;
    const bool has_window = projection.has_window();
    projection.set_type(projection.is_orthographic(), false);
    static constexpr const char* types[] = {marked("Perspective"), marked("Orthographic")};
    const bool changed = control(params, "projection.type", {.segments = true, .names = types, .label = "##type"});
    projection.set_type(projection.is_orthographic(), has_window);
    if (changed && projection.near < least_near(params)) projection.near = default_params().projection.near;
    if (changed) clamp_to_ranges(params);  // an infinite far needs perspective
}

/// Draws the switch for an explicit window, which starts with the edges of the current picture.
void window_control(Params& params, const Derived& derived) {
    if (widgets::IsListing()) return;
    ProjectionParams& projection = params.projection;
    bool has_window = projection.has_window();
    if (widgets::Toggle("explicit window", has_window, false)) {
        Lens lens = params.lens();
        lens.fovy_deg = std::abs(lens.fovy_deg);
        if (has_window) projection.set_window(lens.edges_at(projection.near, derived.aspect));
        projection.set_type(projection.is_orthographic(), has_window);
        clamp_to_ranges(params);
    }
    widgets::Tooltip("Explicit window",
                     "The picture's four edges as glFrustum and glOrtho take them, instead of an angle or a height. "
                     "They start as the edges of the current picture, and need not be centered on the view axis.",
                     "", "glFrustum | glOrtho");
}

/// Draws the switch for an infinite far. Turning it off sets far to its default or to twice near, whichever is greater.
void infinite_control(Params& params) {
    if (widgets::IsListing()) return;
    double& far = params.projection.far;
    bool is_infinite = std::isinf(far);
    ImGui::BeginDisabled(!may_have_infinite_far(params));
    if (widgets::Toggle("infinite z-far", is_infinite, false)) {
        const double usual = std::max(default_params().projection.far, 2.0 * params.projection.near);
        far = is_infinite ? std::numeric_limits<double>::infinity() : usual;
    }
    ImGui::EndDisabled();
    widgets::Tooltip("Infinite far",
                     "Nothing is too far away: f/(f − n) becomes 1, and P stays invertible. Depth precision is almost "
                     "the same, because near determines it. Only for perspective and a frustum, not for logarithmic "
                     "depth.",
                     "d = 1 - n/z; reversed: d = n/z", "glm::infinitePerspective");
}

/// Draws the controls for the window's edges; each edge stops short of the opposite one.
void edge_controls(Params& params) {
    const double reach = params.projection.is_orthographic() ? 20.0 : 2.0 * std::max(params.projection.near, 0.01);
    static constexpr widgets::Links x[] = {link::window_x}, y[] = {link::window_y};
    const auto edge = [&](const char* path, std::span<const widgets::Links> links) {
        return control(params, path, {.decimals = 3, .slider = true, .links = links, .min = -reach, .max = reach});
    };
    ProjectionParams& projection = params.projection;
    const double gap = 1e-3 * reach;
    if (edge("projection.left", x)) projection.left = std::min(projection.left, projection.right - gap);
    if (edge("projection.right", x)) projection.right = std::max(projection.right, projection.left + gap);
    if (edge("projection.bottom", y)) projection.bottom = std::min(projection.bottom, projection.top - gap);
    if (edge("projection.top", y)) projection.top = std::max(projection.top, projection.bottom + gap);
}

}  // namespace

void draw_projection_section(Session& session, const Derived& derived, const std::vector<Problem>& problems) {
    if (!section("Projection", problems, {"projection"})) return;
    const widgets::Group group("projection");
    Params& params = session.params;
    ProjectionParams& projection = params.projection;
    type_control(params);
    static constexpr widgets::Links fovy[] = {link::fovy}, height[] = {link::height}, near[] = {link::near},
                                    far[] = {link::far};
    if (projection.has_window())
        edge_controls(params);
    else if (!projection.is_orthographic())
        control(params, "projection.fovy", {.decimals = 1, .slider = true, .links = fovy});
    else
        control(params, "projection.height", {.slider = true, .links = height, .min = 0.1, .max = 100.0});
    // Near and far stop just short of each other, so that near < far holds while either one is dragged.
    const double least = least_near(params);  // a slider over negative numbers is linear
    if (control(params, "projection.near",
                {.decimals = 3, .slider = true, .links = near, .min = least > 0.0 ? 0.001 : -100.0, .max = 100.0}))
        projection.near =
            std::clamp(projection.near, least, std::min(projection.far * 0.999, field("projection.near").max));
    if (control(params, "projection.far", {.decimals = 1, .slider = true, .links = far, .min = 1.0, .max = 10000.0}))
        projection.far = std::max(projection.far, projection.near * 1.001);

    static constexpr const char* lens[] = {"control:projection.aspect", "control:slips.degrees_as_radians"};
    if (details("Window, far, aspect, radians", lens)) {
        window_control(params, derived);
        infinite_control(params);
        control(params, "projection.aspect",
                {.slider = true, .label = marked("aspect (0: from view)"), .min = 0.0, .max = 4.0});
        control(params, "slips.degrees_as_radians", {.label = marked("degrees given as radians")});
    }

    if (widgets::IsListing() && !widgets::IsHighlighted("note:depth_step")) return;
    const DepthPrecision precision = precision_of(params.depth.format);
    const std::string z = number_text(derived.facts.target_distance, 2),
                      step = number_text(derived.facts.resolvable_step_at_target, 2);
    const std::string note = precision.is_float ? say("{bits}-bit float depth: Δz at z = {z} is {step}",
                                                      "bits"_a = precision.bits, "z"_a = z, "step"_a = step)
                                                : say("{bits}-bit depth: Δz at z = {z} is {step}",
                                                      "bits"_a = precision.bits, "z"_a = z, "step"_a = step);
    if (!named_note("note:depth_step", note)) return;
    widgets::Tooltip("Depth resolution",
                     "The smallest difference in eye z that the depth buffer can distinguish at the camera's target: "
                     "the code width or, where float codes are finer, the float32 precision of eye z itself. Two "
                     "surfaces with a smaller gap between them may show depth fighting.",
                     depth_step_formula(params));
}

}  // namespace viewing
