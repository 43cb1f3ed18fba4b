// What stands how far from the eye in the camera's picture, and whether near could be better. Pure;
// ui/depth/precision_view.h shows it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/derive.h"

namespace viewing {

/// An object of the scene, or the plane's patch, and the eye distances of the part of it that near does not matter to:
/// within the four sides of the view, before the eye and not beyond far.
struct SeenThing {
    std::string name;
    double nearest = 0.0, farthest = 0.0;
    bool is_plane = false;  ///< the patch
};

/// What is in view, in the order of the scene, then the patch. Exact: every triangle is cut.
std::vector<SeenThing> seen_things(const Params& params, const Derived& derived, const Scene& scene);

/// Things at nearly the same distance under one name.
struct DistanceMark {
    std::string label;  ///< the nearest one's name, and how many more: "torus +2"
    double z = 0.0;     ///< where that one begins
    bool is_plane = false;
};
/// From near to far, at most so many (at least 1): what is nearest to each other, in proportion, shares a mark first.
std::vector<DistanceMark> distance_marks(const std::vector<SeenThing>& seen, std::size_t most);

/// A better near for what is in view.
struct NearAdvice {
    bool cuts = false;           ///< near is too large and cuts something off; else it is wastefully small
    std::optional<double> near;  ///< what it should be; none where something reaches up to the eye
    std::string sentence;
};

/// None where near is fine: nothing is cut and there is no factor 4 to be won at the farthest thing in view. None for
/// an orthographic lens, where near costs nothing, or when nothing is in view; with logarithmic depth, where it costs
/// little, only if something is cut. What it proposes is nearer than everything in view.
std::optional<NearAdvice> near_advice(const Params& params, const Derived& derived, const std::vector<SeenThing>& seen);
std::optional<NearAdvice> near_advice(const Params& params, const Derived& derived, const Scene& scene);

/// The largest near, to two digits, with which all that is in view is kept, and a margin for a small move of the
/// camera. None where nothing is in view, or something reaches up to the eye.
std::optional<double> largest_near(const std::vector<SeenThing>& seen);

/// Down to two significant digits; `value` is above 0.
double rounded_down(double value);

}  // namespace viewing
