// Measures every method on more and more polygons; a time budget limits each row. Read growth_bench.h next.
#include "topics/hidden/methods/growth.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <utility>

#include "text/catalogue.h"
#include "text/per_enum.h"
#include "topics/hidden/methods/growth_bench.h"

namespace viewing {
namespace {

constexpr int most_polygons = 1'000'000;
constexpr std::size_t fewest_runs = 3, most_runs = 99;
constexpr double repeat_until_ms = 40.0;

WorkProgress::Clock::time_point in_ms(double ms) {
    using Clock = WorkProgress::Clock;
    if (!std::isfinite(ms)) return Clock::time_point::max();
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>(ms));
}

/// A row's share of the total progress: it starts at `begin` and is `size` long.
struct Share {
    double begin, size;
};

Message polygons_message(int count) {
    const std::string number = grouped_number(count);
    return count == 1 ? message("{count} polygon", "count"_a = number)
                      : message("{count} polygons", "count"_a = number);
}

/// The reason why a method is no longer tried.
enum class TooMuch { nothing, polygons, time, missing_tree };

/// A method's state between rows: whether another row is worthwhile.
struct Candidate {
    TooMuch too_much = TooMuch::nothing;
    int too_many = 0;  ///< polygon count that was too much for the method
    bool is_over = false;
};

class Growth {
public:
    Growth(const GrowthRequest& request, WorkProgress* progress, const std::function<void(const GrowthRow&)>& on_row)
        : request_(request), progress_(progress), on_row_(on_row) {
        for (const int count : request.counts) {
            const bool is_own = request.scene == GrowthScene::own_polygons;
            const int there = is_own ? static_cast<int>(request.own_polygons.size()) : most_polygons;
            if (std::min(count, there) >= 1) counts_.push_back(std::min(count, there));
        }
        std::sort(counts_.begin(), counts_.end());
        counts_.erase(std::unique(counts_.begin(), counts_.end()), counts_.end());
        all_counts_ = std::accumulate(counts_.begin(), counts_.end(), 0.0);
    }

    std::vector<GrowthRow> run() {
        for (const int count : counts_) {
            if (!measure_all(count)) return std::move(rows_);
            counts_done_ += count;
        }
        report(progress_, 1.0);
        return std::move(rows_);
    }

private:
    /// Returns false if canceled.
    bool measure_all(int count) {
        GrowthBench bench(request_, count);
        for (std::size_t i = 0; i < growth_method_count; ++i) {
            if (is_canceled(progress_)) return false;
            const auto method = static_cast<GrowthMethod>(i);
            if (candidates_[i].is_over) continue;
            if (candidates_[i].too_much != TooMuch::nothing) {
                add_last_row(method, count);
                continue;
            }
            const double share = count / all_counts_ / growth_method_count;
            GrowthRow row =
                measure(bench, method, {counts_done_ / all_counts_ + static_cast<double>(i) * share, share});
            if (is_canceled(progress_)) return false;
            judge(row);
            add(std::move(row));
        }
        return true;
    }

    /// Returns the median of several runs, or a single run if another one would exceed the budget.
    GrowthRow measure(GrowthBench& bench, GrowthMethod method, const Share& share) const {
        WorkProgress progress{.whole = progress_,
                              .begin = share.begin,
                              .end = share.begin + share.size,
                              .deadline = in_ms(request_.time_budget_ms)};
        const double enough_ms = std::min(repeat_until_ms, 0.1 * request_.time_budget_ms);
        std::vector<GrowthRow> runs;
        double spent_ms = 0.0;
        do {
            GrowthRow row = bench.run(method, &progress);
            spent_ms += row.time_ms;
            if (is_late(progress) && !runs.empty()) break;  // drops a run that was cut short
            runs.push_back(std::move(row));
        } while (runs.back().problem.empty() && spent_ms + runs.back().time_ms < request_.time_budget_ms &&
                 (runs.size() < fewest_runs || (spent_ms < enough_ms && runs.size() < most_runs)));
        const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
        const auto is_faster = [](const GrowthRow& a, const GrowthRow& b) { return a.time_ms < b.time_ms; };
        std::nth_element(runs.begin(), middle, runs.end(), is_faster);
        const auto [least, most] = std::minmax_element(runs.begin(), runs.end(), is_faster);
        middle->time_least_ms = least->time_ms;
        middle->time_most_ms = most->time_ms;
        middle->runs = static_cast<int>(runs.size());
        if (runs.size() == 1 && is_late(progress)) middle->problem = stopped(*middle);
        return std::move(*middle);
    }

    Message budget() const {
        return message("{number} ms", "number"_a = grouped_number(static_cast<std::int64_t>(request_.time_budget_ms)));
    }

    Message stopped(const GrowthRow& row) const {
        return message("With {polygons}, {method} stopped at its limit of {budget}.",
                       "polygons"_a = polygons_message(row.polygons),
                       "method"_a = Message(growth_method_name(row.method), {}), "budget"_a = budget());
    }

    /// Decides whether to try the method again.
    void judge(const GrowthRow& row) {
        Candidate& candidate = candidates_[row.method];
        candidate.too_many = row.polygons;
        if (!row.problem.empty()) {
            candidate.too_much = TooMuch::polygons;
        } else if (row.time_ms > request_.time_budget_ms) {
            candidate.too_much = TooMuch::time;
        }
        const bool is_build = row.method == GrowthMethod::bsp_build;
        if (is_build && !row.problem.empty()) {
            candidates_[GrowthMethod::bsp_walk].too_much = TooMuch::missing_tree;
        }
    }

    Message not_tried(const Candidate& candidate, GrowthMethod method, int count) const {
        const Message from = polygons_message(count), many = polygons_message(candidate.too_many);
        const Message name(growth_method_name(method), {});
        switch (candidate.too_much) {
            case TooMuch::polygons:
                return message(
                    "With {polygons} or more, {method} was not tried: {too_many} already exceeded its budget.",
                    "polygons"_a = from, "method"_a = name, "too_many"_a = many);
            case TooMuch::time:
                return message(
                    "With {polygons} or more, {method} was not tried: {too_many} already took longer than {budget}.",
                    "polygons"_a = from, "method"_a = name, "too_many"_a = many, "budget"_a = budget());
            case TooMuch::missing_tree:
                return message("With {polygons} or more, {method} was not tried: the tree was not finished.",
                               "polygons"_a = from, "method"_a = name);
            case TooMuch::nothing:
                break;
        }
        return {};
    }

    void add_last_row(GrowthMethod method, int count) {
        Candidate& candidate = candidates_[method];
        candidate.is_over = true;
        add({.method = method,
             .polygons = count,
             .operation_name = growth_operation_name(method),
             .problem = not_tried(candidate, method, count)});
    }

    void add(GrowthRow row) {
        rows_.push_back(std::move(row));
        if (on_row_) on_row_(rows_.back());
    }

    const GrowthRequest& request_;
    WorkProgress* progress_;
    const std::function<void(const GrowthRow&)>& on_row_;
    std::vector<int> counts_;  ///< ascending
    double counts_done_ = 0.0, all_counts_ = 0.0;
    PerEnum<GrowthMethod, Candidate, growth_method_count> candidates_{};
    std::vector<GrowthRow> rows_;
};

}  // namespace

std::vector<GrowthRow> measure_growth(const GrowthRequest& request, WorkProgress* progress,
                                      const std::function<void(const GrowthRow&)>& on_row) {
    return Growth(request, progress, on_row).run();
}

}  // namespace viewing
