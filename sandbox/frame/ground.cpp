#include "frame/ground.h"

#include <cmath>

namespace viewing {

Ground ground_of(Theme theme) {
    switch (theme) {
        case Theme::light:
            return {{0xe6, 0xea, 0xf0}, {0xc9, 0xd0, 0xda}, {0xbc, 0xc4, 0xd0}, {0x97, 0xa1, 0xb0}, {0xbd, 0xd2, 0xea}};
        case Theme::projector:
            return {{0xff, 0xff, 0xff}, {0xd6, 0xdb, 0xe2}, {0xc6, 0xcd, 0xd6}, {0x7c, 0x86, 0x94}, {0xc6, 0xdc, 0xf4}};
        default:
            return {{0x1b, 0x1f, 0x27}, {0x6e, 0x75, 0x82}, {0x62, 0x69, 0x76}, {0x3c, 0x42, 0x4d}, {0x1d, 0x2a, 0x3e}};
    }
}

glm::vec3 linear_from_srgb(const Color& color) {
    const auto one = [](int channel) {
        const float value = static_cast<float>(channel) / 255.0F;
        return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
    };
    return {one(color.r), one(color.g), one(color.b)};
}

}  // namespace viewing
