// The heat map of depth fighting: for each flat pair how wide its gap is, and for each eye distance how wide it would
// have to be. Pure; the shader divides the one by the other for every pixel. Read fighting.h for the formulas.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "state/scene.h"

namespace viewing {

struct Derived;
struct Params;

/// The narrowest gap that an object has with another one.
struct FlatGap {
    double gap = 0.0;             ///< world units, along the normal
    glm::dvec3 normal_view{0.0};  ///< unit, of either side
    bool operator==(const FlatGap&) const = default;
};

struct HeatMap {
    static constexpr std::size_t entry_count = 256;

    /// fighting_onset().gap(), a code and the arithmetic before it, by the logarithm of the eye distance: the first
    /// entry is at near, the last one at far. Too near to near for any gap to be wide enough, it is that of the nearest
    /// distance that is not: wider than there is room for. All are positive.
    std::array<double, entry_count> onsets{};
    double near = 1.0, far = 2.0;
    std::vector<std::optional<FlatGap>> gap_of_object;  ///< by the object's index; none: it is in no pair

    /// The eye distance of an entry.
    double distance_of(std::size_t entry) const;

    /// Between the entries the onset goes by its logarithm. Outside near and far it is that of the nearest end.
    double onset_at(double distance) const;

    bool operator==(const HeatMap&) const = default;
};

HeatMap heat_map(const Params& params, const Derived& derived, const Scene& scene);

/// Colours for a gap divided by its onset: at 0, ½ and just below 1, where the surfaces share codes, then at 1, 2 and
/// from 4 on. Between them they go by the ratio below 1 and by its logarithm above. Trouble is dark and red, room is
/// light and blue: in order without colour too.
inline constexpr std::array<Color, 6> heat_colors = {{{0x8e, 0x1b, 0x12},
                                                      {0xc0, 0x36, 0x1e},
                                                      {0xe4, 0x57, 0x2e},
                                                      {0xee, 0xa2, 0x4a},
                                                      {0xf3, 0xcb, 0x85},
                                                      {0xc3, 0xe0, 0xf0}}};

/// For a ratio of 0 and more.
Color heat_color(double ratio);

}  // namespace viewing
