// The options of the hidden-surface methods. They are defined only here, stored in the parameters, and used by the
// methods. Read polygons.h next.
#pragma once

namespace viewing {

/// The eye distance that represents a polygon in the painter's order: that of its nearest or farthest vertex, or of its
/// centroid.
enum class PainterKey { nearest, farthest, centroid };

/// The polygon whose plane divides a BSP node: the first in the node's list; a random one; or, among some evenly chosen
/// candidates, the one that cuts the fewest others, or the one whose larger child is smallest.
enum class BspSplitter { first, random, fewest_splits, balanced };

/// The order in which the two sides of a BSP node's plane are drawn: the side that the eye is on comes last
/// (back_to_front) or first (front_to_back).
enum class BspOrder { back_to_front, front_to_back };

/// The winding of front faces on the screen, as for glFrontFace.
enum class FrontFace { ccw, cw };

/// The faces to cull, as for glCullFace.
enum class CullFace { front, back, front_and_back };

}  // namespace viewing
