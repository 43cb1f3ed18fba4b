// Runs a suite: distributes its entries to worker processes and collects their results. An entry that crashes or takes
// too long fails alone; the others continue with a new worker. While there is an EndingNote, a signal ends the run
// early: it terminates the workers, and unfinished entries count as not drawn.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "suite/results.h"

namespace viewing {

struct RunWish {
    std::vector<std::string> worker;                ///< the program that draws, with its arguments
    std::vector<std::size_t> chosen;                ///< entries of the suite, in order
    std::map<std::string, std::string> known_keys;  ///< keyed by name, for results that passed
    int jobs = 1;
    double entry_timeout_s = 60.0;
    /// Called after each entry, with the number of finished entries.
    std::function<void(const EntryResult&, std::size_t)> tell = {};
};

/// The reason why there is no result at all: no worker could start.
struct NoWorker {
    int exit_status = 9;
    std::string complaint;
};

/// Either the results, in the order of `chosen`, or a failure.
struct GatheredResults {
    std::vector<EntryResult> entries;
    int ended_by = 0;  ///< the signal that ended the run early
    std::string renderer;
    std::optional<NoWorker> failure;
};
GatheredResults run_entries(const Suite& suite, const RunWish& wish);

/// Returns the entries of shard `index` of `count`, counted from 1. Assigns the entries from slowest to fastest, those
/// with equal times in the order of the suite, each to the shard with the least work so far. `seconds` contains the
/// times of an earlier run, keyed by name; an entry without such a time is assumed to take their mean.
std::vector<std::size_t> entries_of_shard(const Suite& suite, int index, int count,
                                          const std::map<std::string, double>& seconds);

}  // namespace viewing
