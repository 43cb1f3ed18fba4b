// Limits of the numbers in a scene's objects, for the reader and for the schema that editors use.
#pragma once

#include <cstddef>

#include "state/fields.h"

namespace viewing {

inline constexpr std::size_t max_objects = 10'000;
inline constexpr Range position_range{-1e6, 1e6};
inline constexpr Range angle_range{-3600.0, 3600.0};  ///< degrees
inline constexpr Range scale_range{1e-6, 1e6};        ///< for the absolute value, since a negative scale mirrors
inline constexpr Range crease_range{0.0, 180.0};      ///< degrees
inline constexpr int max_resolution = 64;             ///< of a teapot
inline constexpr const char* formulas[] = {"coplanar"};

}  // namespace viewing
