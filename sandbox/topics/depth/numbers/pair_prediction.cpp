#include "topics/depth/numbers/pair_prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "frame/depth_switches.h"

namespace viewing {
namespace {

constexpr double says_nothing = 0.9;  ///< an interval of at least this width predicts nothing
constexpr double fewest_codes =
    2.0;  ///< surfaces must cross this many codes for their pixels to sample all phases of a code
constexpr double most_codes_a_pixel = 0.5;

ShareInterval certainly(double share) {
    return {share, share};
}

/// Returns the part of the overlap inside the view, in view space.
std::vector<Polygon> seen_part(const FlatPair& pair, const Derived& derived, const Lens& lens) {
    const glm::dmat4 rows = glm::transpose(derived.clip_from_view);
    const glm::dvec4 planes[] = {{0.0, 0.0, -1.0, -lens.near},
                                 {0.0, 0.0, 1.0, lens.far},
                                 rows[3] + rows[0],
                                 rows[3] - rows[0],
                                 rows[3] + rows[1],
                                 rows[3] - rows[1]};
    const double close = 1e-12 * lens.shown_far();
    std::vector<Polygon> seen;
    for (Polygon part : pair.overlap) {
        for (glm::dvec3& corner : part.vertices) corner = glm::dvec3(derived.view_from_world * glm::dvec4(corner, 1.0));
        bool is_seen = true;
        for (const glm::dvec4& plane : planes) {
            const glm::dvec4 unit = plane / glm::length(glm::dvec3(plane));
            const PlaneSide side = side_of_plane(part, unit, close);
            if (side == PlaneSide::spanning) part = split(part, unit, close).first;
            is_seen = is_seen && side != PlaneSide::back && side != PlaneSide::coplanar;
        }
        if (is_seen) seen.push_back(std::move(part));
    }
    return seen;
}

/// Intersects view rays with a plane.
class SeenPlane {
public:
    SeenPlane(const glm::dvec4& plane_world, const Derived& derived, const Lens& lens)
        : plane_(plane_world * effective_camera(derived)), clip_from_view_(derived.clip_from_view), lens_(lens) {}

    /// Returns the eye distance along the view ray through a point in normalized device coordinates.
    double distance(const glm::dvec2& ndc) const {
        const glm::dvec2 scale(clip_from_view_[0][0], clip_from_view_[1][1]);
        const glm::dvec3 normal(plane_);
        if (lens_.orthographic) return (glm::dot(glm::dvec2(normal), ndc / scale) + plane_.w) / normal.z;
        return -plane_.w / glm::dot(normal, glm::dvec3(ndc / scale, -1.0));
    }

private:
    glm::dvec4 plane_;  ///< in view space
    glm::dmat4 clip_from_view_;
    Lens lens_;
};

/// Positions of two surfaces relative to each other and to the codes, over all corners of their visible part. The unit
/// is one code; for a float, whose codes differ in width, the code at each corner.
struct SeenCodes {
    double least_lead = 1e300, most_lead = -1e300;  ///< how much nearer the second surface is
    double arithmetic = 0.0;
    bool has_cleared_code = false;                    ///< some depths may equal the cleared code, which GL_LESS rejects
    double least_place = 1e300, most_place = -1e300;  ///< of both depths, as codes before rounding
    glm::dvec2 least_slope{1e300}, most_slope{0.0};   ///< slope of the first one's depth per pixel, along x and y
    glm::dvec2 least_ndc{1e300}, most_ndc{-1e300};
    glm::dvec2 size_px{1.0};

    /// Returns whether both surfaces have the same single code everywhere.
    bool is_one_code() const { return std::round(least_place - arithmetic) == std::round(most_place + arithmetic); }

