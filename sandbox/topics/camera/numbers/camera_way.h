// The followed point in view space, in clip space, after the division and in the depth buffer, and the frustum plane
// that cuts it off. Pure; topics/matrices/shown/followed_point.h shows the numbers.
#pragma once

#include "frame/derive.h"

namespace viewing {

/// The six planes of the frustum, in order of precedence if several cut the point off.
enum class FrustumPlane { none, near, far, left, right, bottom, top };

struct CameraWay {
    glm::dvec3 point_view{0.0};           ///< V p
    glm::dvec4 point_clip{0.0};           ///< P V p
    std::optional<glm::dvec3> point_ndc;  ///< after ÷ w; none if w = 0
    FrustumPlane cut_by{};                ///< none: inside the frustum
    std::optional<double> window_depth;   ///< 0 … 1; none outside near … far
    std::uint32_t code = 0;               ///< the code of window_depth, in the state's format
};

/// Takes a world point through the state's V, P and depth mapping, mistakes included.
CameraWay camera_way(const Params& params, const Derived& derived, const glm::dvec3& point_world);

/// Returns the matrix of glViewport(0, 0, width, height) and glDepthRange(0, 1): from NDC to pixels, counted from the
/// lower left corner, and window depth. `zero_to_one`: the clip range of z is 0 … 1, otherwise −1 … 1.
glm::dmat4 window_from_ndc(const glm::dvec2& size_px, bool zero_to_one);

/// Returns what a frustum plane does to a point: "cut off by the near plane", in English; use tr() to show it.
const char* outcome_of(FrustumPlane plane);

}  // namespace viewing
