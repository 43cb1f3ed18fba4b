// Finds the object between a point of a surface and a light, and what a frame's shadow passes do there. Read why.h
// next.
#pragma once

#include <optional>

#include "topics/why/numbers/pixel_chain.h"

namespace viewing {

/// The first object between a point and a light, seen from the point.
struct Blocker {
    int object_index = -1;
    glm::dvec3 point_world{0.0};  ///< on the object, where the ray to the light meets it
};

/// Returns the object that the ray from the point to the light meets first; none if the light reaches the point.
/// A light with w = 0 is a direction. Objects nearer than a ten-thousandth of the scene's size do not count.
std::optional<Blocker> blocker(const FragmentFinder& finder, const glm::dvec3& point_world,
                               const glm::dvec4& light_world);

/// The position of a caster's point relative to a light and a plane.
enum class CasterPlace { between, behind_plane, beyond_light };
CasterPlace place_of(const DerivedPlane& plane, const CastShadow& cast, const glm::dvec3& caster_world);

/// The shadow of one light at a pixel: fragments of its shadow passes.
struct ShadowAtPixel {
    const Touch* first = nullptr;     ///< the first that passes; null: none passes
    const Touch* last = nullptr;      ///< the last that passes
    int passing = 0;                  ///< how many pass
    const Touch* rejected = nullptr;  ///< the first that the depth test rejects
};

/// Returns the shadow that a light casts on a plane at the chain's pixel, as seen through the mirrors `mirrors_met`.
ShadowAtPixel shadow_at(const FramePlan& plan, const PixelChain& chain, std::size_t plane, std::size_t light,
                        const std::vector<std::size_t>& mirrors_met);

}  // namespace viewing
