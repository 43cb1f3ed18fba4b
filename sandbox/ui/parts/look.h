// Short words for what every panel and view asks the widgets' context for, and of a text.
#pragma once

#include <algorithm>
#include <string_view>

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

/// Characters of a text in UTF-8.
inline std::size_t length_of(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

inline const widgets::Palette& palette() {
    return widgets::CurrentContext().palette;
}

}  // namespace viewing
