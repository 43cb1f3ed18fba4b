// Where results go: standard output, or a file named on the command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace viewing {

/// Writes to standard output and flushes. Throws Failure when that is impossible (a full disk).
void print(std::string_view text);

/// Writes to standard output for "-", else into the file, whole or not at all (file.h). Throws Failure.
void write_output(const std::string& target, std::span<const std::uint8_t> bytes);
void write_output(const std::string& target, std::string_view text);

/// Throws Failure when it is clear beforehand that the file cannot be written: its folder is missing or read-only, or
/// it is a folder itself. "-" is always fine.
void check_output(const std::string& target);

/// Whether the file is put in place by renaming: not standard output, a pipe or a device, which may keep the writer
/// waiting.
bool is_plain_file(const std::string& target);

}  // namespace viewing
