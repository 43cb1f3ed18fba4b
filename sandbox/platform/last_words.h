// Writes a final text when a signal ends the process. All memory is allocated in advance.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace viewing {

/// Sets the texts, by exit status, of which say_last_words() writes one to the file. It writes the whole text or
/// nothing if the file is or will be a plain file, otherwise as much as possible without blocking. "-" is standard
/// output. Replaces earlier texts.
void set_last_words(const std::filesystem::path& file, std::vector<std::pair<int, std::string>> text_by_status);

void forget_last_words();

/// Calls only functions that a signal handler may call. Writes nothing if no text is set for this status or it cannot
/// be written.
void say_last_words(int status) noexcept;

}  // namespace viewing
