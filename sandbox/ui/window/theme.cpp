#include "ui/window/theme.h"

namespace viewing {

const widgets::Palette& palette_of(Theme theme) {
    using widgets::ThemeKind;
    switch (theme) {
        case Theme::dark:
            return widgets::palette_of(ThemeKind::dark);
        case Theme::light:
            return widgets::palette_of(ThemeKind::light);
        case Theme::projector:
            break;
    }
    return widgets::palette_of(ThemeKind::projector);
}

}  // namespace viewing
