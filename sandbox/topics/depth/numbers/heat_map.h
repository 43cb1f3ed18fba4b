// The heat map of depth fighting: the gap of each flat pair, and the gap that each eye distance needs. Pure; the shader
// divides one by the other for every pixel. See fighting.h for the formulas.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "state/scene.h"

namespace viewing {

struct Derived;
struct Params;

/// The narrowest gap between an object and any other object.
struct FlatGap {
    double gap = 0.0;             ///< world units, along the normal
    glm::dvec3 normal_view{0.0};  ///< unit; either of the two directions
    bool operator==(const FlatGap&) const = default;
};

struct HeatMap {
    static constexpr std::size_t entry_count = 256;

    /// The values of fighting_onset().gap(), which is one code plus the error of the arithmetic before it, at eye
    /// distances that are evenly spaced on a logarithmic scale: the first entry is at near, the last at far. Very close
    /// to near, no sufficient gap fits between a surface and the near plane; the entries there repeat the entry of the
    /// nearest distance at which one fits. All entries are positive.
    std::array<double, entry_count> onsets{};
    double near = 1.0, far = 2.0;
    std::vector<std::optional<FlatGap>> gap_of_object;  ///< by object index; none if the object is in no pair

    /// Returns the eye distance of an entry.
    double distance_of(std::size_t entry) const;

    bool operator==(const HeatMap&) const = default;
};

HeatMap heat_map(const Params& params, const Derived& derived, const Scene& scene);

/// Colors for the ratio of a gap to its onset: for 0, ½ and just below 1 (the surfaces share codes), then for 1, 2, and
/// 4 or more. Interpolated linearly below 1 and logarithmically above. Fighting is dark and red, and safe gaps are
/// light and blue, so the order is visible without color, too.
inline constexpr std::array<Color, 6> heat_colors = {{{0x8e, 0x1b, 0x12},
                                                      {0xc0, 0x36, 0x1e},
                                                      {0xe4, 0x57, 0x2e},
                                                      {0xee, 0xa2, 0x4a},
                                                      {0xf3, 0xcb, 0x85},
                                                      {0xc3, 0xe0, 0xf0}}};

}  // namespace viewing
