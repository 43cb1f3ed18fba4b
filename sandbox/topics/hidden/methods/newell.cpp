// Keeps the undrawn polygons sorted by farthest vertex. P is the farthest polygon at first. If P may hide a Q that may
// be drawn first, Q becomes P, so P can then be anywhere in the list. If neither may be drawn first, or if Q was P
// before and still waits, P or Q is cut. A polygon that becomes P again continues at the Q where it stopped, because it
// has already passed its tests against every farther polygon; its pieces pass these tests too. Read
// software_zbuffer.cpp next.
#include "topics/hidden/methods/newell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "text/catalogue.h"
#include "topics/hidden/methods/projected.h"

namespace viewing {
namespace {

class Sorter {
public:
    Sorter(std::span<const Polygon> polygons, const Viewpoint& viewpoint, const NewellOptions& options,
           const WorkProgress* progress)
        : viewpoint_(viewpoint),
          clip_from_world_(viewpoint.clip_from_world()),
          eye_(viewpoint.eye_world()),
          options_(options),
          progress_(progress),
          epsilon_(options.epsilon.value_or(default_epsilon(polygons))) {
        const double clip_epsilon = std::min(epsilon_, default_epsilon(polygons));
        const glm::dvec4 near = viewpoint.near_plane_world();
        const std::optional<glm::dvec4> eye_plane = viewpoint.eye_plane_world();
        std::size_t taken = 0;
        for (const Polygon& polygon : polygons) {
            if (is_cut_short(taken++, progress)) {
                list_.clear();
                stop(message("Newell's sort was canceled before it began: nothing is drawn."));
                return;
            }
            std::optional<Polygon> seen = clipped(polygon, near, clip_epsilon);
            // Points beyond an oblique near plane may still be behind the eye.
            if (seen && eye_plane) seen = clipped(*seen, *eye_plane, clip_epsilon);
            if (seen) add_fragment(*std::move(seen));
        }
        std::sort(list_.begin(), list_.end(), [&](int a, int b) { return is_drawn_later(a, b); });
    }

    NewellOrder run(WorkProgress* progress) {
        while (!list_.empty() && result_.problem.empty()) {
            advance();
            const double drawn = static_cast<double>(result_.order.size());
            report(progress, drawn / (drawn + static_cast<double>(list_.size())));
        }
        result_.order.insert(result_.order.end(), list_.rbegin(), list_.rend());
        return std::move(result_);
    }

private:
    struct Conflict {
        int q = -1;
        NewellTest swap_test = NewellTest::none;
    };

    /// Returns the part in front of a plane, if any; adds the area of the rest to clipped_area.
    std::optional<Polygon> clipped(const Polygon& polygon, const glm::dvec4& plane, double epsilon) {
        switch (side_of_plane(polygon, plane, epsilon)) {
            case PlaneSide::front:
                return polygon;
            case PlaneSide::spanning: {
                auto [front, back] = split(polygon, plane, epsilon);
                result_.clipped_area += area(back);
                return std::move(front);
            }
            case PlaneSide::back:
            case PlaneSide::coplanar:
                break;
        }
        result_.clipped_area += area(polygon);
        return std::nullopt;
    }

    /// Returns whether fragment a is drawn after b. This order sorts the list, so the next fragment to draw is at its
    /// end.
    bool is_drawn_later(int a, int b) const {
        const double a_farthest = projected_[a].farthest, b_farthest = projected_[b].farthest;
        return a_farthest != b_farthest ? a_farthest < b_farthest : a < b;
    }

    void add_fragment(Polygon polygon) {
        Projected projected = project(polygon, viewpoint_, clip_from_world_);
        add_fragment(std::move(polygon), std::move(projected));
    }
    void add_fragment(Polygon polygon, Projected projected) {
        projected_.push_back(std::move(projected));
        let_go_beyond_.push_back(std::numeric_limits<double>::infinity());
        is_in_chain_.push_back(false);
        list_.push_back(static_cast<int>(result_.fragments.size()));
        result_.fragments.push_back(std::move(polygon));
    }

    void stop(const Message& why) { result_.problem = why; }
    void stop_canceled() { stop(message("Newell's sort was canceled; the rest is sorted by farthest vertex.")); }

