// Where results go: standard output, or a file named on the command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

/// Writes to standard output and flushes. Throws Failure when that is impossible (a full disk).
void print(std::string_view text);

/// The results of one command, written together: what goes to standard output ("-"), then all files or none (file.h).
class Outputs {
public:
    void add(const std::string& target, std::vector<std::uint8_t> bytes);
    void add(const std::string& target, std::string_view text);
    /// Throws Failure.
    void write() const;

private:
    struct Output {
        std::string target;
        std::vector<std::uint8_t> bytes;
    };
    std::vector<Output> outputs_;
};

/// Throws Failure when it is clear beforehand that the file cannot be written: its folder is missing or read-only, or
/// it is a folder itself. "-" is always fine.
void check_output(const std::string& target);

/// Whether the file is put in place by renaming: not standard output, a pipe or a device, which may keep the writer
/// waiting.
bool is_plain_file(const std::string& target);

}  // namespace viewing
