// Checks that uploaded matrices are finite. 8-bit pixels cannot store NaN, so the check examines the matrices instead.
#pragma once

#include "frame/derive.h"
#include "text/result.h"

namespace viewing {

/// Checks the matrices of the projection, the view, the shadows and the mirrors. Returns an error that names the first
/// one with an entry that is not finite as a float.
Status check_finite(const Derived& derived);

}  // namespace viewing
