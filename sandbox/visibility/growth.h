// Costs as they grow: every method on more and more polygons, with its time and how often it did what it does most.
// After the comparison of ten algorithms by Sutherland, Sproull and Schumacker 1974. Read growth.cpp next.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "platform/progress.h"
#include "visibility/polygons.h"
#include "visibility/viewpoint.h"

namespace viewing {

/// In the order in which they are measured. A BSP tree is built without regard to the eye and then walked for one.
enum class GrowthMethod { painter, newell, bsp_build, bsp_walk, z_buffer, ray_casting };
inline constexpr std::size_t growth_method_count = 6;

/// As in the middle of a sentence: "the software z-buffer"; in English, tr_part() for a person.
std::string_view growth_method_name(GrowthMethod method);

/// What the method does most often, in the plural: "pixels tested".
std::string_view growth_operation_name(GrowthMethod method);

/// Random triangles in a cube of side 2, by `seed` and the same everywhere: small ones have their corners on a sphere
/// whose diameter is 2.5 % of the side, large ones anywhere in the cube, so that nearly all run through one another.
enum class GrowthScene { small_triangles, large_triangles, own_polygons };

struct GrowthRequest {
    GrowthScene scene = GrowthScene::small_triangles;
    std::vector<Polygon> own_polygons{};  ///< for that scene: every k-th of them, down to the count that is measured
    std::vector<int> counts{10, 30, 100, 300, 1'000, 3'000, 10'000, 30'000, 100'000};
    int width = 320, height = 240;         ///< of the picture, pixels; at least 1
    std::optional<Viewpoint> viewpoint{};  ///< none: one that has all of the scene in view
    double time_budget_ms = 4000.0;        ///< for one row; infinite: only the two below stop a method
    int max_fragments = 1'000'000;         ///< of a BSP tree and of Newell's sort
    std::int64_t max_pairs = std::numeric_limits<std::int64_t>::max();  ///< of Newell's sort
    unsigned seed = 1;
};

/// One point of a curve.
struct GrowthRow {
    GrowthMethod method = GrowthMethod::painter;
    int polygons = 0;
    double time_ms = 0.0;  ///< to the finished picture; for bsp_build to the finished tree. The median of some runs
    std::string_view operation_name{};
    std::int64_t operations = 0;
    std::int64_t pixels_painted = 0;  ///< in the order that the method has found; 0 where finding is painting
    std::string problem{};     ///< a sentence when a budget stopped the method, or when it was not tried any more
    double painting_ms = 0.0;  ///< of time_ms: painting in the order that the method has found
    double build_ms = 0.0;     ///< of time_ms: building the hierarchy that rays are cast into
    double time_least_ms = 0.0, time_most_ms = 0.0;  ///< of all runs
    int runs = 0;

    /// What the method is compared by, since it repeats where times tremble: every operation counts as one.
    std::int64_t work() const { return operations + pixels_painted; }
};

/// The polygons that a count is measured on: `count` random triangles, the first ones of any larger count; of own
/// polygons at most as many as there are.
std::vector<Polygon> growth_polygons(const GrowthRequest& request, int count);

/// All methods at the lowest count, then at the next one; `on_row` is called with each row as it is added. Counts are
/// put in order; those below 1 and repeated ones are left out, and those above a million, or for own polygons above
/// their number, are replaced by it. Each is run three times and more often while that is quick. A method that a budget
/// stopped, or that took longer than its time, gets one more row, at the next count: it is not tried any more, and
/// `problem` says so. A row's operations depend on the time only where the time stopped it. Cancelled: the rows that
/// were finished.
std::vector<GrowthRow> measure_growth(const GrowthRequest& request, WorkProgress* progress = nullptr,
                                      const std::function<void(const GrowthRow&)>& on_row = {});

/// Comma-separated values with a header, as RFC 4180 has them: lines end in CR LF. Without times the same everywhere.
std::string growth_csv(std::span<const GrowthRow> rows, bool with_times = true);

/// The one with the least work to a finished picture of `polygons` polygons, of the methods that are right for every
/// scene: not the painter's algorithm. The BSP tree counts as built beforehand. None when no row of theirs is without a
/// problem.
std::optional<GrowthMethod> growth_winner(std::span<const GrowthRow> rows, int polygons);

/// Who does least work where, and how work grows at the end of the curves, in two or three sentences; empty when nobody
/// wins.
std::string growth_summary(std::span<const GrowthRow> rows);

/// How long those methods took at the largest count that they all have, with the spread of the runs; empty when there
/// is none.
std::string growth_times(std::span<const GrowthRow> rows);

}  // namespace viewing
