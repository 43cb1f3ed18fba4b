// Checks that uploaded matrices are finite. Pixels of 8 bits cannot store NaN, so the check examines the matrices.
#pragma once

#include "frame/derive.h"
#include "text/result.h"

namespace viewing {

/// Returns an error that names the first matrix of projection, view, shadows and mirrors with an entry that is not
/// finite as a float.
Status check_finite(const Derived& derived);

}  // namespace viewing
