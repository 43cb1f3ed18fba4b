// Growth of costs: the rows, their counts, how budgets and cancellation end a curve, and the report. The tests never
// check how long anything takes.
#include "topics/hidden/methods/growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>
#include <utility>

#include "text/numbers.h"
#include "topics/hidden/methods/bsp.h"
#include "unit/methods/scenes.h"

namespace viewing {
namespace {

constexpr double no_time_budget = 1e9;

std::vector<GrowthMethod> all_methods() {
    return {GrowthMethod::painter,  GrowthMethod::newell,   GrowthMethod::bsp_build,
            GrowthMethod::bsp_walk, GrowthMethod::z_buffer, GrowthMethod::ray_casting};
}

GrowthRequest small_request() {
    return {.counts = {10, 30, 100}, .width = 64, .height = 48, .time_budget_ms = no_time_budget};
}

std::vector<GrowthRow> rows_of(std::span<const GrowthRow> rows, GrowthMethod method) {
    std::vector<GrowthRow> own;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(own),
                 [&](const GrowthRow& row) { return row.method == method; });
    return own;
}

double longest_edge(const Polygon& polygon) {
    double longest = 0.0;
    for (const glm::dvec3& a : polygon.vertices) {
        for (const glm::dvec3& b : polygon.vertices) longest = std::max(longest, glm::length(a - b));
    }
    return longest;
}

double mean_longest_edge(std::span<const Polygon> polygons) {
    double sum = 0.0;
    for (const Polygon& polygon : polygons) sum += longest_edge(polygon);
    return sum / static_cast<double>(polygons.size());
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST(GrowthPolygons, AreSmallOrLargeAsRequested) {
    const std::vector<Polygon> small = growth_polygons({.scene = GrowthScene::small_triangles}, 2000);
    const std::vector<Polygon> large = growth_polygons({.scene = GrowthScene::large_triangles}, 2000);
    ASSERT_EQ(small.size(), 2000U);
    ASSERT_EQ(large.size(), 2000U);
    for (const Polygon& polygon : small) EXPECT_LE(longest_edge(polygon), 0.025 * 2.0);
    EXPECT_GT(mean_longest_edge(small), 0.015 * 2.0);
    EXPECT_GT(mean_longest_edge(large), 0.5 * 2.0);
    for (const auto& polygons : {small, large}) {
        const Bounds bounds = bounds_of(polygons);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(bounds.min[axis], -1.0, 0.03);
            EXPECT_NEAR(bounds.max[axis], 1.0, 0.03);
        }
    }
}

TEST(GrowthPolygons, FewerAreAPrefixOfMoreForEachSeed) {
    for (const GrowthScene scene : {GrowthScene::small_triangles, GrowthScene::large_triangles}) {
        const std::vector<Polygon> more = growth_polygons({.scene = scene, .seed = 7}, 50);
        const std::vector<Polygon> fewer = growth_polygons({.scene = scene, .seed = 7}, 20);
        for (std::size_t i = 0; i < fewer.size(); ++i) {
            EXPECT_EQ(fewer[i].vertices, more[i].vertices);
            EXPECT_EQ(fewer[i].source, static_cast<int>(i));
        }
        EXPECT_NE(growth_polygons({.scene = scene, .seed = 8}, 1)[0].vertices, more[0].vertices);
    }
}

TEST(GrowthPolygons, ThoseOfTheSceneAreSampledEvenly) {
    GrowthRequest request{.scene = GrowthScene::own_polygons};
    request.own_polygons = growth_polygons({}, 100);
    const auto sources = [&](int count) {
        std::vector<int> taken;
        for (const Polygon& polygon : growth_polygons(request, count)) taken.push_back(polygon.source);
        return taken;
    };
    EXPECT_EQ(sources(4), (std::vector{0, 25, 50, 75}));
    EXPECT_EQ(sources(3), (std::vector{0, 33, 66}));
    EXPECT_EQ(sources(100).back(), 99);
    EXPECT_EQ(sources(1000).size(), 100U);
    EXPECT_TRUE(sources(0).empty());
    EXPECT_TRUE(sources(-5).empty());
}

TEST(Growth, ReportsEveryMethodAtEveryCount) {
    std::vector<GrowthRow> told;
    std::vector<float> fractions;
    WorkProgress progress;
    GrowthRequest request = small_request();
    request.scene = GrowthScene::large_triangles;  // small ones may miss all pixel centers
    request.counts = {10, 30, 50};
    const std::vector<GrowthRow> rows = measure_growth(request, &progress, [&](const GrowthRow& row) {
        told.push_back(row);
        fractions.push_back(progress.fraction);
    });
    ASSERT_EQ(rows.size(), 3 * growth_method_count);
    ASSERT_EQ(told.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const GrowthRow& row = rows[i];
        EXPECT_EQ(row.method, all_methods()[i % growth_method_count]);
        EXPECT_EQ(row.polygons, request.counts[i / growth_method_count]);
        EXPECT_EQ(say(row.problem), "");
        EXPECT_GT(row.operations, 0);
        EXPECT_EQ(row.operation_name, growth_operation_name(row.method));
        EXPECT_GT(row.time_ms, 0.0);
        EXPECT_LE(row.painting_ms + row.build_ms, row.time_ms);
        EXPECT_EQ(row.build_ms > 0.0, row.method == GrowthMethod::ray_casting);
        EXPECT_EQ(row.painting_ms > 0.0, row.method == GrowthMethod::painter || row.method == GrowthMethod::newell ||
                                             row.method == GrowthMethod::bsp_walk);
        EXPECT_EQ(row.pixels_painted > 0, row.painting_ms > 0.0);
        EXPECT_GE(row.runs, 3);
        EXPECT_LE(row.time_least_ms, row.time_ms);
        EXPECT_LE(row.time_ms, row.time_most_ms);
        EXPECT_EQ(told[i].method, row.method);
        EXPECT_EQ(told[i].polygons, row.polygons);
        EXPECT_EQ(told[i].operations, row.operations);
    }
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(progress.fraction, 1.0F);
}

TEST(Growth, CountsAreRepeatable) {
    for (const GrowthScene scene : {GrowthScene::small_triangles, GrowthScene::large_triangles}) {
        GrowthRequest request = small_request();
        request.scene = scene;
        request.counts = {10, 40};
        const std::vector<GrowthRow> first = measure_growth(request), second = measure_growth(request);
        request.seed = 2;
        const std::vector<GrowthRow> other = measure_growth(request);
        ASSERT_EQ(first.size(), second.size());
        int differing = 0;
        for (std::size_t i = 0; i < first.size(); ++i) {
            EXPECT_EQ(first[i].operations, second[i].operations) << growth_method_name(first[i].method);
            differing += first[i].operations != other[i].operations;
        }
        EXPECT_GT(differing, 4);
    }
}

/// Counts the pixel centers that the triangle covers on the screen by testing each center.
std::int64_t covered_pixels(const Polygon& triangle, const Viewpoint& viewpoint, int width, int height) {
    std::array<glm::dvec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec4 clip = viewpoint.clip_from_world() * glm::dvec4(triangle.vertices[i], 1.0);
        corners[i] = {(0.5 + 0.5 * clip.x / clip.w) * width, (0.5 - 0.5 * clip.y / clip.w) * height};
    }
    const auto side = [&](std::size_t i, const glm::dvec2& p) {
        const glm::dvec2 edge = corners[(i + 1) % 3] - corners[i], to_point = p - corners[i];
        return edge.x * to_point.y - edge.y * to_point.x > 0.0;
    };
    std::int64_t covered = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec2 center(x + 0.5, y + 0.5);
            covered += side(0, center) == side(1, center) && side(1, center) == side(2, center);
        }
    }
    return covered;
}

