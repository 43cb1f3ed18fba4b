// The parameters of lights, planes, shadows and reflections, with the switches that break them. Every default is
// correct. Read params.h for the rest.
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

/// A light: with w = 1, a point light at (x, y, z); with w = 0, a parallel light from the direction (x, y, z).
struct LightParams {
    glm::dvec4 position{2.6, 5.2, 2.2, 1.0};
    bool operator==(const LightParams&) const = default;
};

struct PlaneParams {
    glm::dvec4 equation{0.0, 1.0, 0.0, 0.0};
    double extent = 4.0;
    bool receives_shadow = true;
    bool mirrors = true;
    bool gloss = false;  ///< adds a highlight to the patch
    bool operator==(const PlaneParams&) const = default;
};

struct ShadowParams {
    bool enabled = true;
    Color color{0, 0, 0};
    double opacity = 0.5;  ///< the resulting opacity where the shadows of all lights overlap
    bool stencil_once = true, clip_to_receiver = true, clip_casters = true;
    ShadowOffset offset = ShadowOffset::polygon_offset;
    double offset_factor = -1.0, offset_units = -1.0, lift = 0.01;
    ShadowStyle style = ShadowStyle::blend;

    bool clip_at_light = true;                      ///< clips casters at the plane w = 0, which contains the light
    ShadowSign sign = ShadowSign::plane_dot_light;  ///< the factor of S; forced negates each vertex whose w is negative
    bool write_depth = false;                       ///< writes depth plus offset, so the plane's stored depths change
    bool own_stencil = true;                        ///< off: all planes share one value and all lights one bit
    bool operator==(const ShadowParams&) const = default;
};

struct ReflectionParams {
    bool enabled = true;
    double reflectance = 0.3;
    bool stencil = true;
    MirrorClip clip = MirrorClip::clip_distance;
    bool flip_winding = true, reflect_light = true;
    int bounces = 1;

    MirroredThing mirrored = MirroredThing::scene;  ///< what R mirrors; a mirrored camera's picture is flipped
    bool same_projection = true;                    ///< off: the mirrored camera uses the aspect ratio of a square
    double fovy = 0.0;  ///< of the picture in a mirror, in degrees, for perspective only; 0: the camera's fovy
    bool printed_by_rows = false;  ///< fills R by rows, like the lecture's code; GL reads them as columns
    bool mask_writes_depth = false;
    bool after_objects = false;  ///< draws the mirror last, and its mask without a depth test
    bool side_of_eye = true;     ///< off: mirrors the objects on the normal's side, wherever the eye is
    bool shadows = true;         ///< shows shadows in the mirror image
    bool operator==(const ReflectionParams&) const = default;
};

}  // namespace viewing
