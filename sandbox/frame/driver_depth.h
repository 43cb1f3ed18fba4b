// A driver's implementation of the depth formats: GL does not define how many bits a format has or how large a unit of
// glPolygonOffset is. See render/stored_depth.h for the measurement.
#pragma once

#include <optional>

#include "geometry/projection.h"

namespace viewing {

struct StoredDepth {
    DepthPrecision precision;  ///< as stored: {32, true} is float32
    /// Codes per unit of glPolygonOffset; for a float format, codes as wide as those between 1/2 and 1. A multiple of
    /// 1/4 from 0 to 16. None if not measured.
    std::optional<double> unit_codes;
    bool operator==(const StoredDepth&) const = default;
};

}  // namespace viewing
