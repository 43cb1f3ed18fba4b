// The handles that the mouse can drag in a view: the chosen light, the chosen plane (which moves along its normal), the
// tip of that normal, and the followed point. Views from outside also have handles for the camera, its direction, its
// near and far planes, and, if the projection has an explicit window, the window's edges at the near plane.
#pragma once

#include <array>
#include <optional>

#include "frame/derive.h"
#include "ui/parts/overlay.h"

namespace viewing {

enum class Handle {
    none,
    light,
    plane_offset,
    plane_tilt,
    camera,
    direction,
    near_plane,
    far_plane,
    point,
    bottom,
    right,
    top,
    left
};

/// Returns the field that a handle changes; a lesson may lock the field and so the handle. Returns "" for none, and for
/// the camera and its direction, which are never locked, since flying changes the same fields anyway.
const char* field_of(Handle handle);

/// The position of each handle in the world.
struct HandlePlaces {
    glm::dvec3 light;  ///< the light, or a point along its direction if it is parallel or far away
    glm::dvec3 plane;  ///< the patch's center
    glm::dvec3 normal_tip;
    std::optional<glm::dvec3> point;  ///< the followed point

    /// The camera's handles, if the view shows the camera from outside.
    struct Camera {
        glm::dvec3 eye, direction_tip;
        std::array<glm::dvec3, 5> near, far;  ///< midpoints of the edges, then the center
        bool drags_near = true;               ///< false: P is entered by hand
        bool drags_far = true;                ///< false: P by hand, or infinite far; the frustum then ends at `far`
        bool has_window = false;              ///< true: `near` begins with the edges' handles, from Handle::bottom on
    };
    std::optional<Camera> camera;
};
HandlePlaces handle_places(const Derived& derived);
/// Returns the handles for an observer, including the camera's.
HandlePlaces observer_handle_places(const Params& params, const Derived& derived);

/// Returns where to draw a light: at its own position, or along its direction if it is parallel or far away.
glm::dvec3 lamp_place(const glm::dvec4& light_world, const Derived& derived);

/// A handle that is being dragged.
struct Grip {
    Handle handle = Handle::none;
    glm::dvec3 grabbed_world{0.0};  ///< its position when it was grabbed
    glm::dvec3 offset_world{0.0};   ///< from the pointer's ray to the handle, so that the handle does not jump
    glm::dvec3 center_world{0.0};   ///< the patch's center when it was grabbed
    glm::dvec4 equation{0.0};       ///< the plane when it was grabbed
};

/// Returns whether a point is within reach of a screen position.
bool is_at(const Overlay& overlay, const glm::dvec3& point, ImVec2 place);

/// Returns the nearest handle within reach of a screen position, or none.
Handle handle_at(const Overlay& overlay, const HandlePlaces& places, ImVec2 place);

/// Grabs a handle.
Grip take(const Overlay& overlay, const HandlePlaces& places, Handle handle, const Params& params, ImVec2 place);

/// Moves the handle with the pointer. The light, the camera, and the followed point move parallel to the picture or,
/// with `along_y`, only along the world's y axis. A dragged followed point is no longer a vertex. The plane moves along
/// its normal, the normal's tip around the patch's center, the camera's direction around its eye, and the near and far
/// planes along that direction. Preserves the length and sign of the plane's normal, near < far, and the camera's roll.
void drag(Params& params, const Overlay& overlay, const Grip& grip, ImVec2 place, bool along_y);

/// Draws the handles of the plane and of the camera, if it has any, with their labels.
void draw_plane_handles(Overlay& overlay, const HandlePlaces& places, Handle hovered);

/// Draws the chosen light's handle, and lamps without handles for the other lights, all with labels. A lamp outside the
/// picture becomes an arrow at the picture's edge.
void draw_light_handles(Overlay& overlay, const HandlePlaces& places, const Derived& derived, Handle hovered);

}  // namespace viewing
