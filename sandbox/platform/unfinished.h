// Registers files and folders that are written next to their target and then get the target's name, so that a signal
// handler can remove them when it ends the process. file.h and whole_folder.h write in this way.
#pragma once

#include <filesystem>

#include "text/result.h"

namespace viewing {

/// Register `beside`, a file or a folder, and end its registration. In between, remove_unfinished_files() (file.h)
/// removes it with its contents, and the string in `beside` must not move.
void note_unfinished(const std::filesystem::path& beside);
void forget_unfinished(const std::filesystem::path& beside);

/// Exchanges the names of two files or folders. Returns false if that fails, as on a file system without support.
bool exchange_names(const std::filesystem::path& a, const std::filesystem::path& b);

/// Returns the folder part of a name; "." if there is none.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// Flushes the entries of a folder to the disk.
void keep_folder(const std::filesystem::path& folder);

/// Returns the error for an errno, for example "frames: cannot be written: No space left on device".
Error write_error(const std::filesystem::path& path, int code);

}  // namespace viewing
