// What can be chosen about the methods: said here once, kept by the parameters, and obeyed by the methods.
// Read polygons.h next.
#pragma once

namespace viewing {

/// Which eye distance of a polygon stands for it in the painter's order: of its nearest vertex, its farthest, or its
/// centroid.
enum class PainterKey { nearest, farthest, centroid };

/// Which polygon of a list gives the plane of a BSP node: its first one; one by chance; of some evenly taken candidates
/// the one that cuts fewest others, or the one whose larger child is smallest.
enum class BspSplitter { first, random, fewest_splits, balanced };

/// Which side of a BSP node's plane is drawn first: that of the eye last, or first.
enum class BspOrder { back_to_front, front_to_back };

/// Which way round the corners of a front go on the screen: what glFrontFace is told.
enum class FrontFace { ccw, cw };

/// What glCullFace is told.
enum class CullFace { front, back, front_and_back };

}  // namespace viewing
