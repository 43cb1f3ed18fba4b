// Projection matrices, and the path from eye depth to a stored code.
// Eye distance is positive in front of the camera: distance = −eye_z.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <optional>

namespace viewing {

enum class DepthMapping { standard, reversed, logarithmic };

/// The edges of a picture, in world units to the right of and above the view axis.
struct Edges {
    double left = -1.0, right = 1.0, bottom = -1.0, top = 1.0;

    double width() const { return right - left; }
    double height() const { return top - bottom; }
    double aspect() const { return width() / height(); }
    glm::dvec2 center() const { return {0.5 * (left + right), 0.5 * (bottom + top)}; }
    /// Returns the point at `ndc`: (−1, −1) is left and bottom, (1, 1) right and top.
    glm::dvec2 at(const glm::dvec2& ndc) const { return center() + 0.5 * ndc * glm::dvec2(width(), height()); }
    Edges scaled(double factor) const { return {left * factor, right * factor, bottom * factor, top * factor}; }
    bool operator==(const Edges&) const = default;
};

struct Lens {
    bool orthographic = false;
    double fovy_deg = 40.0;  ///< full vertical angle, perspective only; negative: the picture is rotated by 180°
    double height = 6.0;     ///< full vertical size in world units, orthographic only
    double near = 0.5;       ///< orthographic: may be 0 or negative, as in glOrtho
    double far = 40.0;       ///< may be infinite in perspective, unless depth is logarithmic
    std::optional<Edges> window = {};  ///< perspective: at the near plane, as in glFrustum; orthographic: as in glOrtho

    /// Returns the picture's edges at an eye distance. A lens with an explicit window ignores `aspect` (width /
    /// height). With a negative fovy, left > right and bottom > top.
    Edges edges_at(double distance, double aspect) const;
    double reach = 100.0;  ///< the distance where pictures and charts end if far is infinite

    bool is_infinite() const { return std::isinf(far); }
    /// Returns the distance at which pictures and charts end: far or, if far is infinite, `reach`.
    double shown_far() const { return is_infinite() ? reach : far; }
    /// Returns f n / (f − n), which is n for an infinite f: window depth changes by this value ÷ z² per unit.
    double depth_per_inverse_distance() const { return is_infinite() ? near : far * near / (far - near); }
    /// Returns the distance at which logarithmic depth ends: far or, if far is infinite, the largest finite far.
    double logarithmic_far() const { return is_infinite() ? 1e9 : far; }
    /// Returns the distance at which logarithmic depth starts: near or, if near ≤ 0, a millionth of far.
    double logarithmic_near() const { return near > 0.0 ? near : 1e-6 * far; }
    bool operator==(const Lens&) const = default;
};

/// Returns P for a clip range of −1 … 1 (near → −1, far → +1). `aspect` = width / height; a lens with its own window
/// ignores it.
glm::dmat4 clip_from_view(const Lens& lens, double aspect);

/// Returns P with near and far swapped, for a clip range of 0 … 1: near → 1, far → 0.
glm::dmat4 clip_from_view_reversed(const Lens& lens, double aspect);

/// Returns the lens, with an explicit window, whose P equals this matrix up to a positive factor; none if there is no
/// such lens. `ndc_near`, `ndc_far`: the z ÷ w to which the matrix maps near and far. The lens may have near > far or
/// near ≤ 0; if it is perspective, its window is at the nearer of the two. Entries up to `tolerance` count as 0.
std::optional<Lens> lens_of(const glm::dmat4& clip_from_view, double ndc_near, double ndc_far, double tolerance);

/// Returns the eye of a camera: the point with w = 1 that P V sends to x = y = w = 0 or, if its rays are parallel, the
/// direction toward the eye, with w = 0. None if P V has no such point. `reversed`: nearer points have the larger z.
std::optional<glm::dvec4> eye_of(const glm::dmat4& clip_from_world, bool reversed);

/// Returns the window depth of an eye distance. It is in [0, 1] from near to far and outside [0, 1] elsewhere. At or
/// behind the eye, it is infinite unless the mapping is linear.
double window_depth(const Lens& lens, DepthMapping mapping, double distance);

/// Returns the inverse of window_depth.
double distance_of_window_depth(const Lens& lens, DepthMapping mapping, double depth);

/// The precision of a depth buffer: a number of bits, or a 32-bit float.
struct DepthPrecision {
    int bits = 24;
    bool is_float = false;

    /// Returns 2^bits − 1, the code of window depth 1; for integer formats.
    double greatest_code() const { return std::exp2(bits) - 1.0; }
    bool operator==(const DepthPrecision&) const = default;
};

/// Returns the width of the step from a stored window depth to the next code, measured in window depth.
double code_width(const DepthPrecision& precision, double window_depth);

/// Returns the width in eye distance of one stored code at `distance` (Δz ≈ z² (f−n) / (f n (2^b − 1))); for a float
/// format, of one unit in the last place of the stored depth. The result is positive and finite, because a distance
/// below `near` counts as `near`. Beyond `far`, the formula still applies.
double depth_step(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision, double distance);

/// Returns depth_step, but for a float format at least half a unit in the last place of a float32 at `distance`: the
/// eye depth is rounded to float32 before it is mapped and stored, so finer codes near a window depth of 0 add no
/// precision.
double resolvable_depth_step(const Lens& lens, DepthMapping mapping, const DepthPrecision& precision, double distance);

/// Returns the full vertical angle, in degrees, that gives a picture of `aspect` the same horizontal angle as a picture
/// of `least_aspect` and `fovy_deg`; `fovy_deg` itself if `aspect` is at least `least_aspect`.
double widened_fovy(double fovy_deg, double aspect, double least_aspect);

}  // namespace viewing
