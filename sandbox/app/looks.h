// Theme, scale and fonts of the user interface, followed when the state or the monitor changes.
#pragma once

#include "state/params.h"
#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

class Looks {
public:
    /// Needs ImGui's GL backend. `device_scale`: of the monitor. True when something has changed.
    bool follow(const UiParams& ui, double device_scale, ImVec2 window_px, const Arrangement& arrangement,
                widgets::Context& context);

private:
    Theme theme_ = Theme::dark;
    float scale_ = 0.0F;
};

}  // namespace viewing
