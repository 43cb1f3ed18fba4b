#include "ui/window/theme.h"

#include "text/per_enum.h"

namespace viewing {

const widgets::Palette& palette_of(Theme theme) {
    using widgets::ThemeKind;
    static constexpr auto kinds = per_enum<Theme>(ThemeKind::dark, ThemeKind::light, ThemeKind::projector);
    return widgets::palette_of(kinds[theme]);
}

}  // namespace viewing
