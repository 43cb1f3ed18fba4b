#include "image/matte.h"

#include <algorithm>

namespace viewing {

void remove_ground(const std::uint8_t* on_black, const std::uint8_t* on_white, std::uint8_t* rgba) {
    int shows_through = 0;
    for (int channel = 0; channel < 3; ++channel)
        shows_through = std::max(shows_through, on_white[channel] - on_black[channel]);
    const int alpha = 255 - shows_through;
    for (int channel = 0; channel < 3; ++channel) {
        const int color = alpha == 0 ? 0 : (on_black[channel] * 255 + alpha / 2) / alpha;
        rgba[channel] = static_cast<std::uint8_t>(std::min(255, color));
    }
    rgba[3] = static_cast<std::uint8_t>(alpha);
}

Image without_ground(const Image& on_black, const Image& on_white) {
    Image cut = on_black;
    for (std::size_t at = 0; at + 3 < cut.rgba.size(); at += 4) {
        remove_ground(&on_black.rgba[at], &on_white.rgba[at], &cut.rgba[at]);
        cut.rgba[at + 3] = static_cast<std::uint8_t>(cut.rgba[at + 3] * on_black.rgba[at + 3] / 255);
    }
    return cut;
}

}  // namespace viewing
