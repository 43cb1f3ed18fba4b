// A control for any field. Its label, range, step, default, and tooltip come from the list of fields, so the panel only
// decides where each field goes.
#pragma once

#include <string>
#include <string_view>

#include "state/fields.h"
#include "state/scene.h"
#include "widgets/widgets.h"

namespace viewing {

/// The appearance of a control, which the list of fields does not define.
struct ControlStyle {
    int decimals = 2;
    bool slider = false;
    bool segments = false;                       ///< draws an enumeration as radio buttons
    float width = 0.0F;                          ///< design pixels; 0: default. A list may grow to fit the chosen name
    std::span<const widgets::Links> links = {};  ///< one per component
    std::span<const char* const> names = {};     ///< replace the enumeration's names
    std::span<const char* const> tips = {};      ///< explain each segment
    const char* label = nullptr;                 ///< replaces the field's label
    double min = 0.0, max = 0.0;                 ///< a narrower range for drags and sliders; both 0: the field's own
    const Scene* scene = nullptr;                ///< needed for a field that only some scenes use
};

/// Draws the control; returns whether the value changed. If the field has no effect, the control is grayed out and its
/// tooltip says why.
bool control(Params& params, std::string_view path, const ControlStyle& style = {});

/// Returns the name by which lessons cover and highlight a field's control: "control:camera.yaw".
std::string target_of(std::string_view path);

/// If the field's control is covered, draws a plate `width` pixels wide in its place. Returns whether it is covered.
bool is_covered(const Field& field, const char* label, float width = 0.0F);

/// Returns a control's label. In a lesson, no section header is above the control, so the label also names the section,
/// except on stage, where it would not fit.
inline const char* label_of(const char* in_section, const char* alone) {
    return widgets::IsListing() && !widgets::CurrentContext().is_on_stage ? alone : in_section;
}

/// Draws the last item's tooltip, which explains a field. Its title is `label` without any "##…" or, if `label` is
/// empty, the field's own label; the field's path is at the bottom. `why_not` says why the field has no effect now, or
/// is empty.
void explain(const Field& field, std::string_view label = {}, std::string_view why_not = {});

/// Returns the defaults that a right-click restores.
const Params& default_params();

}  // namespace viewing
