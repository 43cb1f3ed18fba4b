// What a driver makes of the depth formats: GL leaves open how many bits are behind a name and how much a unit of
// glPolygonOffset is. Read render/driver_depth.h for how it is measured.
#pragma once

#include <optional>

#include "geometry/projection.h"

namespace viewing {

struct StoredDepth {
    DepthPrecision precision;  ///< what is stored: {32, true} is a float32
    /// Codes that one unit of glPolygonOffset is, of a float those between 1/2 and 1; a multiple of 1/4, 0 to 16. None
    /// where it was not measured.
    std::optional<double> unit_codes;
    bool operator==(const StoredDepth&) const = default;
};

}  // namespace viewing