TEST(Growth, CountsTheWorkOfEachMethod) {
    GrowthRequest request = small_request();
    request.scene = GrowthScene::large_triangles;
    request.counts = {25};
    request.viewpoint = viewpoint_at({0.5, 1.0, 6.0}, {0.0, 0.0, 0.0});
    const std::vector<GrowthRow> rows = measure_growth(request);
    const std::vector<Polygon> polygons = growth_polygons(request, 25);
    std::int64_t pixels = 0;
    for (const Polygon& polygon : polygons) pixels += covered_pixels(polygon, *request.viewpoint, 64, 48);
    EXPECT_EQ(rows_of(rows, GrowthMethod::z_buffer)[0].operations, pixels);
    EXPECT_EQ(rows_of(rows, GrowthMethod::bsp_walk)[0].operations,
              static_cast<std::int64_t>(build_bsp(polygons).nodes.size()));
    // A ray tests at least the root's box. Sorting takes at least n − 1 comparisons and here at most 2 n log2 n.
    EXPECT_GE(rows_of(rows, GrowthMethod::ray_casting)[0].operations, 64 * 48);
    EXPECT_GE(rows_of(rows, GrowthMethod::painter)[0].operations, 24);
    EXPECT_LE(rows_of(rows, GrowthMethod::painter)[0].operations, 2 * 25 * 5);
}

