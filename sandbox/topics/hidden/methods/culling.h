// Back-face culling, the cheapest step before any of the methods: polygons that face away are not drawn. The decision
// depends either on which side of the plane the eye is on, in world space, or on the sign of the area on the screen, as
// in GL. Read painter.h next. Source: lecture, Hidden Surface Removal; OpenGL 3.3, 2.18.1 and 3.6.1.
#pragma once

#include <span>
#include <vector>

#include "topics/hidden/methods/choices.h"
#include "topics/hidden/methods/polygons.h"
#include "topics/hidden/methods/viewpoint.h"

namespace viewing {

/// The way a polygon faces; `neither` if the eye is in its plane, or if no part of the polygon is in view.
enum class Facing : char { towards, away, neither };

/// Decides based on which side of each plane the eye is on; the results are in the polygons' order. The eye counts as
/// in the plane (neither) if it is within default_epsilon() of it or, for an orthographic camera, if the sine of the
/// angle between the view direction and the plane is at most 1e−12.
std::vector<Facing> facing_by_plane(std::span<const Polygon> polygons, const Viewpoint& viewpoint,
                                    FrontFace front = FrontFace::ccw);

/// Counts of polygons by facing, decided once by the plane and once as in GL; each group of three adds up to `input`.
struct CullCounts {
    int input = 0;
    int facing_towards = 0, facing_away = 0, edge_on = 0;
    int gl_front = 0, gl_back = 0, gl_none = 0;
    int disagree = 0;  ///< called front-facing by one test and back-facing by the other; 0 except for rounding errors
};

/// Counts how polygons face. If canceled, counts only the first polygons.
CullCounts count_facing(std::span<const Polygon> polygons, const Viewpoint& viewpoint, FrontFace front = FrontFace::ccw,
                        const WorkProgress* progress = nullptr);

/// Returns the polygons that culling leaves, in the same order; facing_by_plane() says which way each one faces. A
/// polygon seen edge-on is neither front-facing nor back-facing: it stays, but covers no pixel. front_and_back leaves
/// nothing. If canceled, considers only the first polygons.
std::vector<Polygon> culled(std::span<const Polygon> polygons, const Viewpoint& viewpoint, CullFace faces,
                            FrontFace front = FrontFace::ccw, const WorkProgress* progress = nullptr);

}  // namespace viewing
