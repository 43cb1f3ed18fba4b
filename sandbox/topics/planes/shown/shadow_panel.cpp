#include "topics/planes/shown/shadow_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "frame/effect.h"
#include "state/lists.h"
#include "text/catalogue.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/links.h"
#include "ui/parts/panel_parts.h"

namespace viewing {
namespace {

/// Returns a light at a new position. If possible, this is the first light's position with x, z or both negated;
/// otherwise it is some distance from the first light along x.
LightParams another_light(const Params& params) {
    const glm::dvec4& first = params.lights.front().position;
    const glm::dvec4 places[] = {{-first.x, first.y, first.z, first.w},
                                 {first.x, first.y, -first.z, first.w},
                                 {-first.x, first.y, -first.z, first.w}};
    for (const glm::dvec4& place : places)
        if (std::none_of(params.lights.begin(), params.lights.end(),
                         [&](const LightParams& light) { return light.position == place; }))
            return {place};
    return {first + glm::dvec4(2.0 * static_cast<double>(params.lights.size()), 0.0, 0.0, 0.0)};
}

/// Draws the controls of a light. Only the chosen light's controls are linked to matrix entries.
void light_controls(Params& params, std::size_t index, const char* label) {
    std::span<const widgets::Links> links;
    if (index == params.chosen().light) links = link::light;
    const Field& position = field("light.position");
    if (!widgets::IsListed(target_of(position.path))) return;
    if (index == 0 && is_covered(position, label)) return;
    const widgets::TargetScope scope(index == 0 ? target_of(position.path) : std::string());
    widgets::Light(label, params.lights[index].position, default_params().lights.front().position, links);
    if (index == 0) widgets::MarkTarget(target_of(position.path));
}

void further_lights(Params& params) {
    if (widgets::IsListing()) return;
    for (std::size_t index = 1; index < params.lights.size(); ++index) {
        const std::size_t number = index + 1;
        const std::string id = std::to_string(number);
        const std::string label = say("light {number}", "number"_a = number) + "###light " + id;
        light_controls(params, index, label.c_str());
        explain(field("lights"), label);
        const std::string remove = say("Remove light {number}", "number"_a = number) + "###remove light " + id;
        if (widgets::SmallButton(remove.c_str())) return remove_light(params, index);
    }
    const bool has_room = params.lights.size() < most_lights;
    if (widgets::SmallButton("Add a light", has_room, "The stencil has bits for at most four lights."))
        params.lights.push_back(another_light(params));
    if (has_room) explain(field("lights"), marked("Add a light"));
}

/// Returns a plane for the next wall of a room around the scene.
PlaneParams another_plane(const Params& params) {
    static constexpr glm::dvec4 walls[] = {{0, 0, 1, 3},  {1, 0, 0, 3},   {-1, 0, 0, 3}, {0, 0, -1, 3},
                                           {0, -1, 0, 6}, {0, 0, 1, 3.5}, {1, 0, 0, 3.5}};
    for (const glm::dvec4& wall : walls)
        if (std::none_of(params.planes.begin(), params.planes.end(),
                         [&](const PlaneParams& plane) { return plane.equation == wall; }))
            return {.equation = wall};
    return {.equation = walls[0]};
}

/// Returns d for each of the three coordinate planes. If a plane would cut the objects, moves it behind them, as seen
/// from the eye.
glm::dvec3 d_clear_of(const Bounds& bounds, const glm::dvec3& eye) {
    constexpr double touch = 1e-6, gap = 0.2, grid = 0.5;
    glm::dvec3 d(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const double min = bounds.min[axis], max = bounds.max[axis];
        if (min >= -touch || max <= touch) continue;
        const bool is_from_above = eye[axis] >= (min + max) * 0.5;
        d[axis] = is_from_above ? -std::floor((min - gap) / grid) * grid : -std::ceil((max + gap) / grid) * grid;
    }
    return d;
}

/// Draws a plane's equation, size and flags. `bounds`: the bounds of all objects.
void plane_controls(Params& params, std::size_t index, const Bounds& bounds) {
    static const PlaneParams defaults;
    PlaneParams& plane = params.planes[index];
    std::span<const widgets::Links> links;
    if (index == params.chosen().plane) links = link::plane;
    // Only the first plane's controls have names that lessons can use.
    const auto name = [index](const Field& of) { return index == 0 ? target_of(of.path) : std::string(); };
    const Field& equation = field("plane.equation");
    const auto is_drawn = [index](const Field& of, const char* label, float width = 0.0F) {
        return index > 0 || (widgets::IsListed(target_of(of.path)) && !is_covered(of, label, width));
    };
    const char* const equation_label = label_of(marked("equation"), marked("plane equation###equation"));
    if (is_drawn(equation, equation_label)) {
        const widgets::TargetScope scope(name(equation));
        widgets::PlaneEquation(equation_label, plane.equation, defaults.equation, links,
                               d_clear_of(bounds, params.camera.position));
        widgets::MarkTarget(name(equation));
        if (!widgets::IsPartCovered(name(equation))) explain(equation, marked("plane"));
    }
    const Field& extent = field("plane.extent");
    const widgets::NumberStyle style{.min = extent.min,
                                     .max = extent.max,
                                     .drag_min = 0.5,
                                     .drag_max = 50.0,
                                     .step = extent.step,
                                     .logarithmic = extent.logarithmic,
                                     .default_value = defaults.extent};
    const char* const extent_label = label_of(marked("extent"), marked("plane extent###extent"));
    if (is_drawn(extent, extent_label)) {
        const widgets::TargetScope scope(name(extent));
        widgets::Slider(extent_label, plane.extent, style);
        explain(extent, marked("extent"));
    }
    const auto toggle = [&](const char* path, const char* label, bool& value, bool default_value) {
        if (!is_drawn(field(path), label, widgets::ToggleWidth(""))) return;
        const std::string_view why_not = why_without_effect(params, nullptr, path);
        ImGui::BeginDisabled(!why_not.empty());
        widgets::Toggle(label, value, default_value);
        ImGui::EndDisabled();
        widgets::MarkTarget(name(field(path)));
        explain(field(path), label, why_not);
    };
    toggle("plane.receives_shadow", marked("Receiver"), plane.receives_shadow, defaults.receives_shadow);
    beside(second_column, widgets::ToggleWidth("Mirrors"));
    toggle("plane.mirrors", marked("Mirrors"), plane.mirrors, defaults.mirrors);
    beside(second_column + 76.0F, widgets::ToggleWidth("Gloss"));
    toggle("plane.gloss", marked("Gloss"), plane.gloss, defaults.gloss);
}

void further_planes(Params& params, const Bounds& bounds) {
    if (widgets::IsListing()) return;
    for (std::size_t index = 1; index < params.planes.size(); ++index) {
        const std::size_t number = index + 1;
        const std::string id = std::to_string(number);
        const std::string headline = say("Plane {number}", "number"_a = number) + "###Plane " + id;
        if (!details(headline.c_str())) continue;
        const widgets::Group group(("plane " + id).c_str());
        plane_controls(params, index, bounds);
        const std::string remove = say("Remove plane {number}", "number"_a = number) + "###remove plane " + id;
        if (widgets::SmallButton(remove.c_str())) return remove_plane(params, index);
    }
    const bool has_room = params.planes.size() < most_planes;
    if (widgets::SmallButton("Add a plane", has_room, "There can be at most eight planes."))
        params.planes.push_back(another_plane(params));
    if (has_room) explain(field("planes"), marked("Add a plane"));
}

void shadow_style(Params& params) {
    static constexpr const char* styles[] = {marked("Blend"), marked("Missing light")};
    control(params, "shadow.style", {.segments = true, .names = styles, .label = "##style"});
    control(params, "shadow.color");
    static constexpr const char* offsets[] = {marked("none"), "glPolygonOffset", marked("lift"),
                                              marked("no depth test")};
    control(params, "shadow.offset", {.width = 150.0F, .names = offsets, .label = marked("offset")});
    control(params, "shadow.offset_factor", {.label = marked("factor")});
    control(params, "shadow.offset_units", {.label = marked("units")});
    control(params, "shadow.lift", {.decimals = 3, .slider = true, .min = 0.0, .max = 1.0});
    control(params, "shadow.write_depth", {.label = marked("Write depth")});
}

void shadow_switches(Params& params) {
    control(params, "shadow.clip_at_light", {.label = marked("Clip at light")});
    beside(second_column, widgets::ToggleWidth("Own stencil"));
    control(params, "shadow.own_stencil", {.label = marked("Own stencil")});
    static constexpr const char* signs[] = {"sign(n·ℓ + d)", marked("none"), marked("forced")};
    control(params, "shadow.sign", {.width = 150.0F, .names = signs, .label = marked("sign of S")});
    control(params, "slips.shadow_by_rows", {.label = marked("S by rows")});
}

void mirror_switches(Params& params) {
    static constexpr const char* things[] = {marked("Mirror the scene"), marked("the camera")};
    control(params, "reflection.mirrored", {.segments = true, .names = things, .label = "##mirrored"});
    struct Row {
        const char *left, *left_label, *right, *right_label;
    };
    static constexpr Row rows[] = {
        {"reflection.side_of_eye", marked("Eye's side"), "reflection.shadows", marked("Shadows inside")},
        {"reflection.after_objects", marked("Mirror last"), "reflection.printed_by_rows", marked("R as printed")},
        {"slips.normal_not_unit", marked("n not unit"), "slips.plus_2ab", marked("+2ab in R")},
    };
    for (const Row& row : rows) {
        control(params, row.left, {.label = row.left_label});
        beside(second_column, widgets::ToggleWidth(row.right_label));
        control(params, row.right, {.label = row.right_label});
    }
    control(params, "reflection.mask_writes_depth", {.label = marked("Mask writes depth")});
    control(params, "reflection.same_projection", {.label = marked("Same projection")});
    control(params, "slips.oblique_in_world", {.label = marked("Oblique in world")});
    control(params, "reflection.fovy", {.decimals = 1, .slider = true});
}

}  // namespace

void draw_light_section(Session& session, const std::vector<Problem>& problems) {
    const std::string headline = std::string(marked("Light  ℓ")) + "###Light  l";
    if (!section(headline.c_str(), problems, {"light"})) return;
    const widgets::Group group("light");
    Params& params = session.params;
    light_controls(params, 0, label_of(marked("position"), marked("light position###position")));
    const std::string position = target_of("light.position");
    if (widgets::IsListed(position) && !widgets::IsPartCovered(position))
        explain(field("light.position"), marked("light"));
    control(params, "animation.light_orbit", {.label = marked("Orbit")});
    beside(74.0F, widgets::LabelledWidth("speed", px(123.0F)));
    control(params, "animation.light_speed", {.decimals = 0, .width = 123.0F, .label = marked("speed")});
    further_lights(params);
}

void draw_plane_section(Session& session, const Derived& derived, const std::vector<Problem>& problems) {
    if (!section("Plane  n·p + d = 0", problems, {"plane"})) return;
    const widgets::Group group("plane");
    plane_controls(session.params, 0, session.scene().bounds_world);
    const glm::dvec4& unit = derived.planes.front().unit_plane;
    const std::string note =
        say("normalized: ({x}, {y}, {z}, {w})", "x"_a = number_text(unit.x, 3), "y"_a = number_text(unit.y, 3),
            "z"_a = number_text(unit.z, 3), "w"_a = number_text(unit.w, 3));
    if (!widgets::IsListing() || widgets::IsHighlighted("text:unit normal")) named_note("text:unit normal", note);
    further_planes(session.params, session.scene().bounds_world);
}

void draw_shadow_and_reflection_section(Session& session, const std::vector<Problem>& problems) {
    if (!section("Shadow and reflection", problems, {"shadow", "reflection"})) return;
    Params& params = session.params;
    struct Row {
        const char *shadow, *shadow_label, *reflection, *reflection_label;
    };
    static constexpr Row rows[] = {
        {"shadow.enabled", marked("Shadow"), "reflection.enabled", marked("Reflection")},
        {"shadow.stencil_once", marked("Stencil once"), "reflection.stencil", marked("Clip to mirror")},
        {"shadow.clip_to_receiver", marked("Clip to patch"), "reflection.flip_winding", marked("Flip winding")},
        {"shadow.clip_casters", marked("Clip casters"), "reflection.reflect_light", marked("Mirror light")},
    };
    for (const Row& row : rows) {
        {
            const widgets::Group group("shadow");
            control(params, row.shadow, {.label = row.shadow_label});
        }
        beside(second_column, widgets::ToggleWidth(row.reflection_label));
        const widgets::Group group("reflection");
        control(params, row.reflection, {.label = row.reflection_label});
    }
    {
        const widgets::Group group("shadow");
        control(params, "shadow.opacity", {.slider = true});
        static constexpr const char* style[] = {"control:shadow.style",        "control:shadow.color",
                                                "control:shadow.offset",       "control:shadow.offset_factor",
                                                "control:shadow.offset_units", "control:shadow.lift",
                                                "control:shadow.write_depth"};
        static constexpr const char* switches[] = {"control:shadow.clip_at_light", "control:shadow.own_stencil",
                                                   "control:shadow.sign", "control:slips.shadow_by_rows"};
        if (details(marked("Shadow: style and offset"), style)) shadow_style(params);
        if (details(marked("Shadow: clip at light, sign, stencil"), switches)) shadow_switches(params);
    }
    const widgets::Group group("reflection");
    control(params, "reflection.reflectance", {.slider = true});
    control(params, "reflection.bounces", {.slider = true});
    static constexpr const char* clips[] = {marked("no clipping"), marked("clip distance"),
                                            marked("oblique near plane")};
    control(params, "reflection.clip", {.width = 150.0F, .names = clips});
    static constexpr const char* drawn[] = {
        "control:reflection.mirrored",        "control:reflection.side_of_eye",
        "control:reflection.shadows",         "control:reflection.after_objects",
        "control:reflection.printed_by_rows", "control:reflection.mask_writes_depth",
        "control:reflection.same_projection", "control:reflection.fovy",
        "control:slips.normal_not_unit",      "control:slips.plus_2ab",
        "control:slips.oblique_in_world"};
    if (details(marked("Mirror: drawing method"), drawn)) mirror_switches(params);
}

}  // namespace viewing
