// Which flat objects of a scene can fight over the depth buffer, and from which gap on the formulas say that they do.
// Pure: measure/fighting_measure.h counts what GL makes of them.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "frame/derive.h"

namespace viewing {

/// Two objects of one or two triangles each, both flat: their planes are parallel to within a degree, they overlap seen
/// along their normal, and the gap between them is at most a tenth of the smaller one's size (the root of its area).
struct FlatPair {
    int first = 0, second = 0;  ///< indices of the objects, in drawing order
    double offset = 0.0;        ///< from the first to the second along the normal, at the overlap's centre; 0: coplanar
    glm::dvec3 center_world{0.0};  ///< of the overlap, on the first object
    glm::dvec3 normal_world{0.0};  ///< unit, of the first object
    double radius = 0.0;           ///< of the farthest corner of the two about the centre
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

/// From which gap on depth tells two surfaces apart whatever codes they meet: below the sum they fight. Eye distance,
/// from a surface towards the eye.
struct FightingOnset {
    double quantisation = 0.0;  ///< one whole code; not more than the way to the near plane
    double arithmetic = 0.0;    ///< what the float32 arithmetic before the store adds to it
    bool is_reachable = true;   ///< false: not even a surface on the near plane is sure to have another code

    double gap() const { return quantisation + arithmetic; }
};

/// At an eye distance between near and far: what is nearer counts as at near, what is farther as at far.
/// `span` is how much nearer to the eye the surfaces reach: depth is interpolated across them, so that the larger
/// numbers at their near ends are rounded too. Source: facts §3, with float32's roundings added up where each is
/// largest.
FightingOnset fighting_onset(const DepthCoding& coding, double distance, double span = 0.0);

/// The share of pixels that have the same code on two surfaces `gap` apart in eye distance, where codes meet them at
/// random: 1 for a gap of 0, 0 from one code on. Arithmetic is left out.
double share_of_ties(const FightingOnset& onset, double gap);

/// What the formulas say of a pair, from where the camera is.
struct PairPrediction {
    double distance = 0.0;  ///< eye distance of the overlap's centre
    double step = 0.0;      ///< resolvable_depth_step() there
    FightingOnset onset;    ///< in eye distance
    double slant = 1.0;     ///< a gap along the normal divided by it is the gap in eye distance; 0: seen edge-on
    /// Of the pair's pixels. None where the formulas do not say: out of the lens's range, a depth function that does
    /// not go by nearness, a depth buffer that is not cleared to what is farthest, logarithms at the corners, surfaces
    /// that the rounding before the store decides between, decals by GL_EQUAL, and a polygon offset that is not sure to
    /// be more than a code.
    std::optional<double> wrong_share;
};
PairPrediction predict_pair(const FlatPair& pair, const Params& params, const Derived& derived);

}  // namespace viewing
