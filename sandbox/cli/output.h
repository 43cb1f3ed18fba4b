// Where results go: standard output, or a file named on the command line.
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

/// Writes to standard output and flushes. Throws Failure when that is impossible (a full disk).
void print(std::string_view text);

/// Keeps a line about the input, once, for print_notes(): a command that fails says its one sentence alone.
void note(const std::string& line);
/// Writes the lines to standard error, in the order in which they came.
void print_notes();

/// The results of one command, written together: all files or none (file.h), and none unless standard output ("-") took
/// its part.
class Outputs {
public:
    void add(const std::string& target, std::vector<std::uint8_t> bytes);
    void add(const std::string& target, std::string_view text);
    void add(WholeFolder folder);
    /// Throws Failure.
    void write();

private:
    struct Output {
        std::string target;
        std::vector<std::uint8_t> bytes;
    };
    std::vector<Output> outputs_;
    std::optional<WholeFolder> folder_;
};

/// Throws Failure when it is clear beforehand that the file cannot be written: its folder is missing or read-only, or
/// it is a folder itself. "-" is always fine.
void check_output(const std::string& target);

/// A file as the command line has it, and what named it: {"--json", "report.json"}.
struct FileArgument {
    std::string option, file;
};

/// An argument that may be a file, or the name of something that comes with the program: added where it is a file.
void add_file_if_there(std::vector<FileArgument>& files, const char* option, const std::string& argument);

/// Refuses an output that is an input or another output as well, whatever names it (are_same_file). "-" is standard
/// output, which only one of them can have, and of inputs standard input.
void check_apart(const Options& options, std::span<const FileArgument> outputs, std::span<const FileArgument> inputs);

/// The same, and check_output() of each output.
void check_outputs(const Options& options, std::span<const FileArgument> outputs,
                   std::span<const FileArgument> inputs = {});

/// Whether the file is put in place by renaming: not standard output, a pipe or a device, which may keep the writer
/// waiting.
bool is_plain_file(const std::string& target);

}  // namespace viewing
