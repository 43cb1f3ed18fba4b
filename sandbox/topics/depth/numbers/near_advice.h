// Finds the eye distances of the things in the camera's picture, and proposes a better near if there is one. Pure;
// topics/depth/shown/precision_view.h shows the result.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/derive.h"
#include "text/message.h"

namespace viewing {

/// An object of the scene or the plane's patch, with the eye distances of the part in view. Near does not matter here:
/// that part is within the four sides of the view, in front of the eye, and not beyond far.
struct SeenThing {
    std::string name;  ///< in English
    double nearest = 0.0, farthest = 0.0;
    bool is_plane = false;  ///< the patch
};

/// Returns the things in view, in the order of the scene, then the patch. Exact: clips every triangle.
std::vector<SeenThing> seen_things(const Params& params, const Derived& derived, const Scene& scene);

/// One mark for things at nearly the same distance.
struct DistanceMark {
    Message label;   ///< name of the nearest thing, and the number of others: "torus +2"
    double z = 0.0;  ///< eye distance at which the nearest thing begins
    bool is_plane = false;
};
/// Returns at most `most` marks (0 counts as 1), from near to far. Neighbors whose distances have the smallest ratio
/// are merged first.
std::vector<DistanceMark> distance_marks(const std::vector<SeenThing>& seen, std::size_t most);

/// A better near for the things in view.
struct NearAdvice {
    bool cuts = false;           ///< near is too large and clips something; else it is wastefully small
    std::optional<double> near;  ///< the proposed value; none if something reaches the eye
    Message sentence;
};

/// Returns nothing if near is fine: it clips nothing, and a larger near would not make depth 4 times finer at the
/// farthest thing in view. Returns nothing for an orthographic lens, where near costs no precision, or if nothing is in
/// view; with logarithmic depth, where near costs little, returns advice only if something is clipped. The proposed
/// near is nearer than everything in view.
std::optional<NearAdvice> near_advice(const Params& params, const Derived& derived, const std::vector<SeenThing>& seen);
std::optional<NearAdvice> near_advice(const Params& params, const Derived& derived, const Scene& scene);

/// Returns the largest near, to two digits, that keeps everything in view, with a margin for a small camera move. None
/// if nothing is in view or something reaches the eye.
std::optional<double> largest_near(const std::vector<SeenThing>& seen);

/// Rounds down to two significant digits; `value` is positive.
double rounded_down(double value);

}  // namespace viewing
