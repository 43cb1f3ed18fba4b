#include "suite/suite_run.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <numeric>
#include <utility>

#include "platform/child_process.h"
#include "platform/ending_signals.h"
#include "state/file/reader.h"
#include "text/numbers.h"
#include "text/words.h"

namespace viewing {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// One worker and its current entry.
struct Worker {
    ChildProcess process;
    bool has_begun = false;              ///< it has reported its renderer
    std::optional<std::size_t> place{};  ///< index of its entry in RunWish::chosen
    Clock::time_point since = Clock::now();
};

class Run {
public:
    Run(const Suite& suite, const RunWish& wish) : suite_(suite), wish_(wish), done_(wish.chosen.size()) {
        for (std::size_t place = 0; place < wish.chosen.size(); ++place) waiting_.push_back(place);
    }

    GatheredResults all() {
        while (finished_ < done_.size() && !results_.failure && EndingNote::signal() == 0) {
            hire();
            if (results_.failure) break;
            listen();
            if (EndingNote::signal() != 0) break;
            for (std::size_t i = workers_.size(); i-- > 0;)
                if (!serve(workers_[i])) workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
        }
        if (finished_ < done_.size() && !results_.failure) end_early();
        for (Worker& worker : workers_) {
            worker.process.finish_telling();
            worker.process.wait();
        }
        if (!results_.failure) results_.entries = std::move(done_);
        return std::move(results_);
    }

private:
    /// Keeps the entries that workers have finished; the others count as not drawn and keep their keys.
    void end_early() {
        results_.ended_by = EndingNote::signal();
        for (Worker& worker : workers_) {
            worker.process.end();
            for (const std::string& line : worker.process.take_lines()) hear(worker, line);
        }
        for (std::size_t place = 0; place < done_.size(); ++place) {
            if (!done_[place].name.empty()) continue;
            const SuiteEntry& entry = suite_.entries[wish_.chosen[place]];
            done_[place] = result_for(entry);
            done_[place].outcome = Outcome::not_drawn;
            done_[place].reasons = {std::string("the run was ended early by ") +
                                    name_of_ending_signal(results_.ended_by)};
            done_[place].key = known_key(entry);
        }
    }

    std::string known_key(const SuiteEntry& entry) const {
        const auto known = wish_.known_keys.find(entry.name);
        return known == wish_.known_keys.end() ? "" : known->second;
    }

    void hire() {
        const auto busy = static_cast<std::size_t>(
            std::count_if(workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.place; }));
        const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(wish_.jobs, 1)), busy + waiting_.size());
        while (workers_.size() < wanted) {
            Result<ChildProcess> started = ChildProcess::start(wish_.worker);
            if (!started) {
                results_.failure = NoWorker{9, started.error()};
                return;
            }
            workers_.push_back({.process = *std::move(started)});
        }
    }

    void listen() {
        std::vector<ChildProcess*> processes;
        double patience_s = wish_.entry_timeout_s;
        for (Worker& worker : workers_) {
            processes.push_back(&worker.process);
            patience_s = std::min(patience_s, wish_.entry_timeout_s - seconds_since(worker.since));
        }
        ChildProcess::listen(processes, std::max(patience_s, 0.0) + 0.01, EndingNote::file());
    }

    /// Returns false if this worker has ended.
    bool serve(Worker& worker) {
        for (const std::string& line : worker.process.take_lines())
            if (!hear(worker, line)) return lose(worker, "unreadable answer from the worker: " + excerpt(line));
        if (!worker.process.is_running()) return lose(worker, "");
        if ((worker.place || !worker.has_begun) && seconds_since(worker.since) > wish_.entry_timeout_s)
            return lose(worker, "not finished within " + figures(wish_.entry_timeout_s) + " s");
        if (worker.has_begun && !worker.place && !waiting_.empty()) ask(worker);
        return true;
    }

    bool hear(Worker& worker, const std::string& line) {
        const auto heard = guarded([&] { return parse_document(line, ""); });
        if (!heard) return false;
        if (!worker.has_begun) {
            worker.has_begun = heard->is_object() && heard->contains("renderer") && (*heard)["renderer"].is_string();
            if (worker.has_begun) results_.renderer = (*heard)["renderer"].get<std::string>();
            return worker.has_begun;
        }
        Result<EntryResult> result = guarded([&] { return read_entry_result(*heard, {"", ""}); });
        if (!result || !worker.place) return false;
        result->output = worker.process.take_complaints();
        finish(worker, *std::move(result));
        return true;
    }

    void ask(Worker& worker) {
        worker.place = waiting_.front();
        worker.since = Clock::now();
        waiting_.pop_front();
        const std::size_t entry = wish_.chosen[*worker.place];
        const Json request{{"entry", entry}, {"key", known_key(suite_.entries[entry])}};
        worker.process.tell(request.dump());  // if the worker has ended, serve() notices
    }

    /// Marks the worker's entry as failed; if the worker has not reported a renderer yet, ends the whole run.
    bool lose(Worker& worker, const std::string& why) {
        const std::string end = why.empty() ? worker.process.wait() : worker.process.end();
        const std::string complaint = worker.process.take_complaints();
        if (!worker.has_begun) {
            const int status = worker.process.exit_status();
            results_.failure = NoWorker{why.empty() && status > 0 ? status : 9,
                                        complaint.empty() ? "the worker ended with " + end : complaint};
            return false;
        }
        if (!worker.place) return false;
        const SuiteEntry& entry = suite_.entries[wish_.chosen[*worker.place]];
        EntryResult result = result_for(entry);
        result.reasons = {why.empty() ? "the program crashed: " + end : why};
        result.output = complaint;
        finish(worker, std::move(result));
        return false;
    }

    void finish(Worker& worker, EntryResult result) {
        result.seconds = seconds_since(worker.since);
        const std::size_t place = *std::exchange(worker.place, std::nullopt);
        done_[place] = std::move(result);
        ++finished_;
        if (wish_.tell) wish_.tell(done_[place], finished_);
    }

    const Suite& suite_;
    const RunWish& wish_;
    std::deque<std::size_t> waiting_;
    std::vector<Worker> workers_;
    std::vector<EntryResult> done_;
    std::size_t finished_ = 0;
    GatheredResults results_;
};

}  // namespace

GatheredResults run_entries(const Suite& suite, const RunWish& wish) {
    return Run(suite, wish).all();
}

std::vector<std::size_t> entries_of_shard(const Suite& suite, int index, int count,
                                          const std::map<std::string, double>& seconds) {
    double known_s = 0.0;
    int known = 0;
    for (const SuiteEntry& entry : suite.entries)
        if (const auto found = seconds.find(entry.name); found != seconds.end()) {
            known_s += found->second;
            ++known;
        }
    const double mean_s = known > 0 ? known_s / known : 1.0;
    const auto cost_of = [&](std::size_t entry) {
        const auto found = seconds.find(suite.entries[entry].name);
        return found == seconds.end() ? mean_s : found->second;
    };
    std::vector<std::size_t> order(suite.entries.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return cost_of(a) > cost_of(b); });
    std::vector<double> load(static_cast<std::size_t>(count), 0.0);
    std::vector<std::size_t> own;
    for (const std::size_t entry : order) {
        const auto least = std::min_element(load.begin(), load.end());
        *least += cost_of(entry);
        if (least - load.begin() == index - 1) own.push_back(entry);
    }
    std::sort(own.begin(), own.end());
    return own;
}

}  // namespace viewing