TEST(Growth, SortsItsCounts) {
    GrowthRequest request = small_request();
    request.counts = {30, -1, 10, 0, 30};
    std::vector<int> counts;
    measure_growth(request, nullptr, [&](const GrowthRow& row) { counts.push_back(row.polygons); });
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    EXPECT_EQ(counts, (std::vector{10, 30}));

    request.scene = GrowthScene::own_polygons;
    request.own_polygons = growth_polygons({}, 20);
    const std::vector<GrowthRow> own = rows_of(measure_growth(request), GrowthMethod::z_buffer);
    ASSERT_EQ(own.size(), 2U);
    EXPECT_EQ(own[0].polygons, 10);
    EXPECT_EQ(own[1].polygons, 20);
}

TEST(Growth, HandlesEmptyRequests) {
    GrowthRequest request = small_request();
    request.counts = {};
    WorkProgress progress;
    EXPECT_TRUE(measure_growth(request, &progress).empty());
    EXPECT_EQ(progress.fraction, 1.0F);
    request = small_request();
    request.scene = GrowthScene::own_polygons;
    EXPECT_TRUE(measure_growth(request).empty());
    request = small_request();
    request.width = request.height = 0;
    EXPECT_EQ(measure_growth(request).size(), 3 * growth_method_count);
}

TEST(Growth, CanBeCanceledBetweenRows) {
    WorkProgress progress;
    int told = 0;
    const std::vector<GrowthRow> rows = measure_growth(small_request(), &progress, [&](const GrowthRow&) {
        if (++told == 8) progress.canceled = true;
    });
    EXPECT_EQ(rows.size(), 8U);
    EXPECT_EQ(told, 8);
    EXPECT_LT(progress.fraction, 1.0F);
}

/// Without cancellation, the measurement would take longer than a lifetime.
TEST(Growth, CanBeCanceledWithinARow) {
    GrowthRequest request = small_request();
    request.scene = GrowthScene::large_triangles;
    request.counts = {50'000};
    request.max_fragments = 2'000'000'000;
    WorkProgress progress;
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        progress.canceled = true;
    });
    EXPECT_LE(measure_growth(request, &progress).size(), 1U);  // only the painter's row can be complete
    canceller.join();
}

TEST(Growth, FragmentBudgetEndsACurveWithASentence) {
    GrowthRequest request = small_request();
    request.scene = GrowthScene::large_triangles;
    request.counts = {3, 60, 70, 80};
    request.max_fragments = 200;
    const std::vector<GrowthRow> rows = measure_growth(request);

    const std::vector<GrowthRow> build = rows_of(rows, GrowthMethod::bsp_build);
    ASSERT_EQ(build.size(), 3U);
    EXPECT_EQ(say(build[0].problem), "");
    EXPECT_TRUE(contains(say(build[1].problem), "budget of 200 fragments")) << say(build[1].problem);
    EXPECT_GT(build[1].operations, 0);
    EXPECT_EQ(
        say(build[2].problem),
        "With 70 polygons or more, building the BSP tree was not tried: 60 polygons already exceeded its budget.");
    EXPECT_EQ(build[2].operations, 0);
    EXPECT_EQ(build[2].time_ms, 0.0);

    const std::vector<GrowthRow> walk = rows_of(rows, GrowthMethod::bsp_walk);
    ASSERT_EQ(walk.size(), 2U);
    EXPECT_EQ(say(walk[0].problem), "");
    EXPECT_EQ(walk[1].polygons, 60);
    EXPECT_EQ(say(walk[1].problem),
              "With 60 polygons or more, walking the BSP tree was not tried: the tree was not finished.");

    for (const GrowthMethod method : {GrowthMethod::painter, GrowthMethod::z_buffer, GrowthMethod::ray_casting}) {
        const std::vector<GrowthRow> untouched = rows_of(rows, method);
        EXPECT_EQ(untouched.size(), 4U);
        for (const GrowthRow& row : untouched) EXPECT_EQ(say(row.problem), "");
    }
}

TEST(Growth, TimeBudgetEndsEveryCurveWithASentence) {
    GrowthRequest request = small_request();
    request.time_budget_ms = 0.0;
    const std::vector<GrowthRow> rows = measure_growth(request);
    for (const GrowthMethod method : all_methods()) {
        const std::vector<GrowthRow> own = rows_of(rows, method);
        ASSERT_GE(own.size(), 1U);
        ASSERT_LE(own.size(), 2U);
        EXPECT_TRUE(contains(say(own.back().problem), "was not tried")) << say(own.back().problem);
        EXPECT_TRUE(contains(say(own.back().problem), growth_method_name(method)));
    }
}