    /// Widens an interval for the wrong fraction over all phases of a code, so that it holds for the actual pixels,
    /// each of which samples the depth once. If depth is linear over a polygon, its density has one maximum, at most
    /// twice the mean.
    ShareInterval widened(const ShareInterval& share) const {
        double deviation = 1e300;
        for (int axis = 0; axis < 2; ++axis) {
            const double codes = least_slope[axis] * 0.5 * (most_ndc[axis] - least_ndc[axis]) * size_px[axis];
            if (codes >= fewest_codes && most_slope[axis] <= most_codes_a_pixel)
                deviation = std::min(deviation, 2.0 / codes + 2.0 * most_slope[axis]);
        }
        const auto of = [deviation](double s) { return s > 0.0 && s < 1.0 ? deviation * s * (1.0 - s) : 0.0; };
        return {std::max(share.least - of(share.least), 0.0), std::min(share.most + of(share.most), 1.0)};
    }
};

SeenCodes seen_codes(const FlatPair& pair, std::span<const Polygon> seen, const DepthCoding& coding,
                     const Derived& derived, double span, glm::ivec2 size_px) {
    const Lens& lens = coding.lens;
    const SeenPlane first(glm::dvec4(pair.normal_world, -glm::dot(pair.normal_world, pair.center_world)), derived,
                          lens);
    const SeenPlane second(pair.second_plane_world, derived, lens);
    const double towards_eye = coding.mapping == DepthMapping::reversed ? 1.0 : -1.0;
    const auto depth_of = [&](const SeenPlane& plane, const glm::dvec2& ndc) {
        return window_depth(lens, coding.mapping, plane.distance(ndc));
    };
    SeenCodes made;
    made.size_px = size_px;
    for (const Polygon& part : seen) {
        for (const glm::dvec3& corner : part.vertices) {
            const glm::dvec4 clip = derived.clip_from_view * glm::dvec4(corner, 1.0);
            const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
            const double depth = depth_of(first, ndc), second_depth = depth_of(second, ndc);
            const double code = code_width(coding.precision, depth);
            const double lead = pair.offset == 0.0 ? 0.0 : towards_eye * (second_depth - depth) / code;
            made.least_lead = std::min(made.least_lead, lead);
            made.most_lead = std::max(made.most_lead, lead);
            made.least_place = std::min({made.least_place, depth / code, second_depth / code});
            made.most_place = std::max({made.most_place, depth / code, second_depth / code});
            const double rounding = depth_rounding(coding, -corner.z, span);
            made.arithmetic = std::max(made.arithmetic, rounding / code);
            const double farthest = towards_eye < 0.0 ? 1.0 : 0.0;
            made.has_cleared_code |= std::min(std::abs(depth - farthest), std::abs(second_depth - farthest)) <=
                                     0.5 * code_width(coding.precision, farthest) + rounding;
            for (int axis = 0; axis < 2; ++axis) {
                glm::dvec2 beside = ndc;
                beside[axis] += 2.0 / made.size_px[axis];
                const double slope = std::abs(depth_of(first, beside) - depth) / code;
                made.least_slope[axis] = std::min(made.least_slope[axis], slope);
                made.most_slope[axis] = std::max(made.most_slope[axis], slope);
            }
            made.least_ndc = glm::min(made.least_ndc, ndc);
            made.most_ndc = glm::max(made.most_ndc, ndc);
        }
    }
    return made;
}

/// Replaces the onset at the center by the one at the corner of the visible part that needs the widest gap along the
/// normal: usually the farthest.
void set_onset_where_worst(PairPrediction& made, const FlatPair& pair, std::span<const Polygon> seen,
                           const DepthCoding& coding, const Derived& derived, double span) {
    const glm::dvec3 normal_view(derived.view_from_world * glm::dvec4(pair.normal_world, 0.0));
    double widest = 0.0;
    for (const Polygon& part : seen)
        for (const glm::dvec3& corner : part.vertices)
            for (const glm::dvec3& at : {corner, corner + pair.offset * normal_view}) {
                const double z = -at.z, slant = coding.lens.orthographic ? std::abs(normal_view.z)
                                                                         : std::abs(glm::dot(normal_view, at)) / z;
                const FightingOnset onset = fighting_onset(coding, z, span);
                if (!(onset.gap() * slant > widest) && onset.is_reachable) continue;
                widest = onset.is_reachable ? onset.gap() * slant : std::numeric_limits<double>::infinity();
                made.onset = onset;
                made.slant = slant;
            }
}

/// Returns the wrong fraction for a decal that is drawn only where the stencil shows its base.
std::optional<ShareInterval> wrong_share_by_stencil(const FlatPair& pair, bool decal_is_right,
                                                    const std::vector<int>& marks) {
    const auto first = static_cast<std::size_t>(pair.first), second = static_cast<std::size_t>(pair.second);
    const bool belong_together = pair.has_one_decal() && std::max(first, second) < marks.size() && marks[first] != 0 &&
                                 marks[first] == marks[second];
    if (!belong_together) return std::nullopt;
    return certainly(decal_is_right ? 0.0 : 1.0);
}

/// Returns the wrong fraction if a polygon offset moves one of the two surfaces. GL does not define how many codes a
/// unit spans, so the program measures the number; it is exactly one if the shader adds the offset. Without a
/// measurement, and for a float, a unit counts as at least one code. `lead` and `most_lead`: by how many codes, at
/// least and at most, the surface that should be visible is nearer without the offset.
std::optional<ShareInterval> wrong_share_with_offset(const DepthParams& depth, const StoredDepth& stored,
                                                     bool decal_is_right, bool tie_is_wrong, double lead,
                                                     double most_lead, const SeenCodes& codes) {
    const double to_right_one = (keeps_offset_sign(depth) ? 1.0 : -1.0) * (decal_is_right ? 1.0 : -1.0);
    const double units = depth.offset.units * to_right_one, factor = depth.offset.factor * to_right_one;
    const bool moves_whole_codes = stores_fewer_bits(depth.format) && units == std::round(units);
    if (moves_whole_codes && factor == 0.0 && codes.is_one_code())
        return certainly(units >= (tie_is_wrong ? 1.0 : 0.0) ? 0.0 : 1.0);
    const bool is_known = stored.unit_codes && !stored.precision.is_float;  // for a float it varies with the depth
    if (is_known && factor == 0.0) {
        const double moved = units * *stored.unit_codes;
        return codes.widened(share_of_random_codes(lead + moved, most_lead + moved, codes.arithmetic, tie_is_wrong));
    }
    const double surely = 1.0 + codes.arithmetic;
    if (factor >= 0.0 && units > 0.0 && lead + units >= surely) return certainly(0.0);
    if (factor <= 0.0 && units < 0.0 && most_lead + units <= -surely) return certainly(1.0);
    return std::nullopt;
}

std::optional<ShareInterval> wrong_share_of(const FlatPair& pair, const Params& params, const Derived& derived,
                                            const SeenCodes& codes) {
    const DepthParams& depth = params.depth;
    const bool goes_by_nearness = wants_nearer(depth) && depth.write && is_cleared_to_farthest(depth);
    if (!goes_by_nearness || has_bent_depth(depth)) return std::nullopt;
    const bool second_is_right = pair.offset == 0.0 ? !pair.first_lies_on_top() : codes.most_lead > 0.0;
    const double lead = second_is_right ? codes.least_lead : -codes.most_lead;
    const double most_lead = second_is_right ? codes.most_lead : -codes.least_lead;
    if (lead < 0.0) return std::nullopt;  // the surfaces cross
    const bool decal_is_right = second_is_right == pair.second_is_decal;
    const bool has_decal = pair.first_is_decal || pair.second_is_decal;
    if (has_decal && depth.decals == DecalMethod::equal) return std::nullopt;
    if (has_decal && depth.decals == DecalMethod::stencil)
        return wrong_share_by_stencil(pair, decal_is_right, derived.object_marks);
    if (depth.func == CompareFunc::less && codes.has_cleared_code) return std::nullopt;

    const bool tie_is_wrong = second_is_right != (depth.func == CompareFunc::lequal);
    if (pair.has_one_decal() && depth.offset != DepthOffset{})
        return wrong_share_with_offset(depth, derived.stored_depth, decal_is_right, tie_is_wrong, lead, most_lead,
                                       codes);
    if (codes.is_one_code()) return certainly(tie_is_wrong ? 1.0 : 0.0);
    return codes.widened(share_of_random_codes(lead, most_lead, codes.arithmetic, tie_is_wrong));
}

}  // namespace

ShareInterval share_of_random_codes(double gap_codes, double most_gap_codes, double arithmetic_codes,
                                    bool tie_is_wrong) {
    const double tie = tie_is_wrong ? 1.0 : 0.0;
    return {std::clamp(tie - most_gap_codes - arithmetic_codes, 0.0, 1.0),
            std::clamp(tie - gap_codes + arithmetic_codes, 0.0, 1.0)};
}

PairPrediction predict_pair(const FlatPair& pair, const Params& params, const Derived& derived, glm::ivec2 size_px) {
    const DepthCoding coding = depth_coding(params, derived);
    const glm::dvec3 center_view(derived.view_from_world * glm::dvec4(pair.center_world, 1.0));
    const glm::dvec3 normal_view(derived.view_from_world * glm::dvec4(pair.normal_world, 0.0));
    PairPrediction made;
    made.distance = -center_view.z;
    made.step = depth_step(coding.lens, coding.mapping, coding.precision, made.distance);
    // The pair extends this far toward the eye, which looks along −z; 0 if the pair is perpendicular to the view
    // direction.
    const double span = pair.radius * std::sqrt(std::max(1.0 - normal_view.z * normal_view.z, 0.0));
    made.onset = fighting_onset(coding, made.distance, span);
    if (!derived.has_distances) return made;
    // The view ray through the center, per unit of eye distance.
    const glm::dvec3 sight =
        coding.lens.orthographic || made.distance == 0.0 ? glm::dvec3(0.0, 0.0, -1.0) : center_view / made.distance;
    made.slant = std::abs(glm::dot(normal_view, sight));
    const std::vector<Polygon> seen = seen_part(pair, derived, coding.lens);
    if (seen.empty()) return made;
    made.is_seen = true;
    set_onset_where_worst(made, pair, seen, coding, derived, span);
    const auto share = wrong_share_of(pair, params, derived, seen_codes(pair, seen, coding, derived, span, size_px));
    if (share && share->most - share->least < says_nothing) made.wrong_share = share;
    return made;
}

}  // namespace viewing
