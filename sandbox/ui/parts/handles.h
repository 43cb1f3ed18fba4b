// What can be taken with the mouse inside a view: the chosen light, the chosen plane along its normal, the tip of its
// normal.
#pragma once

#include "frame/derive.h"
#include "ui/parts/overlay.h"

namespace viewing {

enum class Handle { none, light, plane_offset, plane_tilt };

/// Where each handle is in the world.
struct HandlePlaces {
    glm::dvec3 light;  ///< the light, or a place along its direction when it is parallel
    glm::dvec3 plane;  ///< the patch's centre
    glm::dvec3 normal_tip;
};
HandlePlaces handle_places(const Derived& derived);

/// Where a light is drawn: itself, or a place along its direction when it is parallel.
glm::dvec3 lamp_place(const glm::dvec4& light_world, const Derived& derived);

/// A handle that is being dragged.
struct Grip {
    Handle handle = Handle::none;
    glm::dvec3 grabbed_world{0.0};  ///< where the handle was when it was taken
    glm::dvec3 offset_world{0.0};   ///< from the pointer's ray to the handle, so that nothing jumps
    glm::dvec3 center_world{0.0};   ///< the patch's centre then
    glm::dvec4 equation{0.0};       ///< the plane then
};

/// The handle nearest to a place on screen, within reach; none otherwise.
Handle handle_at(const Overlay& overlay, const HandlePlaces& places, ImVec2 place);

/// Takes a handle.
Grip take(const Overlay& overlay, const HandlePlaces& places, Handle handle, const Params& params, ImVec2 place);

/// Moves it with the pointer: the light parallel to the picture (`along_y`: up and down only), the plane along its
/// normal, the normal's tip about the patch's centre. The equation keeps its length and sign.
void drag(Params& params, const Overlay& overlay, const Grip& grip, ImVec2 place, bool along_y);

/// Draws them with their labels, and the lamps of the other lights, which have no handle.
void draw_handles(Overlay& overlay, const HandlePlaces& places, const Derived& derived, Handle hovered);

}  // namespace viewing