    void record(const NewellStep& step) {
        if (result_.steps.size() < options_.max_steps) {
            result_.steps.push_back(step);
        } else {
            ++result_.steps_left_out;
        }
    }

    /// Decides what happens to P, the chain's last fragment: P is drawn, a Q becomes P, or one of the two is cut.
    void advance() {
        if (is_canceled(progress_)) return stop_canceled();
        if (chain_.empty()) join_chain(list_.back());
        const int p = chain_.back();
        const Conflict conflict = first_conflict(p);
        if (!result_.problem.empty()) return;
        if (conflict.q < 0) return draw(p, {.p = p, .action = NewellAction::draws});
        if (conflict.swap_test != NewellTest::none && !is_in_chain_[conflict.q]) {
            ++result_.counters.swaps;
            record({.p = p, .q = conflict.q, .decided_by = conflict.swap_test, .action = NewellAction::swaps});
            return join_chain(conflict.q);
        }
        if (cut_one_of(p, conflict.q) || !result_.problem.empty()) return;
        ++result_.counters.forced;
        draw(p, {.p = p, .q = conflict.q, .action = NewellAction::forces});
    }

    void join_chain(int fragment) {
        chain_.push_back(fragment);
        is_in_chain_[fragment] = true;
    }

    /// Removes a fragment from the list, and from the chain together with everything after it.
    void remove(int fragment) {
        const auto later = [&](int a, int b) { return is_drawn_later(a, b); };
        list_.erase(std::lower_bound(list_.begin(), list_.end(), fragment, later));
        while (is_in_chain_[fragment]) {
            is_in_chain_[chain_.back()] = false;
            chain_.pop_back();
        }
    }

    void draw(int p, const NewellStep& step) {
        record(step);
        result_.order.push_back(p);
        remove(p);
    }

    /// Returns the first Q that P may hide, if any, and the test that lets Q be drawn first.
    Conflict first_conflict(int p) {
        double& let_go_beyond = let_go_beyond_[p];
        const auto is_nearer = [&](double distance, int q) { return distance < projected_[q].farthest; };
        const auto begin = std::upper_bound(list_.begin(), list_.end(), let_go_beyond, is_nearer);
        for (auto place = static_cast<std::size_t>(begin - list_.begin()); place-- > 0;) {
            const int q = list_[place];
            if (q == p) continue;
            if (++result_.counters.pairs > options_.max_pairs) {
                stop(message(
                    "Newell's sort stopped at its budget of {count} comparisons; the rest is sorted by farthest "
                    "vertex.",
                    "count"_a = options_.max_pairs));
                return {};
            }
            const NewellTest test = first_passed(p, q);
            ++result_.counters.decided[test];
            if (test > NewellTest::projections_disjoint) {
                let_go_beyond = projected_[q].farthest;
                return {q, test};
            }
            record({.p = p, .q = q, .decided_by = test});
            if (test == NewellTest::depth_extents) break;  // everything nearer passes, too
        }
        return {};
    }

    NewellTest first_passed(int p, int q) const {
        const Projected &a = projected_[p], &b = projected_[q];
        if (b.farthest <= a.nearest) return NewellTest::depth_extents;
        if (apart_on(0, a, b)) return NewellTest::x_extents;
        if (apart_on(1, a, b)) return NewellTest::y_extents;
        if (is_behind(p, q)) return NewellTest::p_behind_q;
        if (is_in_front(q, p)) return NewellTest::q_in_front_of_p;
        if (are_disjoint(a, b)) return NewellTest::projections_disjoint;
        if (is_behind(q, p)) return NewellTest::q_behind_p;
        if (is_in_front(p, q)) return NewellTest::p_in_front_of_q;
        return NewellTest::none;
    }

    glm::dvec4 plane_towards_eye(int fragment) const {
        const glm::dvec4& plane = result_.fragments[fragment].plane;
        return glm::dot(plane, eye_) < 0.0 ? -plane : plane;
    }

    /// Returns whether a fragment is entirely behind the other's plane; if coplanar, the higher source counts as
    /// behind.
    bool is_behind(int fragment, int other) const {
        const PlaneSide side = side_of_plane(result_.fragments[fragment], plane_towards_eye(other), epsilon_);
        return side == PlaneSide::back || (side == PlaneSide::coplanar && has_higher_source(fragment, other));
    }

