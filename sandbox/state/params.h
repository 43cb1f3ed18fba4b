// Everything a person can change, as one plain value: copied, compared, printed, parsed, undone.
// The defaults here are the opening state. Names, order and units are those of the state file; ranges and
// explanations stand in fields.cpp. Lengths in world units, angles in degrees, y up, right-handed.
// Read frame/derive.cpp next.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "geometry/camera.h"
#include "geometry/navigation.h"
#include "geometry/projection.h"
#include "state/depth_params.h"
#include "state/light_params.h"
#include "state/scene_description.h"
#include "state/view_params.h"
#include "state/visibility_params.h"

namespace viewing {

enum class ProjectionType { perspective, orthographic };
enum class Theme { dark, light, projector };
enum class Language { en, ko };

struct CameraParams {
    glm::dvec3 position{3.9, 3.0, 6.6};
    double yaw = 30.6, pitch = -16.4, roll = 0.0;
    glm::dvec3 target{0.0, 0.75, 0.0};
    Navigation navigation = Navigation::fly;

    Angles angles() const { return {yaw, pitch, roll}; }
    bool operator==(const CameraParams&) const = default;
};

struct ProjectionParams {
    ProjectionType type = ProjectionType::perspective;
    double fovy = 40.0, height = 6.0, near = 0.5, far = 40.0;
    double aspect = 0.0;  ///< width : height that P is made for; 0: that of the view
    bool operator==(const ProjectionParams&) const = default;
};

struct CullParams {
    bool enabled = false;
    CullFace face = CullFace::back;
    FrontFace front_face = FrontFace::ccw;
    bool operator==(const CullParams&) const = default;
};

/// What is put in place of a plane's R, and of its S of each light.
struct PlaneOverrides {
    std::optional<glm::dmat4> mirrored_world_from_world;
    std::array<std::optional<glm::dmat4>, most_lights> shadowed_world_from_world;
    bool operator==(const PlaneOverrides&) const = default;
};

/// The followed point: a vertex of an object of the scene.
struct Follow {
    std::string object;
    int vertex = 0;
    bool operator==(const Follow&) const = default;
};

struct ObserverParams {
    glm::dvec3 target{0.0, 1.0, 1.0};
    double yaw = -38.0, pitch = -30.0, distance = 16.0;
    bool light_rays = false;    ///< from the light through the outline's vertices to their shadow
    bool mirrored_eye = false;  ///< and the frustum that it sees the mirror's image with
    bool image_space = false;   ///< the scene once more behind the mirror
    bool operator==(const ObserverParams&) const = default;
};

/// Famous slips: each a switch that breaks navigation or a matrix.
struct SlipParams {
    bool walk_slows = false;          ///< walking moves along the view direction, then sets the height back
    bool creeping_roll = false;       ///< walking and orbiting turn yaw and pitch both about the camera's own axes
    bool pole_flip = false;           ///< orbit uses a look-at with a fixed up and no limit on pitch
    bool swapped_order = false;       ///< C = R T in place of T R
    bool camera_as_view = false;      ///< uploads C where V belongs
    bool degrees_as_radians = false;  ///< P is given fovy's number of degrees where it takes radians
    bool plus_2ab = false;            ///< row 2, column 1 of R is +2ab, as one line of the slide has it
    bool normal_not_unit = false;     ///< R from (a, b, c, d) as they are typed, not divided by |n|
    bool operator==(const SlipParams&) const = default;
};

/// What moves by itself while the window is open; pictures without a window show its beginning.
struct AnimationParams {
    bool jiggle = false;        ///< the camera trembles by so little that only depth fighting shows it
    bool light_orbit = false;   ///< the chosen light turns about the world's y axis
    double light_speed = 30.0;  ///< degrees a second, positive to the left
    bool operator==(const AnimationParams&) const = default;
};

struct UiParams {
    Theme theme = Theme::dark;
    double scale = 1.0;
    Language language = Language::en;  ///< the person's: neither undone nor changed by what is opened
    bool operator==(const UiParams&) const = default;
};

/// Indices of the plane and the light that are looked at more closely, never beyond their lists.
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
    std::array<PlaneOverrides, most_planes> overrides;  ///< of each plane
    std::optional<Follow> follow;
    VisibilityParams visibility;
    ViewParams view;
    ObserverParams observer;
    SlipParams slips;
    AnimationParams animation;
    UiParams ui;

    /// What P is made of, the slip of degrees taken for radians included: where cot(fovy/2) is negative, which turns
    /// the picture upside down, the angle of view is negative; it keeps off 0° and ±180°, so that P has an inverse.
    Lens lens() const;

    Choice chosen() const { return {index_of(view.plane, planes.size()), index_of(view.light, lights.size())}; }

    bool operator==(const Params&) const = default;

private:
    static std::size_t index_of(int number, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(number, 1, static_cast<int>(count)) - 1);
    }
};

}  // namespace viewing
