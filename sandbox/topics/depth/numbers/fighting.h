// Finds the flat objects of a scene that can fight over the depth buffer, and the gap below which the formulas predict
// a fight. Pure. Read pair_prediction.h next; topics/depth/measured/fighting_measure.h counts the wrong pixels that GL
// draws.
#pragma once

#include <cmath>
#include <vector>

#include "frame/derive.h"
#include "topics/hidden/methods/polygons.h"

namespace viewing {

/// Two flat objects of one or two triangles each: their planes are parallel to within a degree, they overlap as seen
/// along their normal, and the gap between them is at most a tenth of the smaller one's size (the square root of its
/// area).
struct FlatPair {
    int first = 0, second = 0;  ///< indices of the objects, in drawing order
    double offset = 0.0;        ///< from the first to the second along the normal, at the overlap's center; 0: coplanar
    glm::dvec3 center_world{0.0};        ///< of the overlap, on the first object
    glm::dvec3 normal_world{0.0};        ///< unit, of the first object
    glm::dvec4 second_plane_world{0.0};  ///< unit, oriented like the first one's normal
    std::vector<Polygon> overlap;        ///< part of the first object that the second one overlaps, in front or behind
    double radius = 0.0;                 ///< distance from the center to the farthest corner of the two objects
    bool first_is_decal = false, second_is_decal = false;

    /// For a coplanar pair: if exactly one of the two is a decal, it is on top; otherwise, the second object is.
    bool first_lies_on_top() const { return first_is_decal && !second_is_decal; }
    bool has_one_decal() const { return first_is_decal != second_is_decal; }

    double gap() const { return std::abs(offset); }  ///< world units
};

/// Returns every FlatPair of a scene, in the order of the objects. Keeps the latest scene's pairs for the next call.
std::vector<FlatPair> near_coplanar_pairs(const Scene& scene);

/// The settings that determine how depth is computed and stored.
struct DepthCoding {
    Lens lens;
    DepthMapping mapping = DepthMapping::standard;
    DepthPrecision precision;
    bool clip_zero_to_one = false;  ///< reversed depth with glClipControl
};
DepthCoding depth_coding(const Params& params, const Derived& derived);

/// Returns how far apart float32 rounding may move the window depths of two surfaces before they are stored, although
/// these depths should be equal. `distance`, between near and far, is the surfaces' eye distance. `span` is how much
/// nearer to the eye they extend: depth is interpolated across them, so the larger values at their near ends are
/// rounded too. Adds up the largest possible error of each float32 rounding.
double depth_rounding(const DepthCoding& coding, double distance, double span = 0.0);

/// The smallest gap at which depth distinguishes two surfaces, wherever their depths fall within a code. With a smaller
/// gap, they may fight. The gap is measured in eye distance, from a surface toward the eye.
struct FightingOnset {
    double quantization = 0.0;  ///< one whole code, but at most the distance to the near plane
    double arithmetic = 0.0;    ///< added by the float32 arithmetic before depth is stored
    bool is_reachable = true;   ///< false: even a surface on the near plane may have the same code

    double gap() const { return quantization + arithmetic; }
};

/// Returns the onset at an eye distance, clamped to near … far. `span` has the same meaning as in depth_rounding().
FightingOnset fighting_onset(const DepthCoding& coding, double distance, double span = 0.0);

}  // namespace viewing
