// Theme, scale, language and fonts of the user interface, which depend on the state and the monitor.
#pragma once

#include <optional>
#include <string>

#include "state/params.h"
#include "ui/parts/layout.h"
#include "ui/window/syllables.h"
#include "widgets/widgets.h"

namespace viewing {

/// Uploads the fonts from load_fonts(), at this scale, to the GL backend of the current ImGui context.
widgets::Fonts upload_fonts(float pixels_per_design_pixel, Syllables& korean, const TypeSizes& type = {});

class Looks {
public:
    /// Returns why the requested language is not available; "" if it is.
    const std::string& trouble() const { return trouble_; }

    /// Applies changes. Needs ImGui's GL backend. `device_scale` is the monitor's. Returns whether anything has
    /// changed.
    bool follow(const UiParams& ui, double device_scale, ImVec2 window_px, const Arrangement& arrangement,
                Syllables& korean, widgets::Context& context);

private:
    Theme theme_ = Theme::dark;
    float scale_ = 0.0F;
    TypeSizes type_;
    int font_files_ = 0;                ///< number of font files that had arrived at the last upload
    std::optional<Language> language_;  ///< the last requested language
    std::string trouble_;
};

}  // namespace viewing