TEST(Growth, TimeBudgetStopsARunningMethod) {
    GrowthRequest request = small_request();
    request.scene = GrowthScene::large_triangles;
    request.counts = {50'000};
    request.max_fragments = 2'000'000'000;
    request.time_budget_ms = 30.0;
    const std::vector<GrowthRow> newell = rows_of(measure_growth(request), GrowthMethod::newell);
    ASSERT_EQ(newell.size(), 1U);
    EXPECT_EQ(say(newell[0].problem), "With 50,000 polygons, Newell's sort stopped at its limit of 30 ms.");
}

/// Parses records of fields as RFC 4180 defines them.
std::vector<std::vector<std::string>> parsed_csv(std::string_view text) {
    std::vector<std::vector<std::string>> records;
    std::vector<std::string> record(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (is_quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            record.back() += text[++i];
        } else if (c == '"') {
            is_quoted = !is_quoted;
        } else if (!is_quoted && c == ',') {
            record.emplace_back();
        } else if (!is_quoted && c == '\r' && text.substr(i, 2) == "\r\n") {
            records.push_back(std::exchange(record, std::vector<std::string>(1)));
            ++i;
        } else {
            record.back() += c;
        }
    }
    EXPECT_EQ(record, std::vector<std::string>(1)) << "the last line ends with a newline";
    return records;
}

TEST(GrowthReport, CsvReadsBack) {
    const std::vector<GrowthRow> rows{{.method = GrowthMethod::newell,
                                       .polygons = 30,
                                       .time_ms = 0.1 + 0.2,
                                       .operation_name = "pair tests",
                                       .operations = 1234567890123,
                                       .pixels_painted = 77,
                                       .painting_ms = 0.25,
                                       .time_least_ms = 0.125,
                                       .time_most_ms = 1.0,
                                       .runs = 5},
                                      {.method = GrowthMethod::z_buffer,
                                       .polygons = 1000,
                                       .time_ms = 1e-7,
                                       .operation_name = "pixels tested",
                                       .problem = "It said \"stop\", and\r\nthen nothing.",
                                       .build_ms = 1.5,
                                       .runs = 1}};
    const auto records = parsed_csv(growth_csv(rows));
    ASSERT_EQ(records.size(), 3U);
    EXPECT_EQ(records[0], (std::vector<std::string>{"method", "polygons", "operation", "operations", "pixels_painted",
                                                    "problem", "time_ms", "time_least_ms", "time_most_ms", "runs",
                                                    "painting_ms", "build_ms"}));
    const auto without_times = parsed_csv(growth_csv(rows, false));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::vector<std::string>& record = records[i + 1];
        ASSERT_EQ(record.size(), 12U);
        EXPECT_EQ(record[0], growth_method_name(rows[i].method));
        EXPECT_EQ(std::stoi(record[1]), rows[i].polygons);
        EXPECT_EQ(record[2], rows[i].operation_name);
        EXPECT_EQ(std::stoll(record[3]), rows[i].operations);
        EXPECT_EQ(std::stoll(record[4]), rows[i].pixels_painted);
        EXPECT_EQ(record[5], say(rows[i].problem));
        EXPECT_EQ(std::stod(record[6]), rows[i].time_ms);
        EXPECT_EQ(std::stod(record[7]), rows[i].time_least_ms);
        EXPECT_EQ(std::stod(record[8]), rows[i].time_most_ms);
        EXPECT_EQ(std::stoi(record[9]), rows[i].runs);
        EXPECT_EQ(std::stod(record[10]), rows[i].painting_ms);
        EXPECT_EQ(std::stod(record[11]), rows[i].build_ms);
        EXPECT_EQ(without_times[i + 1], std::vector<std::string>(record.begin(), record.begin() + 6));
    }
    EXPECT_EQ(parsed_csv(growth_csv({})).size(), 1U);
}

