// Two short words for what every panel and view asks the widgets' context for.
#pragma once

#include "widgets/widgets.h"

namespace viewing {

/// Pixels of a size in design pixels.
inline float px(float design) {
    return design * widgets::CurrentContext().scale;
}

inline const widgets::Palette& palette() {
    return widgets::CurrentContext().palette;
}

}  // namespace viewing
