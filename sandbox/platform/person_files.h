// Moves files between the program and the user. On a desktop, files stay in the folder where they were written. In a
// browser, the program's folder is invisible: the user chooses files to read in the browser's dialog, and the page
// delivers written files to the user.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace viewing {

/// Asks for a file with the system's dialog. Returns false if the system has none, in which case the program has to ask
/// the user itself.
bool ask_for_file();

/// Returns the file that the user has chosen in the dialog, but only once.
std::optional<std::filesystem::path> chosen_file();

/// Delivers a written file to the user.
void hand_over(const std::filesystem::path& written);

/// Whether writing a file can replace one of the user's files; delivering a file never does.
bool can_replace_files();

/// Returns the name by which a sentence refers to a written file: its path, or only its file name if the folder is
/// internal to the program.
std::string place_for_person(const std::filesystem::path& written);

}  // namespace viewing
