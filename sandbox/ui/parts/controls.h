// A control for any field of the one list: label, range, step, default and tooltip come from there, so the panel
// only says which field stands where.
#pragma once

#include <string>
#include <string_view>

#include "state/fields.h"
#include "state/scene.h"
#include "widgets/widgets.h"

namespace viewing {

/// What the list of fields does not know: how it should look here.
struct ControlStyle {
    int decimals = 2;
    bool slider = false;
    bool segments = false;                       ///< an enumeration as radio buttons
    float width = 0.0F;                          ///< design pixels; 0: the usual one. A list may be wider, for its name
    std::span<const widgets::Links> links = {};  ///< one per component
    std::span<const char* const> names = {};     ///< shown in place of the enumeration's own
    std::span<const char* const> tips = {};      ///< of segments: what each one means
    const char* label = nullptr;                 ///< in place of the field's
    double min = 0.0, max = 0.0;                 ///< a narrower range for drags and sliders; both 0: the field's own
    const Scene* scene = nullptr;                ///< of a field that not every scene has a use for
};

/// Draws the control; true when it changed the value. Where the field has no effect it is greyed and says why.
bool control(Params& params, std::string_view path, const ControlStyle& style = {});

/// The name under which a field's control is covered and pointed out: "control:camera.yaw".
std::string target_of(std::string_view path);

/// Draws in place of the field's control a plate so many pixels wide where it is covered, and says whether it did.
bool is_covered(const Field& field, const char* label, float width = 0.0F);

/// The tooltip that explains a field, for the last item. Its title is `label`, what the control shows ("##…" counts as
/// nothing), else the field's own; the field's path stands below. `why_not`: why it has no effect now, else empty.
void explain(const Field& field, std::string_view label = {}, std::string_view why_not = {});

/// The defaults, as right-click resets to them.
const Params& default_params();

}  // namespace viewing
