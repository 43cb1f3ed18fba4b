// The parameters of the views. See params.h for the rest.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "state/depth_params.h"
#include "state/topic.h"

namespace viewing {

enum class Shows { color, depth, stencil, facing, overdraw, difference, fighting, shadow_w };
enum class DepthScale { window, linear };
enum class DepthColors { grey, bands };
enum class Beside { nothing, depth, other_depth, settings };
enum class BesideLayout { halves, divider };

/// Fields to change, each as PATH=VALUE with a JSON value: "projection.near=0.001".
struct Settings {
    std::vector<std::string> all;
    bool operator==(const Settings&) const = default;
};

/// A second picture in the camera view.
struct BesideParams {
    Beside shows = Beside::nothing;
    BesideLayout layout = BesideLayout::halves;
    double share = 0.5;                             ///< the fraction of the view to the left of the divider
    DepthFormat format = DepthFormat::d32f;         ///< for other_depth
    DepthMapping mapping = DepthMapping::reversed;  ///< for other_depth
    Settings set;                                   ///< for settings: the fields that differ in the second picture
    bool operator==(const BesideParams&) const = default;
};

/// The views of the window, of which one can be maximized.
enum class ViewName { none, camera, lower_left, lower_right, matrices };

/// The layout of the window for a demonstration. Empty lists change nothing.
struct LayoutParams {
    ViewName big = ViewName::none;      ///< the view that fills the space of all views
    std::vector<std::string> matrices;  ///< shows only these, in this order
    std::vector<std::string> controls;  ///< shows only these: paths of fields and groups
    std::vector<std::string> folded;    ///< "panel", "matrices" or both
    bool operator==(const LayoutParams&) const = default;
};

/// A pixel of the camera view that stays in place when the view's size changes.
struct Pin {
    std::string object;            ///< the object's name; if empty, `at` is a fraction of the view
    std::optional<glm::dvec2> at;  ///< fraction of the object's box from its top left; none: middle of the visible part
    bool operator==(const Pin&) const = default;
};

/// Returns a lower view that answers no question, to show beside `shown`.
constexpr Topic neutral_beside(Topic shown) {
    return shown == Topic::observer ? Topic::depth : Topic::observer;
}

struct ViewParams {
    Shows shows = Shows::color;
    DepthScale depth_scale = DepthScale::linear;
    DepthColors depth_colors = DepthColors::grey;
    std::optional<glm::dvec2> depth_range;  ///< eye distances shown as black and white; none: see fields.cpp
    int samples = 4;                        ///< 0 or 4
    int plane = 1, light = 1;               ///< the chosen plane and light, counted from 1
    BesideParams beside;
    std::optional<glm::ivec2> pixel;  ///< the pinned pixel of the camera view; (0, 0) is the top left one
    std::optional<Pin> pin;           ///< overrides `pixel`
    std::optional<glm::ivec2> cells;  ///< columns and rows around the pinned pixel; none: as many as stay readable
    int call = -1;                    ///< the last draw call to draw, counted from 0; −1: draws all
    int triangle = -1;                ///< the number of triangles of that call to draw; −1: all
    int pass = -1;                    ///< the last pass to draw, counted from 0; −1: draws all
    int derivation_step = -1;         ///< the number of a derivation's lines to show, not counting headings; −1: all
    double division = 1.0;            ///< in the clip space view: 0 eye space, 1 after the division by w
    double way = 0.0;                 ///< progress of a point: 0 world, 1 eye, 2 clip space, 3 NDC, 4 window
    Topic lower_left = Topic::automatic, lower_right = Topic::automatic;
    LayoutParams layout;
    bool operator==(const ViewParams&) const = default;
};

}  // namespace viewing
