#include "frame/planes/mirror_ways.h"

#include <algorithm>
#include <cstdlib>

#include "frame/ground.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

constexpr int tolerated_levels = 2;

/// Two pictures that are compared pixel by pixel.
struct Pair {
    std::span<const std::uint8_t> a, b;
    glm::ivec2 size_px;

    int levels_between(glm::ivec2 in_a, glm::ivec2 in_b) const {
        int worst = 0;
        for (int channel = 0; channel < 3; ++channel)
            worst = std::max(worst, std::abs(a[byte(in_a, channel)] - b[byte(in_b, channel)]));
        return worst;
    }

    /// The least difference to what is next to the same place in b.
    int levels_nearby(glm::ivec2 pixel) const {
        int least = 255;
        for (int y = std::max(pixel.y - 1, 0); y <= std::min(pixel.y + 1, size_px.y - 1); ++y)
            for (int x = std::max(pixel.x - 1, 0); x <= std::min(pixel.x + 1, size_px.x - 1); ++x)
                least = std::min(least, levels_between(pixel, {x, y}));
        return least;
    }

private:
    std::size_t byte(glm::ivec2 pixel, int channel) const {
        return (static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size_px.x) +
                static_cast<std::size_t>(pixel.x)) *
                   4 +
               static_cast<std::size_t>(channel);
    }
};

}  // namespace

Params mirrored_in(Params params, MirrorWay way) {
    ReflectionParams& reflection = params.reflection;
    reflection.clip = way == MirrorWay::none      ? MirrorClip::none
                      : way == MirrorWay::oblique ? MirrorClip::oblique
                                                  : MirrorClip::clip_distance;
    reflection.mirrored = way == MirrorWay::camera ? MirroredThing::camera : MirroredThing::scene;
    return params;
}

const char* name_of(MirrorWay way) {
    static constexpr const char* names[] = {marked("clip distance"), marked("no clipping"),
                                            marked("oblique near plane"), marked("mirrored camera")};
    return names[static_cast<std::size_t>(way)];
}

PictureDifference picture_difference(std::span<const std::uint8_t> reference, std::span<const std::uint8_t> picture,
                                     glm::ivec2 size_px) {
    constexpr glm::u8vec4 differs(difference_color.r, difference_color.g, difference_color.b, 255), veil(0, 0, 0, 110);
    const Pair forward{reference, picture, size_px}, backward{picture, reference, size_px};
    PictureDifference made;
    made.drawing.size_px = size_px;
    made.drawing.pixels.reserve(static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y));
    for (int y = 0; y < size_px.y; ++y)
        for (int x = 0; x < size_px.x; ++x) {
            const glm::ivec2 pixel(x, y);
            const int here = forward.levels_between(pixel, pixel);
            const bool is_different = here > tolerated_levels && (forward.levels_nearby(pixel) > tolerated_levels ||
                                                                  backward.levels_nearby(pixel) > tolerated_levels);
            if (is_different) made.report.worst = std::max(made.report.worst, here);
            made.report.different += is_different ? 1 : 0;
            made.drawing.pixels.push_back(is_different ? differs : veil);
        }
    made.report.compared = made.drawing.compared = static_cast<std::int64_t>(made.drawing.pixels.size());
    made.drawing.different = made.report.different;
    return made;
}

}  // namespace viewing
