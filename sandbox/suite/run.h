// A suite run: its entries handed to workers, each a process of its own, and their results gathered. What crashes or
// takes too long fails alone; the others go on with a new worker. While there is an EndingNote, a signal ends the run
// early: workers are ended, and what they have not finished is not drawn.
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
    std::map<std::string, std::string> known_keys;  ///< by name, of results that passed
    int jobs = 1;
    double entry_timeout_s = 60.0;
    /// Called whenever an entry is done, with how many are.
    std::function<void(const EntryResult&, std::size_t)> tell = {};
};

/// Why there is no result at all: no worker could begin.
struct NoWorker {
    int exit_status = 9;
    std::string complaint;
};

/// Entries in the order of `chosen`. Either entries or failure has something.
struct GatheredResults {
    std::vector<EntryResult> entries;
    int ended_by = 0;  ///< the signal that ended the run early
    std::string renderer;
    std::optional<NoWorker> failure;
};
GatheredResults run_entries(const Suite& suite, const RunWish& wish);

/// Which entries shard `index` of `count` (from 1 on) has: the longest first, each to the shard with the least to do;
/// equal ones by their place. `seconds` by name, of an earlier run; one that is not known takes as long as the mean.
std::vector<std::size_t> entries_of_shard(const Suite& suite, int index, int count,
                                          const std::map<std::string, double>& seconds);

}  // namespace viewing
