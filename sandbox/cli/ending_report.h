// --json of the commands that compare: a report that is written however the command ends.
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

/// What --help says of --json.
inline constexpr const char* ending_report_help =
    "Writes a report as JSON, however the command ends: status, its meaning and the sentence, duration_s, version, "
    "what "
    "was named, and what was found so far; - for standard output. After a fault of the driver duration_s is null. "
    "There is none where FILE cannot be written, is an "
    "input or another output, or where the process is killed";

class EndingReport {
public:
    /// The clock starts. `target` is what --json says, once options are parsed: none, no report. `files` are asked for
    /// when they are wanted.
    EndingReport(const Command& command, const Options& options, const std::optional<std::string>& target,
                 std::function<NamedFiles()> files);
    ~EndingReport();
    EndingReport(const EndingReport&) = delete;
    EndingReport& operator=(const EndingReport&) = delete;

    /// What `work` returns. What it throws is written into the report, and thrown on.
    ExitStatus guard(const std::function<ExitStatus()>& work);

    /// Checks all files (check_outputs); from then on --timeout and faults leave a report too.
    void begin();
    /// What the report has beside the ending, in this order; what was told by the same name before is replaced.
    void tell(const char* name, Json value);
    /// Writes the results and with them the report, all or none.
    void finish(Outputs& results, ExitStatus status, const std::string& sentence);

private:
    /// No duration: nobody knows it.
    std::string text(ExitStatus status, const std::string& sentence, std::optional<double> duration_s) const;
    double seconds_so_far() const;
    void prepare_last_words() const;
    /// For an ending that nothing else tells of; never throws.
    void write_failure(ExitStatus status, const std::string& sentence);

    const Command& command_;
    const Options& options_;
    const std::optional<std::string>& target_;
    const std::function<NamedFiles()> files_;
    const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
    Json facts_ = Json::object();
    bool is_watching_ = false, is_written_ = false;
};

/// A name that was typed; null where it was left out.
Json name_as_json(const std::optional<std::string>& name);

}  // namespace viewing
