// Theme, scale, language and fonts of the user interface, followed when the state or the monitor changes.
#pragma once

#include <optional>
#include <string>

#include "state/params.h"
#include "ui/parts/layout.h"
#include "ui/window/syllables.h"
#include "widgets/widgets.h"

namespace viewing {

/// The fonts of the current ImGui context for a scale, as load_fonts() has them, in its GL backend.
widgets::Fonts upload_fonts(float pixels_per_design_pixel, Syllables& korean, float small_type = usual_small_type);

class Looks {
public:
    /// Why the language that is wanted is not spoken; "" where it is.
    const std::string& trouble() const { return trouble_; }

    /// Needs ImGui's GL backend. `device_scale`: of the monitor. True when something has changed.
    bool follow(const UiParams& ui, double device_scale, ImVec2 window_px, const Arrangement& arrangement,
                Syllables& korean, widgets::Context& context);

private:
    Theme theme_ = Theme::dark;
    float scale_ = 0.0F, small_type_ = 0.0F;
    int font_files_ = 0;                ///< that had arrived
    std::optional<Language> language_;  ///< that was asked for
    std::string trouble_;
};

}  // namespace viewing
