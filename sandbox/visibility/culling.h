// Back-face culling, the cheapest step before any of the methods: polygons that turn their back are not drawn. Told in
// two ways: by the eye's side of the plane, in world space, and by the sign of the area on the screen, as GL does it.
// Read painter.h next. Source: lecture, Hidden Surface Removal; OpenGL 3.3, 2.18.1 and 3.6.1.
#pragma once

#include <span>
#include <vector>

#include "visibility/choices.h"
#include "visibility/polygons.h"
#include "visibility/viewpoint.h"

namespace viewing {

/// Which side of a polygon is seen; neither when the eye lies in its plane, or nothing of it is left to see.
enum class Facing : char { towards, away, neither };

/// By the eye's side of each plane, in the polygons' order. Within default_epsilon() of the plane, or for an
/// orthographic camera below a sine of 1e−12, the eye counts as in it: neither.
std::vector<Facing> facing_by_plane(std::span<const Polygon> polygons, const Viewpoint& viewpoint,
                                    FrontFace front = FrontFace::ccw);

/// By the sign of the area on the screen, of what is in front of the near plane. Neither: all of it is clipped, or its
/// area is at most 1e−12 of the square of its size there. In a mirrored view clockwise and counter-clockwise change
/// places on the screen, and this way is told the other winding, as GL is.
std::vector<Facing> facing_on_screen(std::span<const Polygon> polygons, const Viewpoint& viewpoint,
                                     FrontFace front = FrontFace::ccw);

/// How many polygons face where, by the plane and as GL tells it; each three add up to `input`.
struct CullCounts {
    int input = 0;
    int facing_towards = 0, facing_away = 0, edge_on = 0;
    int gl_front = 0, gl_back = 0, gl_none = 0;
    int disagree = 0;  ///< polygons that one way calls a front and the other a back: none, but for rounding
};

/// Cancelled: of the first of them.
CullCounts count_facing(std::span<const Polygon> polygons, const Viewpoint& viewpoint, FrontFace front = FrontFace::ccw,
                        const WorkProgress* progress = nullptr);

/// What is left after culling by the plane's sign, in the same order. What is seen edge-on is neither a front nor a
/// back: it stays, and covers no pixel; front_and_back leaves nothing. Cancelled: of the first of them.
std::vector<Polygon> culled(std::span<const Polygon> polygons, const Viewpoint& viewpoint, CullFace faces,
                            FrontFace front = FrontFace::ccw, const WorkProgress* progress = nullptr);

}  // namespace viewing
