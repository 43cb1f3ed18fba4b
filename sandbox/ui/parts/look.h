// Short names for what panels and views often need from the widgets' context.
#pragma once

#include "widgets/widgets.h"

namespace viewing {

/// Converts design pixels to pixels.
inline float px(float design) {
    return design * widgets::CurrentContext().scale;
}

/// Returns the color with the given alpha, 0 … 255.
constexpr ImU32 with_alpha(ImU32 color, ImU32 alpha) {
    return (color & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

inline const widgets::Palette& palette() {
    return widgets::CurrentContext().palette;
}

}  // namespace viewing
