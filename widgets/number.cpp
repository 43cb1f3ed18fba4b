// Numbers with labels: single numbers, sliders, and rows. All of them are built from NumberBox (number_box.cpp).
#include <cmath>
#include <iterator>

#include "widgets/inner.h"

namespace widgets {

namespace inner {

bool NumberRow(std::span<double> values, std::span<const char* const> names, const NumberStyle& style,
               std::span<const double> defaults, std::span<const Links> links, float width, int first) {
    const float gap = Px(4);
    const auto count = static_cast<float>(values.size());
    const float each = std::floor((width - gap * (count - 1.0F)) / count);
    const NumberLook look = LookOf(values, style, each);
    bool changed = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
        NumberStyle own = style;
        if (i < defaults.size()) own.default_value = defaults[i];
        if (i < links.size()) own.links = links[i];
        if (own.unread) own.unread += i;
        if (i > 0) ImGui::SameLine(0.0F, gap);
        const int component = first + static_cast<int>(i);
        if (CoveredBox(names[i], component, {each, ImGui::GetFrameHeight()})) continue;
        changed |= NumberBox(names[i], values[i], own, each, BoxKind::drag, &look);
        MarkBox(component);
    }
    return changed;
}

}  // namespace inner

namespace {

constexpr const char* component_names[] = {"x", "y", "z", "w"};

bool LabelledBox(const char* label, double& value, const NumberStyle& style, float width, inner::BoxKind kind) {
    if (width <= 0.0F) width = ImGui::CalcItemWidth();
    const inner::Labelled labelled(label, width);
    if (inner::CoveredBox(label, -1, {width, ImGui::GetFrameHeight()})) return false;
    const bool changed = inner::NumberBox(label, value, style, width, kind);
    inner::MarkBox(-1);
    return changed;
}

}  // namespace

bool Number(const char* label, double& value, const NumberStyle& style, float width) {
    return LabelledBox(label, value, style, width, inner::BoxKind::drag);
}

bool IsLastEntered() {
    const Editing& editing = CurrentContext().editing;
    return editing.entered != 0 && editing.entered == editing.last_number;
}

bool Slider(const char* label, double& value, const NumberStyle& style, float width) {
    return LabelledBox(label, value, style, width, inner::BoxKind::slider);
}

bool Numbers(const char* label, std::span<double> values, const NumberStyle& style, std::span<const double> defaults,
             std::span<const Links> links) {
    IM_ASSERT(!values.empty() && values.size() <= std::size(component_names));
    const float width = ImGui::CalcItemWidth();
    const inner::Labelled labelled(label, width);
    const Group group(label);
    return inner::NumberRow(values, component_names, style, defaults, links, width);
}

bool Vec3(const char* label, glm::dvec3& value, const NumberStyle& style, const glm::dvec3& default_value,
          std::span<const Links> links) {
    double edited[] = {value.x, value.y, value.z};
    const double defaults[] = {default_value.x, default_value.y, default_value.z};
    const bool changed = Numbers(label, edited, style, defaults, links);
    if (changed) value = {edited[0], edited[1], edited[2]};
    return changed;
}

}  // namespace widgets
