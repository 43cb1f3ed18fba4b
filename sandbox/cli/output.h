// Destinations of results: standard output, or a file named on the command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.h"
#include "platform/whole_folder.h"

namespace viewing {

/// Writes to standard output and flushes. Throws Failure if that fails, for example on a full disk.
void print(std::string_view text);

/// Keeps a line about the input for print_notes(), but not the same line twice. The line is not printed yet, because a
/// command that fails prints only its one sentence.
void note(const std::string& line);
/// Writes the kept lines to standard error, in the order in which they were added.
void print_notes();

/// The results of one command, which are written together: all files or none (file.h), and none if writing to standard
/// output ("-") fails.
class Outputs {
public:
    void add(const std::string& target, std::vector<std::uint8_t> bytes);
    void add(const std::string& target, std::string_view text);
    void add(WholeFolder folder);
    /// Writes the results. Throws Failure if that fails.
    void write();

private:
    struct Output {
        std::string target;
        std::vector<std::uint8_t> bytes;
    };
    std::vector<Output> outputs_;
    std::optional<WholeFolder> folder_;
};

/// Throws Failure if the file clearly cannot be written: its folder is missing or read-only, or it is a folder itself.
/// "-" is always fine.
void check_output(const std::string& target);

/// A file as named on the command line, and the option that names it: {"--json", "report.json"}.
struct FileArgument {
    std::string option, file;
};

/// Adds an argument if it names a file, as opposed to something that comes with the program.
void add_file_if_there(std::vector<FileArgument>& files, const char* option, const std::string& argument);

/// Refuses an output that is the same file as an input or another output, whatever their names (are_same_file). Only
/// one output can be "-", standard output; an input "-" is standard input.
void check_apart(const Options& options, std::span<const FileArgument> outputs, std::span<const FileArgument> inputs);

/// Calls check_apart(), and then check_output() for each output.
void check_outputs(const Options& options, std::span<const FileArgument> outputs,
                   std::span<const FileArgument> inputs = {});

/// Whether the file is put in place by renaming. False for standard output, a pipe or a device, which may block the
/// writer.
bool is_plain_file(const std::string& target);

}  // namespace viewing
