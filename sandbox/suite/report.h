// What a run leaves to look at: report.json, junit.xml and index.html with its pictures, in one folder that can be
// moved and opened from disk. Also how shards' folders become one, and how what was looked at becomes the reference.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "suite/results.h"

namespace viewing {

/// The folders for what is left, made where they are missing. The error: they cannot be made or written, or the
/// report's holds what is no report.
Status prepare_report(const Suite& suite);

/// report.json, junit.xml and index.html.
Status write_report(const std::filesystem::path& folder, const RunResult& run);

/// The texts of the two.
std::string junit_of(const RunResult& run);
std::string report_page(const RunResult& run);

/// References that no entry has.
std::vector<std::string> stray_references(const Suite& suite);

/// The shards' reports as the suite's own, with their pictures. Entries that none of them has are failed ones; one that
/// two have, or that the suite does not have, is an error, as are shards of several splits.
Result<RunResult> merge_reports(const Suite& suite, const std::vector<std::filesystem::path>& folders);

/// What the last run drew and computed becomes the reference: of the entries with these names, or of all that are
/// different; the report then says so. How many. The error: no such name, no run, nothing drawn of it.
Result<std::size_t> accept_results(const Suite& suite, const std::vector<std::string>& names);

}  // namespace viewing
