// Depth sorting done right: before a polygon is drawn, five cheap tests and one thorough one say whether it may hide
// one that is drawn later; if so, the two swap, or one is cut. Read ray_cast.h next. Source: Newell, Newell and Sancha
// 1972; lecture, Hidden Surface Removal: depth sorting.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platform/progress.h"
#include "visibility/polygons.h"
#include "visibility/viewpoint.h"

namespace viewing {

/// P is about to be drawn, Q later, as in the paper; on the screen they are A and B, for P is the projection there.
/// Each of the first six, in this order, lets P go before Q; each of the last two lets Q go before P instead. Planes
/// have their front towards the eye.
enum class NewellTest {
    depth_extents,         ///< Q's farthest is no farther than P's nearest
    x_extents,             ///< apart on the screen's x axis
    y_extents,             ///< apart on the screen's y axis
    p_behind_q,            ///< P lies wholly behind Q's plane
    q_in_front_of_p,       ///< Q lies wholly in front of P's plane
    projections_disjoint,  ///< apart on the screen
    q_behind_p,            ///< Q lies wholly behind P's plane
    p_in_front_of_q,       ///< P lies wholly in front of Q's plane
    none                   ///< all failed
};
inline constexpr std::size_t newell_test_count = 9;

enum class NewellAction {
    goes_on,  ///< P may go before Q; the next Q
    swaps,    ///< Q takes P's place
    splits,   ///< two pieces take the place of P or of Q
    draws,    ///< nothing stands against P; there is no Q
    forces    ///< P is drawn although Q stands against it: they overlap by less than epsilon, so no cut is left
};

/// One rung of the ladder. All tests before `decided_by` have failed for the pair.
struct NewellStep {
    int p = -1, q = -1;  ///< indices into NewellOrder::fragments
    NewellTest decided_by = NewellTest::none;
    NewellAction action = NewellAction::goes_on;
    int split = -1;        ///< which of the two was cut
    int first_piece = -1;  ///< the piece in front; the other one follows it
    glm::dvec4 cut_plane{
        0.0};  ///< Q's or P's plane, or for a cycle that none of these cuts, one through the eye and an edge
};

struct NewellOptions {
    std::optional<double> epsilon{};  ///< how near to a plane counts as on it; default_epsilon() if none
    int max_fragments = 100'000;
    std::int64_t max_pairs = 400'000'000;
    std::size_t max_steps = 200'000;  ///< recorded; the rest is only counted
};

struct NewellCounters {
    std::int64_t pairs = 0;                                 ///< comparisons of a P with a Q
    std::array<std::int64_t, newell_test_count> decided{};  ///< pairs by the test that decided, as in NewellTest
    std::int64_t swaps = 0, splits = 0, forced = 0;
};

struct NewellOrder {
    std::vector<Polygon> fragments;  ///< all there ever were, in world space: also those that were cut later
    std::vector<int> order;          ///< indices into fragments, back to front
    double clipped_area = 0.0;       ///< of what lies on or behind the near plane, which is not in the order
    std::vector<NewellStep> steps;
    std::int64_t steps_left_out = 0;
    NewellCounters counters;
    /// A sentence when it stopped at a budget or was cancelled: the rest is sorted by farthest vertex; more than 32,768
    /// polygons are left out where it is cancelled before the first comparison.
    std::string problem;
};

/// An order in which painting over is right for this viewpoint. Polygons are clipped at the near plane first. Where
/// coplanar ones overlap, the one with the lowest source is seen. A polygon that is seen edge-on hides nothing.
NewellOrder newell_order(std::span<const Polygon> polygons, const Viewpoint& viewpoint,
                         const NewellOptions& options = {}, WorkProgress* progress = nullptr);

}  // namespace viewing
