// The names of the methods' options, for choices and sentences. Each list is in the order of its enumeration.
#pragma once

#include "text/catalogue.h"

namespace viewing {

/// In the order of PainterKey.
inline constexpr const char* sort_key_names[] = {marked("nearest vertex"), marked("farthest vertex"),
                                                 marked("centroid")};

/// In the order of BspSplitter.
inline constexpr const char* splitter_names[] = {marked("first"), marked("random"), marked("fewest splits"),
                                                 marked("balanced")};

/// In the order of BspOrder.
inline constexpr const char* walk_names[] = {marked("back to front"), marked("front to back")};

}  // namespace viewing
