// Computes the color that a pass gives to a surface at one pixel, as the fragment shader does, with the contribution of
// each light. See shaders/surface_light.glsl for the formula.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "topics/depth/numbers/fragments.h"

namespace viewing {

/// The light that one source adds to a surface.
struct LightShare {
    std::size_t light = 0;        ///< index in Derived::lights_world
    double cosine = 0.0;          ///< n · l̂, both unit vectors; not positive: the surface faces away
    glm::dvec3 adds_linear{0.0};  ///< linear light: diffuse and highlight
    double highlight = 0.0;       ///< the highlight's part of adds_linear
};

struct SurfaceColor {
    glm::dvec3 srgb{0.0};  ///< 0 … 1, as the pass sends it to blending
    double alpha = 1.0;
    glm::dvec3 albedo_linear{0.0};   ///< lit and unlit shading only, like all that follows
    glm::dvec3 ambient_linear{0.0};  ///< added by ambient light
    std::vector<LightShare> lights;
};

/// Returns the color of a fragment that everything_at() found at this pixel. The colors of heat maps are not computed:
/// the result is black.
SurfaceColor surface_color(const FramePlan& plan, const Scene& scene, const Fragment& fragment, glm::ivec2 pixel,
                           glm::ivec2 size_px);

glm::dvec3 srgb_from_linear(const glm::dvec3& linear);

}  // namespace viewing
