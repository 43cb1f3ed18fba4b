// Which flat objects of a scene can fight over the depth buffer, and from which gap on the formulas say that they do.
// Pure. Read pair_prediction.h next; measure/fighting_measure.h counts what GL makes of them.
#pragma once

#include <cmath>
#include <vector>

#include "frame/derive.h"
#include "visibility/polygons.h"

namespace viewing {

/// Two objects of one or two triangles each, both flat: their planes are parallel to within a degree, they overlap seen
/// along their normal, and the gap between them is at most a tenth of the smaller one's size (the root of its area).
struct FlatPair {
    int first = 0, second = 0;  ///< indices of the objects, in drawing order
    double offset = 0.0;        ///< from the first to the second along the normal, at the overlap's centre; 0: coplanar
    glm::dvec3 center_world{0.0};        ///< of the overlap, on the first object
    glm::dvec3 normal_world{0.0};        ///< unit, of the first object
    glm::dvec4 second_plane_world{0.0};  ///< unit, turned as the first one's normal
    std::vector<Polygon> overlap;        ///< what of the first object has the second one before or behind it
    double radius = 0.0;                 ///< of the farthest corner of the two about the centre
    bool first_is_decal = false, second_is_decal = false;

    /// Where they are coplanar: the only decal of the two, else the second one.
    bool first_lies_on_top() const { return first_is_decal && !second_is_decal; }
    bool has_one_decal() const { return first_is_decal != second_is_decal; }

    double gap() const { return std::abs(offset); }  ///< world units
};

/// Every such pair, in the order of the objects. Kept for the scene that was asked for last.
std::vector<FlatPair> near_coplanar_pairs(const Scene& scene);

/// How depth is computed and stored, as the parameters have it.
struct DepthCoding {
    Lens lens;
    DepthMapping mapping = DepthMapping::standard;
    DepthPrecision precision;
    bool clip_zero_to_one = false;  ///< reversed depth with glClipControl
};
DepthCoding depth_coding(const Params& params, const Derived& derived);

/// How far apart the window depths of two surfaces may come although they should be the same, at an eye distance
/// between near and far, before they are stored: what is rounded to float32 on the way. `span` is how much nearer to
/// the eye the surfaces reach: depth is interpolated across them, so that the larger numbers at their near ends are
/// rounded too. Source: facts §3, with float32's roundings added up where each is largest.
double depth_rounding(const DepthCoding& coding, double distance, double span = 0.0);

/// From which gap on depth tells two surfaces apart whatever codes they meet: below the sum they fight. Eye distance,
/// from a surface towards the eye.
struct FightingOnset {
    double quantisation = 0.0;  ///< one whole code; not more than the way to the near plane
    double arithmetic = 0.0;    ///< what the float32 arithmetic before the store adds to it
    bool is_reachable = true;   ///< false: not even a surface on the near plane is sure to have another code

    double gap() const { return quantisation + arithmetic; }
};

/// At an eye distance between near and far: what is nearer counts as at near, what is farther as at far. `span` as
/// for depth_rounding().
FightingOnset fighting_onset(const DepthCoding& coding, double distance, double span = 0.0);

}  // namespace viewing
