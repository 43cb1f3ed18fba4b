// Everything that a user can change, as one plain value that can be copied, compared, printed, parsed and undone. The
// defaults are the opening state. Names, order and units match the state file; fields.cpp has the ranges and
// explanations. Lengths are in world units, angles in degrees; coordinates are right-handed with y up. Read
// frame/derive.cpp next.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/look_at.h"
#include "geometry/navigation.h"
#include "geometry/projection.h"
#include "state/depth_params.h"
#include "state/light_params.h"
#include "state/scene_description.h"
#include "state/view_params.h"
#include "state/visibility_params.h"

namespace viewing {

/// The last two are the first two with an explicit window: glFrustum and glOrtho.
enum class ProjectionType { perspective, orthographic, frustum, orthographic_window };
enum class Theme { dark, light, projector };
enum class Language { en, ko };

struct CameraParams {
    glm::dvec3 position{3.9, 3.0, 6.6};
    double yaw = 30.6, pitch = -16.4, roll = 0.0;
    glm::dvec3 target{0.0, 0.75, 0.0};
    Navigation navigation = Navigation::fly;

    Angles angles() const { return {yaw, pitch, roll}; }
    /// Returns eye, center and up of this camera; the center is at the depth of the target or, if the target is not at
    /// least 0.1 in front of the eye, at a distance of 1.
    LookAt look_at() const;
    /// Sets position, angles and target from eye, center and up. Returns what makes them degenerate, if anything does.
    LookAtFault look(const LookAt& look_at);
    bool operator==(const CameraParams&) const = default;
};

struct ProjectionParams {
    ProjectionType type = ProjectionType::perspective;
    double fovy = 40.0, height = 6.0, near = 0.5, far = 40.0;  ///< far may be infinite: see may_have_infinite_far()
    double aspect = 0.0;  ///< aspect ratio (width ÷ height) that P assumes; 0: the view's own
    double left = -0.32, right = 0.32, bottom = -0.18, top = 0.18;  ///< the window; for a frustum, in the near plane

