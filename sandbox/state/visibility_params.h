// The parameters of the hidden-surface methods. See params.h for the rest.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "state/closed_set.h"
#include "topics/hidden/methods/choices.h"

/// Applies ENTRY to the name of each hidden-surface method, spelled as in state files.
/// topics/hidden/numbers/hidden_method.h declares an entry for each, which says what the method does and how it is
/// named.
#define VIEWING_METHODS(ENTRY) \
    ENTRY(depth_buffer) ENTRY(none) ENTRY(painter) ENTRY(newell) ENTRY(bsp) ENTRY(software_depth_buffer) ENTRY(ray_cast)

namespace viewing {

enum class VisibilityMethod { VIEWING_METHODS(VIEWING_ENUMERATOR) };

/// The method whose pictures are correct, so that other pictures are compared with them.
inline constexpr VisibilityMethod reference_method = VisibilityMethod::ray_cast;

struct VisibilityParams {
    VisibilityMethod method = VisibilityMethod::depth_buffer;
    int step = -1;  ///< stops after this many steps; −1: runs all steps
    PainterKey sort_key = PainterKey::farthest;
    BspSplitter splitter = BspSplitter::fewest_splits;
    BspOrder walk = BspOrder::back_to_front;
    double epsilon = 1e-9;      ///< points nearer than this to a plane count as on it; fraction of the scene's diagonal
    bool exact_curves = false;  ///< rays intersect spheres, cylinders, cones and tori instead of their triangles
    VisibilityMethod compare_with = reference_method;  ///< the other method in the difference view
    bool numbers = false;                              ///< writes the drawing order on the polygons
    std::optional<glm::ivec2> raster;  ///< columns and rows of the computed picture; none: the view's pixels
    std::optional<glm::ivec2> pixel;   ///< a pixel of that picture, (0, 0) at the top left; the views show its
                                       ///< fragments or ray
    bool operator==(const VisibilityParams&) const = default;
};

/// Returns whether GL's depth test decides what is visible; all other methods turn it off.
inline bool uses_gl_depth_test(VisibilityMethod method) {
    return method == VisibilityMethod::depth_buffer;
}

/// Returns whether GL alone draws the method's picture; all other methods first do their own work, such as sorting.
inline bool is_drawn_by_gl_alone(VisibilityMethod method) {
    return method == VisibilityMethod::depth_buffer || method == VisibilityMethod::none;
}

/// Returns whether the picture consists of a few large pixels.
inline bool has_raster(const VisibilityParams& visibility) {
    return visibility.raster && !is_drawn_by_gl_alone(visibility.method);
}

/// Returns whether the picture shows the method at work, step by step or in large pixels. Shadows and reflections are
/// then left out.
inline bool is_taken_apart(const VisibilityParams& visibility) {
    return visibility.step >= 0 || has_raster(visibility);
}

}  // namespace viewing
