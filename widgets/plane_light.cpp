// Editors for the lecture's two four-component values. They keep the values valid: the plane's normal is never zero,
// and the light's components are never all zero.
#include <cmath>

#include "widgets/inner.h"

namespace widgets {

namespace {

constexpr double smallest = 1e-6;  ///< lengths below this count as zero

double NormalLength(const glm::dvec4& plane) {
    return glm::length(glm::dvec3(plane));
}

/// Draws buttons for the coordinate planes, moved by `d`, and for normalizing. Returns whether `plane` was edited.
bool PlaneButtons(glm::dvec4& plane, const glm::dvec3& d) {
    struct Preset {
        const char *name, *tip, *moved_tip;
    };
    static constexpr Preset presets[] = {
        {"yz", marked("The vertical plane x = 0: a = 1, the rest 0."),
         marked("A vertical plane with a = 1 that cuts no object. Press again for x = 0.")},
        {"xz", marked("The ground plane y = 0: b = 1, the rest 0."),
         marked("A horizontal plane with b = 1 that cuts no object. Press again for y = 0.")},
        {"xy", marked("The vertical plane z = 0: c = 1, the rest 0."),
         marked("A vertical plane with c = 1 that cuts no object. Press again for z = 0.")}};
    const glm::dvec4 before = plane;
    for (int axis = 0; axis < 3; ++axis) {
        const Preset& preset = presets[axis];
        glm::dvec4 through_origin(0.0), moved(0.0, 0.0, 0.0, d[axis]);
        through_origin[axis] = moved[axis] = 1.0;
        if (SmallButton(preset.name)) plane = plane == moved ? through_origin : moved;
        Tooltip(preset.name, d[axis] == 0.0 ? preset.tip : preset.moved_tip);
        ImGui::SameLine(0.0F, inner::Px(4));
    }
    const bool is_unit = std::abs(NormalLength(plane) - 1.0) < 1e-12;
    if (SmallButton("Normalize", !is_unit, "The normal (a, b, c) already has length 1.")) plane /= NormalLength(plane);
    if (!is_unit) Tooltip("Normalize", "Divides a, b, c and d by the normal's length: same plane, unit normal.");
    return plane != before;
}

}  // namespace

bool PlaneEquation(const char* label, glm::dvec4& plane, const glm::dvec4& default_value, std::span<const Links> links,
                   const glm::dvec3& d_of_buttons) {
    static constexpr const char* names[] = {"a", "b", "c", "d"};
    const double defaults[] = {default_value.x, default_value.y, default_value.z, default_value.w};
    const NumberStyle style{.step = 0.01, .decimals = 3, .role = Role::plane};
    double values[] = {plane.x, plane.y, plane.z, plane.w};

    ImGui::BeginGroup();
    bool changed = false;
    {
        const float width = ImGui::CalcItemWidth();
        const inner::Labelled labelled(label, width);
        const Group group(label);
        if (inner::NumberRow(values, names, style, defaults, links, width)) {
            const glm::dvec4 edited(values[0], values[1], values[2], values[3]);
            if (NormalLength(edited) >= smallest) {
                plane = edited;
                changed = true;
            }
        }
    }
    {
        const Group group(label);
        changed |= PlaneButtons(plane, d_of_buttons);
    }
    ImGui::EndGroup();
    return changed;
}

bool Light(const char* label, glm::dvec4& light, const glm::dvec4& default_value, std::span<const Links> links) {
    static constexpr const char* names[] = {"x", "y", "z", "w"};
    const double defaults[] = {default_value.x, default_value.y, default_value.z, default_value.w};
    const bool at_origin = glm::length(glm::dvec3(light)) < smallest;
    const inner::Segment kinds[] = {
        {.name = marked("Point (w = 1)"),
         .recorded_name = "point",
         .tip = marked("A light at the point (x, y, z); its rays spread from there.")},
        {.name = marked("Parallel (w = 0)"),
         .recorded_name = "parallel",
         .enabled = !at_origin,
         .why_disabled = marked("A parallel light needs a direction, but x, y and z are all 0."),
         .tip = marked("A light infinitely far away, like the sun; (x, y, z) is the direction toward it.")}};

    glm::dvec4 edited = light;
    ImGui::BeginGroup();
    {
        const Group group(label);
        // The buttons would reveal a covered w.
        const bool is_covered = inner::CoveredBox("kind", 3, {ImGui::CalcItemWidth(), ImGui::GetFrameHeight()});
        const int clicked = is_covered ? -1 : inner::SegmentBar(kinds, light.w == 1.0 ? 0 : light.w == 0.0 ? 1 : -1);
        if (clicked >= 0) edited.w = clicked == 0 ? 1.0 : 0.0;
    }
    {
        const float width = ImGui::CalcItemWidth();
        const inner::Labelled labelled(label, width);
        const Group group(label);
        const NumberStyle position{.step = 0.02, .decimals = 2, .role = Role::light};
        const NumberStyle weight{.min = 0.0,
                                 .max = 1.0,
                                 .step = 0.005,
                                 .decimals = 2,
                                 .default_value = default_value.w,
                                 .role = Role::light};
        const float gap = inner::Px(4), w_width = std::floor((width - 3.0F * gap) / 4.0F);
        double values[] = {edited.x, edited.y, edited.z, edited.w};
        const std::span<const Links> position_links = links.subspan(0, std::min<std::size_t>(links.size(), 3));
        inner::NumberRow({values, 3}, {names, 3}, position, {defaults, 3}, position_links, width - gap - w_width);
        ImGui::SameLine(0.0F, gap);
        inner::NumberRow({values + 3, 1}, {names + 3, 1}, weight, {defaults + 3, 1},
                         links.size() > 3 ? links.subspan(3, 1) : std::span<const Links>{}, w_width, 3);
        edited = {values[0], values[1], values[2], values[3]};
    }
    ImGui::EndGroup();

    const bool meaningful = glm::length(edited) >= smallest;
    const bool changed = meaningful && edited != light;
    if (changed) light = edited;
    return changed;
}

}  // namespace widgets