    bool is_orthographic() const {
        return type == ProjectionType::orthographic || type == ProjectionType::orthographic_window;
    }
    bool has_window() const { return type == ProjectionType::frustum || type == ProjectionType::orthographic_window; }
    /// Sets the type; leaves the window unchanged.
    void set_type(bool orthographic, bool window);
    Edges window() const { return {left, right, bottom, top}; }
    void set_window(const Edges& edges);
    /// Moves the near plane without changing the picture. A frustum's edges are measured in this plane, so they move,
    /// too.
    void move_near(double moved);
    /// Enlarges an orthographic picture about the view axis, by changing its window or its height.
    void scale_picture(double factor);
    /// Returns the same projection with the view axis in the middle of the picture: no window, but the same height.
    ProjectionParams centered() const;
    bool operator==(const ProjectionParams&) const = default;
};

struct CullParams {
    bool enabled = false;
    CullFace face = CullFace::back;
    FrontFace front_face = FrontFace::ccw;
    bool operator==(const CullParams&) const = default;
};

/// Matrices that replace V and P.
struct CameraOverrides {
    std::optional<glm::dmat4> view_from_world, clip_from_view;
    bool operator==(const CameraOverrides&) const = default;
};

/// Matrices that replace a plane's R, and its S for each light.
struct PlaneOverrides {
    std::optional<glm::dmat4> mirrored_world_from_world;
    std::array<std::optional<glm::dmat4>, most_lights> shadowed_world_from_world;
    bool operator==(const PlaneOverrides&) const = default;
};

/// The followed point: a vertex of an object in the scene, or any other point.
struct Follow {
    std::string object;
    int vertex = 0;
    std::optional<glm::dvec3> point = {};  ///< in world space, instead of object and vertex
    bool operator==(const Follow&) const = default;
};

struct ObserverParams {
    glm::dvec3 target{0.0, 1.0, 1.0};
    double yaw = -38.0, pitch = -30.0, distance = 16.0;
    bool light_rays = false;    ///< draws rays from the light through the outline's vertices to their shadows
    bool mirrored_eye = false;  ///< draws the mirrored eye, and the frustum through which it sees the mirror image
    bool image_space = false;   ///< draws the scene again, behind the mirror
    bool operator==(const ObserverParams&) const = default;
};

/// Common mistakes: each switch breaks navigation or a matrix.
struct SlipParams {
    bool walk_slows = false;          ///< walking moves along the view direction, then restores the height
    bool creeping_roll = false;       ///< walking and orbiting apply yaw and pitch about the camera's own axes
    bool pole_flip = false;           ///< orbit uses a look-at with a fixed up vector and no limit on pitch
    bool swapped_order = false;       ///< C = R T instead of T R
    bool camera_as_view = false;      ///< uploads C instead of V
    bool degrees_as_radians = false;  ///< P gets fovy in degrees instead of radians
    bool plus_2ab = false;            ///< row 2, column 1 of R is +2ab, as in one line of the slide
    bool normal_not_unit = false;     ///< fills R from (a, b, c, d) as entered, not divided by |n|
    bool shadow_by_rows = false;      ///< fills S by rows; GL reads them as columns
    bool oblique_in_world = false;    ///< the oblique near plane stays in world space; P needs it in view space
    bool operator==(const SlipParams&) const = default;
};

/// Motion while the window is open; pictures made without a window show the start of the motion.
struct AnimationParams {
    bool jiggle = false;        ///< jitters the camera so slightly that only depth fighting makes it visible
    bool light_orbit = false;   ///< the chosen light orbits the world's y axis
    double light_speed = 30.0;  ///< degrees per second; positive turns left
    bool operator==(const AnimationParams&) const = default;
};

struct UiParams {
    Theme theme = Theme::dark;
    double scale = 1.0;
    Language language = Language::en;  ///< belongs to the user: undo and opened files do not change it
    bool operator==(const UiParams&) const = default;
};

/// Indices of the chosen plane and light, always valid.
struct Choice {
    std::size_t plane = 0, light = 0;
    bool operator==(const Choice&) const = default;
};

struct Params {
    int version = 1;
    SceneSource scene = std::string("torus-and-boxes");
    CameraParams camera;
    ProjectionParams projection;
    DepthParams depth;
    CoplanarParams coplanar;
    CullParams cull;
    std::vector<LightParams> lights = std::vector<LightParams>(1);  ///< at least one
    std::vector<PlaneParams> planes = std::vector<PlaneParams>(1);  ///< at least one
    ShadowParams shadow;
    ReflectionParams reflection;
    CameraOverrides camera_overrides;
    std::array<PlaneOverrides, most_planes> overrides;  ///< for each plane
    std::optional<Follow> follow;
    VisibilityParams visibility;
    ViewParams view;
    ObserverParams observer;
    SlipParams slips;
    AnimationParams animation;
    UiParams ui;

    /// Returns the lens of P: that of a P entered by hand, if it has one, or else the lens that P is computed from. If
    /// slips.degrees_as_radians is on, fovy is read as radians. The field of view is then negative if cot(fovy/2) is,
    /// which rotates the picture by 180°. It is kept away from 0° and ±180°, so that P has an inverse.
    Lens lens() const;

    /// Returns the lens of the P entered by hand; none if there is no such P, or if no lens produces it.
    std::optional<Lens> lens_by_hand() const;

    /// Returns the state with a P entered by hand as its projection, if a lens produces that P: near, far and the edges
    /// are then those of the picture. The projection may have values outside the fields' ranges.
    Params with_projection_by_hand() const;

    /// Returns the factor by which reflection.fovy enlarges the picture in a mirror; 1 if the mirror uses the camera's
    /// fovy.
    double mirror_picture_scale() const;

    /// Returns whether GL compares depths. Otherwise, it does not write depth either.
    bool tests_depth() const { return depth.tests() && uses_gl_depth_test(visibility.method); }

    Choice chosen() const { return {index_of(view.plane, planes.size()), index_of(view.light, lights.size())}; }

    bool operator==(const Params&) const = default;

private:
    static std::size_t index_of(int number, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(number, 1, static_cast<int>(count)) - 1);
    }
};

}  // namespace viewing
