// The report of a run: report.json, junit.xml and index.html with its pictures, in one folder that can be moved and
// opened from disk. Also merges the reports of shards, and accepts results as new references.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "suite/results.h"

namespace viewing {

/// Creates missing folders. Fails if they cannot be created or written, or if the report's folder contains anything
/// other than a report.
Status prepare_report(const Suite& suite);

/// Writes report.json, junit.xml and index.html.
Status write_report(const std::filesystem::path& folder, const RunResult& run);

/// Return the texts of junit.xml and index.html.
std::string junit_of(const RunResult& run);
std::string report_page(const RunResult& run);

/// Returns references that belong to no entry.
std::vector<std::string> stray_references(const Suite& suite);

/// Merges the shards' reports into the suite's own, with their pictures. Entries that are in no shard count as failed.
/// It is an error if an entry is in two shards, if it is not in the suite, or if the shards belong to different splits.
Result<RunResult> merge_reports(const Suite& suite, const std::vector<std::filesystem::path>& folders);

/// Reads the report of the suite's last run. Fails like read_run(), and if it is the report of another suite that uses
/// the same folder.
Result<RunResult> last_run(const Suite& suite);

/// Completes a run of some entries with the report's results of the others, in the suite's order. Entries without a
/// result are left out.
RunResult with_earlier_results(RunResult run, const Suite& suite);

/// Makes the results of the last run the new references, for the entries with these names or, without names, for all
/// that are different, and updates the report. Returns the number of entries accepted. Fails if a name is unknown, if
/// there was no run, if nothing was drawn, or if a named entry fails although its result equals its
/// reference.
Result<std::size_t> accept_results(const Suite& suite, const std::vector<std::string>& names);

}  // namespace viewing
