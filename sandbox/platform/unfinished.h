// What grows beside its target until it takes its name: for who writes such a thing, and for who ends the process from
// within a signal. Read file.h and whole_folder.h for what is written so.
#pragma once

#include <filesystem>

#include "text/result.h"

namespace viewing {

/// From the one to the other remove_unfinished_files() (file.h) removes `beside`, a file or a folder with all that is
/// in it. Its text must stay where it is meanwhile.
void note_unfinished(const std::filesystem::path& beside);
void forget_unfinished(const std::filesystem::path& beside);

/// Two names change places. False: not on this file system.
bool exchange_names(const std::filesystem::path& a, const std::filesystem::path& b);

/// The folder that a name stands in; "." where the name says none.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// Brings a folder's names onto the disk.
void keep_folder(const std::filesystem::path& folder);

/// "frames: cannot be written: No space left on device", from an errno.
Error write_error(const std::filesystem::path& path, int code);

}  // namespace viewing
