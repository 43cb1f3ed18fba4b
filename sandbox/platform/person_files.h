// Files and the person: on a desktop they lie where they were written. A browser has a folder of its own that nobody
// sees: what is to be read is asked for with the browser's dialog, what was written is handed over.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace viewing {

/// Asks for a file with a dialog of the surroundings. False: they have none, and the program asks by itself.
bool ask_for_file();

/// The one that was chosen since then, once.
std::optional<std::filesystem::path> chosen_file();

/// Gives a file that has been written to the person.
void hand_over(const std::filesystem::path& written);

/// Whether writing a file can replace one of the person's: what is handed over never does.
bool can_replace_files();

/// What a written file is called in a sentence: its path, or its name where the folder is the program's own.
std::string place_for_person(const std::filesystem::path& written);

}  // namespace viewing
