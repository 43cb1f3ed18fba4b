// A text that is still written where a signal ends the process. Everything that asks for memory is done beforehand.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace viewing {

/// From now on say_last_words() puts one of these texts, by exit status, into the file: whole or not at all where it is
/// or will be a plain one, else as far as nobody has to be waited for. "-" is standard output. In place of those
/// before.
void set_last_words(const std::filesystem::path& file, std::vector<std::pair<int, std::string>> text_by_status);

void forget_last_words();

/// Only what a signal's handler may do. Nothing where no text is set for this status, or it cannot be written.
void say_last_words(int status) noexcept;

}  // namespace viewing
