// Every method measured on more and more polygons; each row is stopped at its time budget. Read growth_bench.h next.
#include "visibility/growth.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>
#include <utility>

#include "text/numbers.h"
#include "visibility/growth_bench.h"

namespace viewing {
namespace {

constexpr int most_polygons = 1'000'000;
constexpr std::size_t most_runs = 99;
constexpr double repeat_until_ms = 40.0;

WorkProgress::Clock::time_point in_ms(double ms) {
    using Clock = WorkProgress::Clock;
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>(ms));
}

/// What a row is of the whole: from `begin` on, `size` long.
struct Share {
    double begin, size;
};

std::string of_polygons(int count) {
    return grouped_number(count) + (count == 1 ? " polygon" : " polygons");
}

/// A method's part in the whole: its rows so far, and whether it is worth another one.
struct Candidate {
    std::string too_much;  ///< a subordinate clause: why it is not tried any more; empty while it is
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
    /// False when it was cancelled.
    bool measure_all(int count) {
        GrowthBench bench(request_, count);
        for (std::size_t i = 0; i < growth_method_count; ++i) {
            if (is_cancelled(progress_)) return false;
            const auto method = static_cast<GrowthMethod>(i);
            if (candidates_[i].is_over) continue;
            if (!candidates_[i].too_much.empty()) {
                add_last_row(method, count);
                continue;
            }
            const double share = count / all_counts_ / growth_method_count;
            GrowthRow row =
                measure(bench, method, {counts_done_ / all_counts_ + static_cast<double>(i) * share, share});
            if (is_cancelled(progress_)) return false;
            judge(row);
            add(std::move(row));
        }
        return true;
    }

    /// The median of some runs when they are short.
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
            if (is_late(progress) && !runs.empty()) break;  // a run that was cut short
            runs.push_back(std::move(row));
        } while (spent_ms < enough_ms && runs.size() < most_runs && runs.back().problem.empty());
        const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
        std::nth_element(runs.begin(), middle, runs.end(),
                         [](const GrowthRow& a, const GrowthRow& b) { return a.time_ms < b.time_ms; });
        if (runs.size() == 1 && is_late(progress)) middle->problem = stopped(*middle);
        return std::move(*middle);
    }

    std::string budget() const { return grouped_number(static_cast<std::int64_t>(request_.time_budget_ms)) + " ms"; }

    std::string stopped(const GrowthRow& row) const {
        return "With " + of_polygons(row.polygons) + " " + std::string(growth_method_name(row.method)) +
               " stopped after its " + budget() + ".";
    }

    /// Whether the method shall be tried again.
    void judge(const GrowthRow& row) {
        Candidate& candidate = candidates_[static_cast<std::size_t>(row.method)];
        if (!row.problem.empty()) {
            candidate.too_much = of_polygons(row.polygons) + " were too many for its budget";
        } else if (row.time_ms > request_.time_budget_ms) {
            candidate.too_much = of_polygons(row.polygons) + " took longer than " + budget();
        }
        const bool is_build = row.method == GrowthMethod::bsp_build;
        if (is_build && !row.problem.empty()) {
            candidates_[static_cast<std::size_t>(GrowthMethod::bsp_walk)].too_much = "the tree was not finished";
        }
    }

    void add_last_row(GrowthMethod method, int count) {
        Candidate& candidate = candidates_[static_cast<std::size_t>(method)];
        candidate.is_over = true;
        add({.method = method,
             .polygons = count,
             .operation_name = growth_operation_name(method),
             .problem = "From " + of_polygons(count) + " on " + std::string(growth_method_name(method)) +
                        " was not tried: " + candidate.too_much + "."});
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
    std::array<Candidate, growth_method_count> candidates_;
    std::vector<GrowthRow> rows_;
};

}  // namespace

std::vector<GrowthRow> measure_growth(const GrowthRequest& request, WorkProgress* progress,
                                      const std::function<void(const GrowthRow&)>& on_row) {
    return Growth(request, progress, on_row).run();
}

}  // namespace viewing
