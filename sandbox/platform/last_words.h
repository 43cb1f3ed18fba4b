// Writes a final text when a signal ends the process. All memory is allocated in advance.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace viewing {

/// Sets the file, and one text for each exit status; say_last_words() writes one of these texts to the file. If it is a
/// plain file, existing or new, it gets the whole text or nothing; a pipe or device gets as much as can be written
/// without blocking. "-" is standard output. Replaces earlier texts.
void set_last_words(const std::filesystem::path& file, std::vector<std::pair<int, std::string>> text_by_status);

void forget_last_words();

/// Writes the text for this status. Calls only functions that a signal handler may call. Writes nothing if there is no
/// text for the status, or if the text cannot be written.
void say_last_words(int status) noexcept;

}  // namespace viewing
