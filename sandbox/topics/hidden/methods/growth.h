// Measures how costs grow: runs every method on more and more polygons, and records its time and the count of its most
// frequent operation. Modeled on the comparison of ten algorithms by Sutherland, Sproull and Schumacker 1974. Read
// growth.cpp next.
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
#include "text/message.h"
#include "topics/hidden/methods/polygons.h"
#include "topics/hidden/methods/viewpoint.h"

namespace viewing {

/// The methods, in the order in which they are measured. A BSP tree is built independently of the eye and then
/// traversed for one eye.
enum class GrowthMethod { painter, newell, bsp_build, bsp_walk, z_buffer, ray_casting };
inline constexpr std::size_t growth_method_count = 6;

/// Returns the method's name as used in the middle of a sentence: "the software z-buffer". The name is in English; pass
/// it to tr_part() before showing it.
std::string_view growth_method_name(GrowthMethod method);

/// Returns the name of the method's most frequent operation, in the plural: "pixels tested".
std::string_view growth_operation_name(GrowthMethod method);

/// Random triangles in a cube of side 2, or the scene's own polygons. `seed` determines the triangles, in the same way
/// on every platform. The corners of a small triangle are on a sphere whose diameter is 2.5 % of the side; those of a
/// large one are anywhere in the cube, so that a large triangle intersects many others.
enum class GrowthScene { small_triangles, large_triangles, own_polygons };

struct GrowthRequest {
    GrowthScene scene = GrowthScene::small_triangles;
    std::vector<Polygon> own_polygons{};  ///< for GrowthScene::own_polygons; each row uses some of them, evenly spaced
    std::vector<int> counts{10, 30, 100, 300, 1'000, 3'000, 10'000, 30'000, 100'000};
    int width = 320, height = 240;         ///< size of the picture in pixels; at least 1
    std::optional<Viewpoint> viewpoint{};  ///< if none, the view contains the whole scene
    double time_budget_ms = 4000.0;        ///< for each row; if infinite, only the two limits below stop a method
    int max_fragments = 1'000'000;         ///< for a BSP tree and for Newell's sort
    std::int64_t max_pairs = std::numeric_limits<std::int64_t>::max();  ///< limit on pairs that Newell's sort compares
    unsigned seed = 1;
};

/// One point of a curve.
struct GrowthRow {
    GrowthMethod method = GrowthMethod::painter;
    int polygons = 0;
    double time_ms = 0.0;  ///< time until the picture (for bsp_build: the tree) is finished; the median of the runs
    std::string_view operation_name{};
    std::int64_t operations = 0;
    std::int64_t pixels_painted = 0;  ///< painted in the order that the method found; 0 if it finds none
    Message problem{};                ///< a sentence if a budget stopped the method, or if it is no longer tried
    double painting_ms = 0.0;         ///< part of time_ms: painting in the order that the method found
    double build_ms = 0.0;            ///< part of time_ms: building the hierarchy for the rays
    double time_least_ms = 0.0, time_most_ms = 0.0;  ///< shortest and longest of all runs
    int runs = 0;

    /// Returns the work by which methods are compared; unlike times, it is repeatable. Every operation and every
    /// painted pixel counts as one.
    std::int64_t work() const { return operations + pixels_painted; }
};

/// Returns the polygons for a given count: `count` random triangles, or at most `count` of the scene's own polygons.
/// The triangles for a larger count begin with those for a smaller one.
std::vector<Polygon> growth_polygons(const GrowthRequest& request, int count);

/// Measures all methods at the lowest count, then at the next one, and so on; calls `on_row` with each row as it is
/// added. Sorts the counts, drops those below 1 and duplicates, and limits them to a million random triangles or to the
/// number of the scene's own polygons. Runs each method three times, or more often if it is quick, or less often if
/// another run would exceed the budget. A method that a budget stopped, or that exceeded its time, is not tried again;
/// it gets one more row, at the next count, with a `problem` that says so. A row's number of operations depends on time
/// only if the time budget stopped the method. If canceled, returns the finished rows.
std::vector<GrowthRow> measure_growth(const GrowthRequest& request, WorkProgress* progress = nullptr,
                                      const std::function<void(const GrowthRow&)>& on_row = {});

/// Returns comma-separated values with a header, as in RFC 4180: lines end in CR LF. Without times, the values are the
/// same on every machine, unless the time budget stopped a method.
std::string growth_csv(std::span<const GrowthRow> rows, bool with_times = true);

/// Returns the method with the least work for a finished picture of `polygons` polygons, among those that are correct
/// for every scene, which excludes the painter's algorithm. The BSP tree counts as built beforehand. Returns none if
/// all of their rows have a problem.
std::optional<GrowthMethod> growth_winner(std::span<const GrowthRow> rows, int polygons);

/// Says in two or three sentences which method does the least work for which counts, and how work grows at the end of
/// the curves; empty if no method wins.
Message growth_summary(std::span<const GrowthRow> rows);

/// Says how long the always-correct methods took at the largest count that all of them finished, with the spread of the
/// runs; empty if there is no such count.
Message growth_times(std::span<const GrowthRow> rows);

}  // namespace viewing
