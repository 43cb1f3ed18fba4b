// The part of the parameters that says where light, planes, shadows and mirror images are, with the switches that break
// them. Every switch is right as it is by default. Read params.h for the rest.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>

#include "state/scene_description.h"

namespace viewing {

enum class ShadowOffset { none, polygon_offset, lift, no_depth_test };
enum class ShadowStyle { blend, missing_light };
enum class ShadowSign { plane_dot_light, none, forced };
enum class MirrorClip { none, clip_distance, oblique };
enum class MirroredThing { scene, camera };

inline constexpr std::size_t most_lights = 4, most_planes = 8;

/// w = 1 a point light at (x, y, z), w = 0 a parallel light from the direction (x, y, z).
struct LightParams {
    glm::dvec4 position{2.6, 5.2, 2.2, 1.0};
    bool operator==(const LightParams&) const = default;
};

struct PlaneParams {
    glm::dvec4 equation{0.0, 1.0, 0.0, 0.0};
    double extent = 4.0;
    bool receives_shadow = true;
    bool mirrors = true;
    bool gloss = false;  ///< its patch has a highlight
    bool operator==(const PlaneParams&) const = default;
};

struct ShadowParams {
    bool enabled = true;
    Color color{0, 0, 0};
    double opacity = 0.5;  ///< of all lights' shadows together
    bool stencil_once = true, clip_to_receiver = true, clip_casters = true;
    ShadowOffset offset = ShadowOffset::polygon_offset;
    double offset_factor = -1.0, offset_units = -1.0, lift = 0.01;
    ShadowStyle style = ShadowStyle::blend;

    bool clip_at_light = true;                      ///< casters, by the light's own plane parallel to the plane
    ShadowSign sign = ShadowSign::plane_dot_light;  ///< what S is multiplied by: forced is each vertex's own w
    bool write_depth = false;                       ///< with its offset
    bool own_stencil = true;                        ///< a value for each plane and a bit for each light
    bool operator==(const ShadowParams&) const = default;
};

struct ReflectionParams {
    bool enabled = true;
    double reflectance = 0.3;
    bool stencil = true;
    MirrorClip clip = MirrorClip::clip_distance;
    bool flip_winding = true, reflect_light = true;
    int bounces = 1;

    MirroredThing mirrored = MirroredThing::scene;  ///< the scene by R, or the camera, and the picture flipped
    bool same_projection = true;                    ///< off: the mirrored camera sees with the aspect of a square
    bool printed_by_rows = false;  ///< R as the lecture's code fills it: by rows, which GL reads as columns
    bool mask_writes_depth = false;
    bool after_objects = false;  ///< the mirror is drawn last, and its mask without a depth test
    bool side_of_eye = true;     ///< off: what lies on the side of the normal is mirrored, wherever the eye is
    bool shadows = true;         ///< inside the mirror
    bool operator==(const ReflectionParams&) const = default;
};

}  // namespace viewing