TEST(GrowthReport, WinnerDoesTheLeastWorkOfTheRightMethods) {
    Random random(seed);
    for (int round = 0; round < 200; ++round) {
        std::map<std::int64_t, GrowthMethod> by_work;  // the valid rows with 100 polygons
        std::vector<GrowthRow> rows;
        for (const GrowthMethod method : all_methods()) {
            for (const int polygons : {10, 100, 1000}) {
                GrowthRow row{.method = method, .polygons = polygons, .time_ms = random.number(0.0, 10.0)};
                row.operations = static_cast<std::int64_t>(random.number(0.0, 1e9));
                row.pixels_painted = static_cast<std::int64_t>(random.number(0.0, 1e9));
                if (random.number(0.0, 1.0) < 0.4) row.problem = "Too slow.";
                rows.push_back(row);
                const bool may_win = method != GrowthMethod::painter && method != GrowthMethod::bsp_build;
                if (polygons == 100 && may_win && row.problem.empty())
                    by_work[row.operations + row.pixels_painted] = method;
            }
        }
        const auto winner = growth_winner(rows, 100);
        ASSERT_EQ(winner.has_value(), !by_work.empty());
        if (winner) {
            EXPECT_EQ(*winner, by_work.begin()->second);
        }
        EXPECT_FALSE(growth_winner(rows, 101));
    }
}

TEST(GrowthReport, IsRepeatable) {
    GrowthRequest request;
    request.counts = {10, 100, 400};
    request.time_budget_ms = std::numeric_limits<double>::infinity();
    const std::vector<GrowthRow> first = measure_growth(request), again = measure_growth(request);
    EXPECT_EQ(growth_csv(first, false), growth_csv(again, false));
    EXPECT_EQ(growth_summary(first), growth_summary(again));
    for (const GrowthRow& row : first) EXPECT_EQ(say(row.problem), "");
}

GrowthRow worked(GrowthMethod method, int polygons, std::int64_t work) {
    return {.method = method, .polygons = polygons, .operations = work - work / 3, .pixels_painted = work / 3};
}

TEST(GrowthReport, SummaryNamesTheWinners) {
    EXPECT_TRUE(growth_summary({}).empty());
    const std::vector<GrowthRow> one{worked(GrowthMethod::z_buffer, 1000, 2000)};
    EXPECT_EQ(say(growth_summary(one)),
              "Methods with the fewest operations, painting included, among those that are always correct: the "
              "software z-buffer with 1,000 polygons.");
    const std::vector<GrowthRow> rows{
        worked(GrowthMethod::painter, 10, 100),           worked(GrowthMethod::bsp_walk, 10, 1000),
        worked(GrowthMethod::z_buffer, 10, 2000),         worked(GrowthMethod::bsp_walk, 30, 1900),
        worked(GrowthMethod::z_buffer, 30, 2000),         worked(GrowthMethod::bsp_walk, 300, 9000),
        worked(GrowthMethod::z_buffer, 300, 3000),        worked(GrowthMethod::z_buffer, 1000, 6000),
        worked(GrowthMethod::ray_casting, 1000, 9000),    worked(GrowthMethod::z_buffer, 10'000, 24'000),
        worked(GrowthMethod::ray_casting, 10'000, 18'000)};
    EXPECT_EQ(
        say(growth_summary(rows)),
        "Methods with the fewest operations, painting included, among those that are always correct: walking the BSP "
        "tree up to 30 polygons, the software z-buffer from 300 to 1,000 polygons, ray casting for 10,000 or more. One "
        "tree, built in advance, serves every eye position. At the end of the curves, ten times as many polygons "
        "multiply the number of operations by a factor of 5 for walking the BSP tree, by 4 for the software z-buffer, "
        "by 2 for ray casting.");
}

TEST(GrowthReport, TimesAreThoseOfTheLargestCommonCount) {
    std::vector<GrowthRow> rows;
    for (const int polygons : {100, 1000, 10'000})
        for (const GrowthMethod method : all_methods()) {
            GrowthRow row{.method = method, .polygons = polygons, .time_ms = 0.01 * polygons};
            row.time_least_ms = 0.5 * row.time_ms;
            row.time_most_ms = 2.0 * row.time_ms;
            if (polygons == 10'000 && method == GrowthMethod::newell) row.problem = "Too many.";
            rows.push_back(row);
        }
    EXPECT_EQ(say(growth_times(rows)),
              "Median times of several runs with 1,000 polygons: Newell's sort 10 ms (5 to 20), walking the BSP tree "
              "10 ms (5 to 20), the software z-buffer 10 ms (5 to 20), ray casting 10 ms (5 to 20).");
    EXPECT_TRUE(growth_times({}).empty());
}

TEST(GrowthReport, GroupsDigits) {
    EXPECT_EQ(grouped_number(0), "0");
    EXPECT_EQ(grouped_number(999), "999");
    EXPECT_EQ(grouped_number(1000), "1,000");
    EXPECT_EQ(grouped_number(-123456), "-123,456");
    EXPECT_EQ(grouped_number(100'000), "100,000");
    EXPECT_EQ(grouped_number(1'234'567), "1,234,567");
}

}  // namespace
}  // namespace viewing
