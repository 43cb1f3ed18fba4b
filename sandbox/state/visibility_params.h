// The part of the parameters that says which hidden-surface method draws, and how. Read params.h for the rest.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "visibility/choices.h"

namespace viewing {

enum class VisibilityMethod { depth_buffer, none, painter, newell, bsp, software_depth_buffer, ray_cast };

struct VisibilityParams {
    VisibilityMethod method = VisibilityMethod::depth_buffer;
    int step = -1;  ///< −1: all steps
    PainterKey sort_key = PainterKey::farthest;
    BspSplitter splitter = BspSplitter::fewest_splits;
    BspOrder walk = BspOrder::back_to_front;
    double epsilon = 1e-9;      ///< how near to a plane counts as on it, as a share of the scene's diagonal
    bool exact_curves = false;  ///< rays meet spheres, cylinders, cones and tori themselves, not their triangles
    VisibilityMethod compare_with = VisibilityMethod::ray_cast;  ///< the other one of the difference view
    bool numbers = false;                                        ///< drawing order, written on the polygons
    std::optional<glm::ivec2> raster;  ///< columns and rows of the picture that is found; none: the view's pixels
    std::optional<glm::ivec2> pixel;   ///< of that picture, (0, 0) top left: whose fragments or ray are followed
    bool operator==(const VisibilityParams&) const = default;
};

/// Methods whose picture GL draws without help; the others sort, cut or cast first.
inline bool is_drawn_by_gl_alone(VisibilityMethod method) {
    return method == VisibilityMethod::depth_buffer || method == VisibilityMethod::none;
}

/// Whether the picture is made of few large pixels.
inline bool has_raster(const VisibilityParams& visibility) {
    return visibility.raster && !is_drawn_by_gl_alone(visibility.method);
}

/// Whether the method is looked at from within: what belongs to the picture alone, shadow and mirror, waits.
inline bool is_taken_apart(const VisibilityParams& visibility) {
    return visibility.step >= 0 || has_raster(visibility);
}

}  // namespace viewing
