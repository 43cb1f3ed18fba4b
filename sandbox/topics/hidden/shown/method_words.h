// The names of the methods' options, for choices and sentences.
#pragma once

#include "text/catalogue.h"
#include "text/per_enum.h"
#include "topics/hidden/methods/choices.h"

namespace viewing {

inline constexpr auto sort_key_names =
    per_enum<PainterKey>(marked("nearest vertex"), marked("farthest vertex"), marked("centroid"));

inline constexpr auto splitter_names =
    per_enum<BspSplitter>(marked("first"), marked("random"), marked("fewest splits"), marked("balanced"));

inline constexpr auto walk_names = per_enum<BspOrder>(marked("back to front"), marked("front to back"));

}  // namespace viewing
