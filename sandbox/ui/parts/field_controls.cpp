#include "ui/parts/field_controls.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "frame/effect.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

// The const_cast is safe: the value is only read.
template <typename T>
const T& default_of(const Field& field) {
    return *std::get<T*>(field.in(const_cast<Params&>(default_params())));
}

widgets::NumberStyle number_style(const Field& field, const ControlStyle& style, int component = 0) {
    const Range range = component_range(field, component);
    widgets::NumberStyle number;
    number.min = range.min;
    number.max = range.max;
    number.drag_min = style.min;
    number.drag_max = style.max;
    number.step = field.step;
    number.decimals = style.decimals;
    number.unit = field.unit == "°" ? "°" : "";
    number.logarithmic = field.logarithmic && (style.min > 0.0 || range.min > 0.0);
    if (!style.links.empty()) number.links = style.links[0];
    return number;
}

/// Draws a field's control. The visitor has one overload for each type of field that can have a control here.
struct DrawControl {
    const Field& field;
    const ControlStyle& style;
    const char* label;

    float width() const { return style.width * widgets::CurrentContext().scale; }
    /// Returns the style's width, or more if the chosen name needs it and there is space.
    float choice_width(std::span<const char* const> names, int index) const {
        if (style.width <= 0.0F || index < 0 || index >= std::ssize(names)) return width();
        const float needed = widgets::ChoiceWidth(names.subspan(static_cast<std::size_t>(index), 1));
        return std::max(width(), std::min(needed, ImGui::GetContentRegionAvail().x));
    }

    bool operator()(bool* value) const { return widgets::Toggle(label, *value, default_of<bool>(field)); }

    bool operator()(int* value) const {
        widgets::NumberStyle number = number_style(field, style);
        number.integer = true;
        number.decimals = 0;
        number.default_value = default_of<int>(field);
        double edited = *value;
        const bool changed = style.slider ? widgets::Slider(label, edited, number, width())
                                          : widgets::Number(label, edited, number, width());
        if (!changed) return false;
        *value = static_cast<int>(edited);
        return true;
    }

    bool operator()(double* value) const {
        widgets::NumberStyle number = number_style(field, style);
        number.default_value = default_of<double>(field);
        return style.slider ? widgets::Slider(label, *value, number, width())
                            : widgets::Number(label, *value, number, width());
    }

    bool operator()(glm::dvec3* value) const {
        return widgets::Vec3(label, *value, number_style(field, style), default_of<glm::dvec3>(field), style.links);
    }

    bool operator()(Color* value) const {
        const Color& start = default_of<Color>(field);
        glm::u8vec3 rgb(value->r, value->g, value->b);
        if (!widgets::ColorField(label, rgb, {start.r, start.g, start.b})) return false;
        *value = {rgb.r, rgb.g, rgb.b};
        return true;
    }

    bool operator()(const EnumRef& value) const {
        const int start = std::get<EnumRef>(field.in(const_cast<Params&>(default_params()))).index();
        const std::span<const char* const> names = style.names.empty() ? value.names : style.names;
        int index = value.index();
        const bool changed = style.segments ? widgets::Segments(label, index, names, start, style.tips)
                                            : widgets::Choice(label, index, names, start, choice_width(names, index));
        if (changed) value.set(index);
        return changed;
    }

    template <typename T>
    bool operator()(T) const {
        assert(false && "this field has a widget of its own");
        return false;
    }
};

}  // namespace

const Params& default_params() {
    static const Params defaults;
    return defaults;
}

void explain(const Field& field, std::string_view label, std::string_view why_not) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    const bool has_unit = !field.unit.empty() && field.unit != "°";
    const std::string help(tr_part(field.help));
    std::string body = has_unit ? say("{help} ({unit})", "help"_a = help, "unit"_a = tr_part(field.unit)) : help;
    if (!why_not.empty()) body = say("No effect now: {why}", "why"_a = tr_part(why_not)) + "\n" + body;
    std::string title(label.substr(0, label.find("##")));
    if (title.empty()) title = field.label;
    widgets::Tooltip(title.c_str(), body.c_str(), std::string(field.formula).c_str(),
                     std::string(field.gl_call).c_str(), {}, std::string(field.path).c_str());
}

bool is_covered(const Field& field, const char* label, float width) {
    const std::string target = target_of(field.path);
    if (!widgets::IsCovered(target)) return false;
    widgets::CoveredControl(label, width);
    widgets::MarkTarget(target);
    return true;
}

std::string target_of(std::string_view path) {
    return "control:" + std::string(path);
}

bool control(Params& params, std::string_view path, const ControlStyle& style) {
    if (!widgets::IsListed(target_of(path))) return false;
    const Field& found = field(path);
    const char* label = style.label ? style.label : found.label.data();
    const bool is_toggle = type_name(found) == "bool";
    const float width = is_toggle ? widgets::ToggleWidth("") : style.width * widgets::CurrentContext().scale;
    if (is_covered(found, label, width)) return false;
    const widgets::TargetScope scope(target_of(found.path));
    ImGui::PushID(found.path.data(), found.path.data() + found.path.size());
    const std::string_view why_not = why_without_effect(params, style.scene, path);
    ImGui::BeginDisabled(!why_not.empty());
    const bool changed = std::visit(DrawControl{found, style, label}, found.in(params));
    ImGui::EndDisabled();
    ImGui::PopID();
    widgets::MarkTarget(target_of(found.path));
    if (!widgets::IsPartCovered(target_of(found.path))) explain(found, label, why_not);
    return changed;
}

}  // namespace viewing
