// Moves files between the program and the person. On a desktop, files stay in the folder where they were written. In a
// browser, the program's folder is invisible: the person chooses files to read in the browser's dialog, and the page
// delivers written files to the person.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace viewing {

/// Asks for a file with the system's dialog. Returns false if the system has none, in which case the program has to ask
/// the person itself.
bool ask_for_file();

/// Returns the file that the person has chosen in the dialog, but only once.
std::optional<std::filesystem::path> chosen_file();

/// Delivers a written file to the person.
void hand_over(const std::filesystem::path& written);

/// Whether writing a file can replace one of the person's files; delivering a file never does.
bool can_replace_files();

/// Returns the name to use for a written file in a sentence: its path, or only its name if the folder is internal to
/// the program.
std::string place_for_person(const std::filesystem::path& written);

}  // namespace viewing
