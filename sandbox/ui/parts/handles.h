// What can be taken with the mouse inside a view: the chosen light, the chosen plane along its normal, the tip of its
// normal; and, where it is seen from outside, the camera, where it looks, and its near and far planes.
#pragma once

#include <array>
#include <optional>

#include "frame/derive.h"
#include "ui/parts/overlay.h"

namespace viewing {

enum class Handle { none, light, plane_offset, plane_tilt, camera, direction, near_plane, far_plane };

/// The field that it moves; "" of the camera's own, which flying moves as well.
const char* field_of(Handle handle);

/// Where each handle is in the world.
struct HandlePlaces {
    glm::dvec3 light;  ///< the light, or a place along its direction when it is parallel
    glm::dvec3 plane;  ///< the patch's centre
    glm::dvec3 normal_tip;

    /// The camera's, where it is seen from outside.
    struct Camera {
        glm::dvec3 eye, direction_tip;
        std::array<glm::dvec3, 5> near, far;  ///< middles of the edges, then of the whole
    };
    std::optional<Camera> camera;
};
HandlePlaces handle_places(const Derived& derived);
/// With those of the camera, for an observer.
HandlePlaces observer_handle_places(const Params& params, const Derived& derived);

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

/// Moves it with the pointer: light and camera parallel to the picture (`along_y`: up and down only), the plane along
/// its normal, the normal's tip about the patch's centre, the camera's direction about its eye, near and far along that
/// direction. The equation keeps its length and sign, the camera its roll, and near stays before far.
void drag(Params& params, const Overlay& overlay, const Grip& grip, ImVec2 place, bool along_y);

/// Draws them with their labels, and the lamps of the other lights, which have no handle. A lamp outside the picture is
/// an arrow at its edge.
void draw_handles(Overlay& overlay, const HandlePlaces& places, const Derived& derived, Handle hovered);

}  // namespace viewing
