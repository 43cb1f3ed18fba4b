// The part of the parameters that says what the views show. Read params.h for the rest.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "state/depth_params.h"

namespace viewing {

enum class Shows { color, depth, stencil, facing, overdraw, difference, fighting, shadow_w };
enum class DepthScale { window, linear };
enum class DepthColors { grey, bands };
enum class Beside { nothing, depth, other_depth };
enum class BesideLayout { halves, divider };

/// What one of the two views below the camera's shows; `automatic` goes by the hidden-surface method.
enum class Topic {
    automatic,
    observer,
    depth,
    histogram,
    precision,
    codes,
    pixel,
    cells,
    fighting,
    moving_world,
    passes,
    tree,
    order,
    growth,
    shadow_derivation,
    mirror_derivation,
    lecture_code,
    mirror_ways,
    from_light,
    display_code
};

/// A second picture in the camera's view.
struct BesideParams {
    Beside shows = Beside::nothing;
    BesideLayout layout = BesideLayout::halves;
    double share = 0.5;                             ///< of the divider: the part left of it
    DepthFormat format = DepthFormat::d32f;         ///< of other_depth
    DepthMapping mapping = DepthMapping::reversed;  ///< of other_depth
    bool operator==(const BesideParams&) const = default;
};

enum class BigView { none, camera, lower_left, lower_right, matrices };

/// How the window is arranged for what is being told. Empty lists: everything as usual.
struct LayoutParams {
    BigView big = BigView::none;        ///< fills the place of all views
    std::vector<std::string> matrices;  ///< only these, in this order
    std::vector<std::string> controls;  ///< only these: paths of fields and groups
    std::vector<std::string> folded;    ///< out of panel, matrices
    bool operator==(const LayoutParams&) const = default;
};

/// A pixel of the camera's picture that is the same place at every size of it.
struct Pin {
    std::string object;            ///< empty: none, `at` is a fraction of the view
    std::optional<glm::dvec2> at;  ///< from top left, of the object's box in the picture; none: what is visible of it
    bool operator==(const Pin&) const = default;
};

struct ViewParams {
    Shows shows = Shows::color;
    DepthScale depth_scale = DepthScale::linear;
    DepthColors depth_colors = DepthColors::grey;
    std::optional<glm::dvec2> depth_range;  ///< eye distances that are black and white; none: see fields.cpp
    int samples = 4;                        ///< 0 or 4
    int plane = 1, light = 1;               ///< the ones looked at more closely, counted from 1 on
    BesideParams beside;
    std::optional<glm::ivec2> pixel;  ///< pinned, of the camera's picture; (0, 0) is the top left one
    std::optional<Pin> pin;           ///< in place of `pixel`
    std::optional<glm::ivec2> cells;  ///< columns and rows of the block of cells around it; none: what can be read
    int call = -1;                    ///< draws stop within this draw call of the frame, from 0 on; −1: all of them
    int triangle = -1;                ///< and after so many of its triangles; −1: all of them
    int pass = -1;                    ///< the frame stops after this pass, from 0 on; −1: it does not
    int derivation_step = -1;         ///< lines of a derivation that are written, from 0 on; −1: all of them
    Topic lower_left = Topic::automatic, lower_right = Topic::automatic;
    LayoutParams layout;
    bool operator==(const ViewParams&) const = default;
};

}  // namespace viewing
