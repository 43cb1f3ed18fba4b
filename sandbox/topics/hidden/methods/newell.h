// Correct depth sorting: before a polygon is drawn, five cheap tests and one thorough one check whether it may hide a
// polygon that is drawn later; if so, the two swap, or one is cut. Read ray_cast.h next. Source: Newell, Newell and
// Sancha 1972; lecture, Hidden Surface Removal: depth sorting.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platform/progress.h"
#include "text/message.h"
#include "text/per_enum.h"
#include "topics/hidden/methods/polygons.h"
#include "topics/hidden/methods/viewpoint.h"

namespace viewing {

/// P is about to be drawn and Q comes later, as in the paper; the screen calls them A and B, because P stands for the
/// projection there. The tests are tried in this order. If one of the first six passes, P may be drawn before Q; if one
/// of the next two passes, Q may be drawn before P instead. The front of each plane faces the eye.
enum class NewellTest {
    depth_extents,         ///< Q's farthest vertex is no farther than P's nearest
    x_extents,             ///< apart on the screen's x axis
    y_extents,             ///< apart on the screen's y axis
    p_behind_q,            ///< P is entirely behind Q's plane
    q_in_front_of_p,       ///< Q is entirely in front of P's plane
    projections_disjoint,  ///< apart on the screen
    q_behind_p,            ///< Q is entirely behind P's plane
    p_in_front_of_q,       ///< P is entirely in front of Q's plane
    none                   ///< all failed
};
inline constexpr std::size_t newell_test_count = 9;

enum class NewellAction {
    goes_on,  ///< P may go before Q; continue with the next Q
    swaps,    ///< Q takes P's place
    splits,   ///< two pieces replace P or Q
    draws,    ///< P is drawn: no Q is left that it may hide
    forces    ///< P is drawn despite Q: they overlap by less than epsilon, so nothing can be cut
};

/// One comparison of P and Q. All tests before `decided_by` have failed for the pair.
struct NewellStep {
    int p = -1, q = -1;  ///< indices into NewellOrder::fragments
    NewellTest decided_by = NewellTest::none;
    NewellAction action = NewellAction::goes_on;
    int split = -1;        ///< the one of the two that was cut
    int first_piece = -1;  ///< the piece in front; the other piece follows it
    glm::dvec4 cut_plane{
        0.0};  ///< Q's or P's plane; if neither plane can cut the other polygon, a plane through the eye and an edge
};

struct NewellOptions {
    std::optional<double> epsilon{};  ///< tolerance for points on a plane; default_epsilon() if none
    int max_fragments = 100'000;
    std::int64_t max_pairs = 400'000'000;
    std::size_t max_steps = 200'000;  ///< limit on recorded steps; all others are only counted
};

struct NewellCounters {
    std::int64_t pairs = 0;                                          ///< comparisons of a P with a Q
    PerEnum<NewellTest, std::int64_t, newell_test_count> decided{};  ///< pairs by deciding test
    std::int64_t swaps = 0, splits = 0, forced = 0;
};

struct NewellOrder {
    std::vector<Polygon> fragments;  ///< all that ever existed, even those cut later; in world space
    std::vector<int> order;          ///< indices into fragments, back to front
    double clipped_area = 0.0;       ///< area of the clipped parts: in front of the near plane, or behind the eye
    std::vector<NewellStep> steps;
    std::int64_t steps_left_out = 0;
    NewellCounters counters;
    /// A sentence if the sort stopped at a budget or was canceled; the rest is then sorted by farthest vertex. If it
    /// was canceled while clipping, which is possible only with more than 32,768 polygons, nothing is drawn.
    Message problem;
};

/// Returns a painting order that is correct for this viewpoint. Clips polygons at the near plane first. Where
/// coplanar polygons overlap, the one with the lowest source is visible. A polygon seen edge-on hides nothing.
NewellOrder newell_order(std::span<const Polygon> polygons, const Viewpoint& viewpoint,
                         const NewellOptions& options = {}, WorkProgress* progress = nullptr);

}  // namespace viewing
