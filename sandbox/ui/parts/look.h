// Short words for what every panel and view asks the widgets' context for.
#pragma once

#include "widgets/widgets.h"

namespace viewing {

/// Pixels of a size in design pixels.
inline float px(float design) {
    return design * widgets::CurrentContext().scale;
}

/// The same colour, 0 … 255 opaque.
constexpr ImU32 with_alpha(ImU32 color, ImU32 alpha) {
    return (color & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

inline const widgets::Palette& palette() {
    return widgets::CurrentContext().palette;
}

}  // namespace viewing
