// The result of a suite's run: the outcome of each entry with the facts for the report. Also converts it to JSON and
// back.
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
    different,  ///< differs from the reference
    fresh,      ///< there was no reference: the new result is now the reference
    failed,     ///< it could not be drawn or judged
    not_drawn   ///< the run ended before this entry
};
inline constexpr int outcome_count = 5;
const char* name_of(Outcome outcome);  ///< "new" for fresh

struct EntryResult {
    std::string name, file_name;
    std::string about;  ///< the suite's description of the entry
    Outcome outcome = Outcome::failed;
    bool is_kept = false;              ///< the result is from an earlier run, since nothing has changed
    std::vector<std::string> reasons;  ///< a sentence for each failed check
    double seconds = 0.0;
    std::string key;     ///< a hash of everything that determines the result; "" if not requested
    std::string output;  ///< messages from the program and the driver during this entry
    Json details;        ///< for the report: "compare", "numbers", "state", "problems", if present
};

/// Returns an initial result, which counts as failed, with the entry's name, files and description.
EntryResult result_for(const SuiteEntry& entry);

struct RunResult {
    std::string suite, argument, version, renderer;
    int shard = 1, of = 1;
    double seconds = 0.0;
    std::vector<EntryResult> entries;  ///< in the order of the suite

    std::size_t count(Outcome outcome) const;
    /// Whether every entry passed. New entries count as passed if `accepts_new` is set.
    bool is_good(bool accepts_new) const;
};

/// Returns the reasons, one per line.
std::string reasons_in_lines(const EntryResult& entry);

Json as_json(const EntryResult& entry);
Json as_json(const RunResult& run);

/// Reads the result of an entry. Throws Refusal if it is invalid.
EntryResult read_entry_result(const Json& value, const Where& where);

/// Reads report.json in a report's folder. Fails if the file is missing, or if it is not a report of this program.
Result<RunResult> read_run(const std::filesystem::path& folder);

/// Returns, for example, "212 entries: 209 passed, 2 different, 1 new; 12.3 s".
std::string summary_of(const RunResult& run);

/// The files of an entry in the folder of a report.
struct EntryFiles {
    std::filesystem::path actual, expected, difference, script, state, numbers;
};
EntryFiles files_of(const std::filesystem::path& report, const std::string& file_name);

/// Return the reference files of an entry.
std::filesystem::path reference_picture(const Suite& suite, const SuiteEntry& entry);
std::filesystem::path reference_numbers(const Suite& suite, const SuiteEntry& entry);

}  // namespace viewing
