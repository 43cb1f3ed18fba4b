// The spaces between eye and window, seen from outside: the views "Clip space" and "The path of a point". For each
// space, a projective map takes eye space to a cube from −1 to 1 around the origin, which an outside camera looks at.
#pragma once

#include "frame/derive.h"

namespace viewing {

/// Returns the projective map from eye space to the space that the view "Clip space" shows, in homogeneous coordinates.
/// With view.division = 0, this space is eye space, moved and scaled to the size of a cube from −1 to 1 around the
/// origin; with 1, it is NDC, centered, with near toward +z. In between, the two matrices are blended entry by entry,
/// so straight lines stay straight, and each point is divided by a blend of a constant and its clip w.
glm::dmat4 division_from_view(const Params& params, const Derived& derived);

/// Derives the view of the space of division_from_view() from outside, at the observer's angles. Only clip_from_world
/// belongs to the outside camera; the other members describe the state's camera.
ObserverView derive_clip_view(const Params& params, const Derived& derived, const Viewport& viewport);

/// The steps of view.way: the matrices and the division between the world, eye space, clip space, NDC and the window.
constexpr int way_steps = 4;

/// Returns the projective map from the world to the space that view.way has reached: the world, moved and scaled to
/// the observer's distance; eye space and NDC as in division_from_view; clip space without its z, as (x, y, −w), in
/// which the frustum's side faces are x = ±w and y = ±w; and the window, a box as wide as the picture. From the world
/// to eye space, the world turns, moves and changes size, but keeps its shape; the other matrices are blended entry by
/// entry.
glm::dmat4 way_from_world(const Params& params, const Derived& derived);

/// Derives the view of way_from_world()'s space from outside, at the observer's angles; for the window, from the front.
/// `free`: the part of the picture to use, in the picture's NDC.
ObserverView derive_way_view(const Params& params, const Derived& derived, const Viewport& viewport,
                             const Edges& free = {});

}  // namespace viewing
