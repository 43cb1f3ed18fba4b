// Whether what is uploaded are numbers. Pixels of 8 bits hold no NaN, so it is looked for where it would come from.
#pragma once

#include "frame/derive.h"
#include "text/result.h"

namespace viewing {

/// The error names the first matrix of projection, view, shadows and mirrors that has an entry which is not finite as a
/// float.
Status check_finite(const Derived& derived);

}  // namespace viewing
