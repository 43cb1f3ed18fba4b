// The list of lower views. ui/views/lower_view.h declares an entry for each, which says how it is named, drawn and
// measured.
#pragma once

#include "state/closed_set.h"

/// Applies VIEW to the name of each lower view, spelled as in state files, in the order of the window's list. Applies
/// UNPRINTED instead to the views that are not exported as pictures: `depth`, since its picture is the camera's depth
/// buffer, and `growth`, since it shows measured times.
#define VIEWING_LOWER_VIEWS(VIEW, UNPRINTED) \
    VIEW(observer)                           \
    UNPRINTED(depth)                         \
    VIEW(histogram)                          \
    VIEW(precision)                          \
    VIEW(codes)                              \
    VIEW(pixel)                              \
    VIEW(cells)                              \
    VIEW(fighting)                           \
    VIEW(moving_world)                       \
    VIEW(passes)                             \
    VIEW(tree)                               \
    VIEW(order)                              \
    UNPRINTED(growth)                        \
    VIEW(shadow_derivation)                  \
    VIEW(mirror_derivation)                  \
    VIEW(lecture_code)                       \
    VIEW(mirror_ways)                        \
    VIEW(from_light)                         \
    VIEW(display_code)                       \
    VIEW(why)                                \
    VIEW(clip)                               \
    VIEW(way)

namespace viewing {

/// The content of one of the two views below the camera view; `automatic` depends on the hidden-surface method.
enum class Topic { automatic, VIEWING_LOWER_VIEWS(VIEWING_ENUMERATOR, VIEWING_ENUMERATOR) };

}  // namespace viewing
