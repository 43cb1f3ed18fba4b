// Implements --json for the commands that compare pictures: writes a report however the command ends.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/output.h"
#include "state/file/document.h"

namespace viewing {

/// The files that a command line names.
struct NamedFiles {
    std::vector<FileArgument> outputs, inputs;
};

/// The help text of --json.
inline constexpr const char* ending_report_help =
    "Writes a JSON report however the command ends: status with its meaning and sentence, duration_s, version, the "
    "names given and the results so far; - for standard output. After a driver crash duration_s is null. There is no "
    "report if FILE cannot be written, is also an input or another output, or the process is killed";

class EndingReport {
public:
    /// Starts the clock. `target` holds the value of --json once the options have been parsed; if it is empty, there is
    /// no report. `files` is called whenever the names are needed.
    EndingReport(const Command& command, const Options& options, const std::optional<std::string>& target,
                 std::function<NamedFiles()> files);
    ~EndingReport();
    EndingReport(const EndingReport&) = delete;
    EndingReport& operator=(const EndingReport&) = delete;

    /// Runs `work` and returns its result. If `work` throws, writes the failure into the report and rethrows it.
    ExitStatus guard(const std::function<ExitStatus()>& work);

    /// Checks all files (check_outputs); from then on, an expired --timeout or a fault also leaves a report.
    void begin();
    /// Adds a fact at the end of the report, or replaces the earlier fact with the same name.
    void tell(const char* name, Json value);
    /// Writes the results and the report together: all of them or none.
    void finish(Outputs& results, ExitStatus status, const std::string& sentence);

private:
    /// Returns the report as JSON; `duration_s` is null if it is unknown.
    std::string text(ExitStatus status, const std::string& sentence, std::optional<double> duration_s) const;
    double seconds_so_far() const;
    void prepare_last_words() const;
    /// Writes the report of a failure that has not been reported yet; never throws.
    void write_failure(ExitStatus status, const std::string& sentence);

    const Command& command_;
    const Options& options_;
    const std::optional<std::string>& target_;
    const std::function<NamedFiles()> files_;
    const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
    Json facts_ = Json::object();
    bool is_watching_ = false, is_written_ = false;
};

/// Returns a name as typed; null if it was left out.
Json name_as_json(const std::optional<std::string>& name);

}  // namespace viewing
