// How a suite's run ended: each entry's outcome, with what a report shows of it; as JSON and back.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "state/file/document.h"
#include "suite/suite.h"

namespace viewing {

enum class Outcome {
    passed,
    different,  ///< from what was accepted
    fresh,      ///< there was nothing yet: what was drawn now is the reference
    failed,     ///< it could not be drawn or judged
    not_drawn   ///< the run ended before
};
inline constexpr int outcome_count = 5;
const char* name_of(Outcome outcome);  ///< "new" for a fresh one

struct EntryResult {
    std::string name, file_name;
    std::string about;  ///< the suite's words about the entry
    Outcome outcome = Outcome::failed;
    bool is_kept = false;              ///< the result of an earlier run, since nothing has changed
    std::vector<std::string> reasons;  ///< a sentence for each thing that is not as it should be
    double seconds = 0.0;
    std::string key;     ///< of all that decides the result; "" when it was not asked for
    std::string output;  ///< what the program and the driver complained of meanwhile
    Json details;        ///< for the report: "compare", "numbers", "state", "problems"; what there is
};

/// A failed one, until somebody knows better, with the entry's name, files and words.
EntryResult result_for(const SuiteEntry& entry);

struct RunResult {
    std::string suite, argument, version, renderer;
    int shard = 1, of = 1;
    double seconds = 0.0;
    std::vector<EntryResult> entries;  ///< in the suite's order

    std::size_t count(Outcome outcome) const;
    /// Whether nothing is left to look at.
    bool is_good(bool accepts_new) const;
};

/// A line for each reason.
std::string reasons_in_lines(const EntryResult& entry);

Json as_json(const EntryResult& entry);
Json as_json(const RunResult& run);

/// Throws Refusal.
EntryResult read_entry_result(const Json& value, const Where& where);

/// report.json of a report's folder. The error: there is none, or it is none of ours.
Result<RunResult> read_run(const std::filesystem::path& folder);

/// "212 entries: 209 passed, 2 different, 1 new; 12.3 s"
std::string summary_of(const RunResult& run);

/// The files of an entry in a report's folder.
struct EntryFiles {
    std::filesystem::path actual, expected, difference, script, state, numbers;
};
EntryFiles files_of(const std::filesystem::path& report, const std::string& file_name);

/// The references of an entry.
std::filesystem::path reference_picture(const Suite& suite, const SuiteEntry& entry);
std::filesystem::path reference_numbers(const Suite& suite, const SuiteEntry& entry);

}  // namespace viewing