    bool is_in_front(int fragment, int other) const {
        const PlaneSide side = side_of_plane(result_.fragments[fragment], plane_towards_eye(other), epsilon_);
        return side == PlaneSide::front || (side == PlaneSide::coplanar && has_higher_source(other, fragment));
    }

    bool has_higher_source(int fragment, int other) const {
        return result_.fragments[fragment].source > result_.fragments[other].source;
    }

    /// Cuts P by Q's plane or Q by P's. If neither is possible, as in some cycles, cuts one of them along the other's
    /// outline. Returns whether it cut anything.
    bool cut_one_of(int p, int q) {
        if (cut(p, q, p, plane_towards_eye(q)) || cut(p, q, q, plane_towards_eye(p))) return true;
        return cut_along_outline(p, q, p, q) || cut_along_outline(p, q, q, p);
    }

    bool cut_along_outline(int p, int q, int fragment, int other) {
        // This is a copy, because a cut adds fragments and may thereby move the original.
        const std::vector<glm::dvec3> outline = result_.fragments[other].vertices;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec3 &a = outline[i], &b = outline[(i + 1) % outline.size()];
            const glm::dvec3 to_eye = glm::dvec3(eye_) - eye_.w * a;
            const glm::dvec3 normal = glm::cross(b - a, to_eye);
            const double length = glm::length(normal);
            if (!(length > 1e-12 * glm::length(b - a) * glm::length(to_eye))) continue;
            if (cut(p, q, fragment, glm::dvec4(normal, -glm::dot(normal, a)) / length)) return true;
        }
        return false;
    }

    /// Cuts a fragment, P or Q, in two if it spans the plane; returns whether it did so.
    bool cut(int p, int q, int fragment, const glm::dvec4& plane) {
        if (!result_.problem.empty()) return false;
        if (side_of_plane(result_.fragments[fragment], plane, epsilon_) != PlaneSide::spanning) return false;
        if (static_cast<int>(list_.size() + result_.order.size()) >= options_.max_fragments) {
            stop(message(
                "Newell's sort stopped at its budget of {count} fragments; the rest is sorted by farthest vertex.",
                "count"_a = options_.max_fragments));
            return false;
        }
        ++result_.counters.splits;
        record({.p = p,
                .q = q,
                .action = NewellAction::splits,
                .split = fragment,
                .first_piece = static_cast<int>(result_.fragments.size()),
                .cut_plane = plane});
        auto [front, back] = split(result_.fragments[fragment], plane, epsilon_);
        remove(fragment);
        add_piece(std::move(front), fragment);
        add_piece(std::move(back), fragment);
        return true;
    }

    void add_piece(Polygon polygon, int whole) {
        Projected projected = project(polygon, viewpoint_, clip_from_world_);
        projected.farthest = std::min(projected.farthest, projected_[whole].farthest);  // guards against rounding
        add_fragment(std::move(polygon), std::move(projected));
        let_go_beyond_.back() = let_go_beyond_[whole];
        const auto place = std::upper_bound(list_.begin(), list_.end() - 1, list_.back(),
                                            [&](int a, int b) { return is_drawn_later(a, b); });
        std::rotate(place, list_.end() - 1, list_.end());
    }

    const Viewpoint& viewpoint_;
    const glm::dmat4 clip_from_world_;
    const glm::dvec4 eye_;
    const NewellOptions& options_;
    const WorkProgress* const progress_;
    const double epsilon_;
    std::vector<Projected> projected_;   ///< per fragment
    std::vector<double> let_go_beyond_;  ///< per fragment: as P, it passed its tests against every Q farther than this
    std::vector<bool> is_in_chain_;      ///< by fragment
    std::vector<int> list_;              ///< not yet drawn; the next one to draw is last
    std::vector<int> chain_;             ///< P is last, after the fragments that wait until P is drawn
    NewellOrder result_;
};

}  // namespace

NewellOrder newell_order(std::span<const Polygon> polygons, const Viewpoint& viewpoint, const NewellOptions& options,
                         WorkProgress* progress) {
    return Sorter(polygons, viewpoint, options, progress).run(progress);
}

}  // namespace viewing
