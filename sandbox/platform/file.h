// Writes files completely, so that no half-written file is ever visible, and checks files before they are read. The
// program writes its files with these functions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/result.h"

namespace viewing {

/// Writes `bytes` to a new file next to `path` (.viewing-sandbox-….partial), flushes it to the disk, and only then
/// gives it the name `path`, so that a failure leaves the previous file intact. Keeps the previous file's mode. Follows
/// links, even to a file that does not exist yet. Writes into a device or pipe (/dev/null) and never replaces it. The
/// error names the path and the system's reason.
Status write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Does the same for a string.
Status write_file(const std::filesystem::path& path, std::string_view text);

/// Returns the files in a folder with this extension (".json"), sorted; none if the folder cannot be read.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view extension);

/// Returns the whole content of a file, however large; "" if it cannot be read.
std::string all_bytes(const std::filesystem::path& file);

struct FileBytes {
    std::filesystem::path path;
    std::span<const std::uint8_t> bytes;
};

/// Writes all files or none. First writes every file completely under a temporary name (a device or pipe directly),
/// then calls `before_names`, then gives the files their names. If `before_names` throws, no file gets its name. If a
/// file cannot get its name, the earlier ones are undone; on a file system that cannot exchange names, a file that has
/// already been replaced stays replaced.
Status write_files(std::span<const FileBytes> files, const std::function<void()>& before_names = {});

/// Copies the content of one file to another in the same way as write_file().
Status copy_bytes(const std::filesystem::path& from, const std::filesystem::path& to);

/// Removes all unfinished files. Meant for code that ends the process immediately, including signal handlers.
void remove_unfinished_files();

/// Returns the file at the end of a chain of links, whether or not it exists; nothing for a circular chain.
std::optional<std::filesystem::path> end_of_links(std::filesystem::path path);

/// Returns an unpredictable name in the file's folder, for data that get the file's own name once they are complete.
/// Its length does not depend on the file's name, which may be as long as the file system allows.
std::filesystem::path name_beside(const std::filesystem::path& file);

/// Returns the files in a folder whose names are from name_beside(). A program that ended while writing left them
/// behind.
std::vector<std::filesystem::path> unfinished_files_in(const std::filesystem::path& folder);

/// Whether a file or folder with this name exists; false if that cannot be determined.
bool is_there(const std::filesystem::path& file);

/// Whether two names refer to the same file or folder, even if one name reaches it through hard or symbolic links, "."
/// or "..". For files that do not exist yet, whether they would be the same. Always false for devices and pipes, which
/// store nothing.
bool are_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Checks that a file exists and can be read without blocking: refuses a pipe, and files that the kernel generates
/// while they are read. The error names the file and says why it cannot be read: missing, a directory, or the system's
/// reason.
Status check_readable(const std::filesystem::path& file);

}  // namespace viewing
