// Writing a whole file so that nobody ever finds half of it, and what is asked of a file before it is read. Every file
// that is written goes through here.
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

/// Puts `bytes` into `path`: first into a new file beside it (.viewing-sandbox-….partial), which is on the disk before
/// it takes its name, so that a failure leaves what was there before. The mode of what was there is kept. A link is
/// followed, to a file that is not there yet as well; a device or pipe (/dev/null) is written into, never replaced. The
/// sentence of a failure names the path and the system's reason.
Status write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// The same of a text.
Status write_file(const std::filesystem::path& path, std::string_view text);

/// The files of a folder whose names end so (".json"), sorted; none where it cannot be read.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder, std::string_view extension);

/// All of a file, however large; "" where it cannot be read.
std::string all_bytes(const std::filesystem::path& file);

struct FileBytes {
    std::filesystem::path path;
    std::span<const std::uint8_t> bytes;
};

/// All of them or none: each is complete before the first one takes its name, and where one cannot take it those before
/// it give theirs back (on a file system that cannot exchange names, only what is new). `before_names` runs in between;
/// where it throws, none does.
Status write_files(std::span<const FileBytes> files, const std::function<void()>& before_names = {});

/// The bytes of one file into another, as write_file.
Status copy_bytes(const std::filesystem::path& from, const std::filesystem::path& to);

/// Removes what still waits for its name. For who ends the process at once, also from within a signal.
void remove_unfinished_files();

/// Where a chain of links ends, be there a file or not; none for one that goes round.
std::optional<std::filesystem::path> end_of_links(std::filesystem::path path);

/// A name beside a file that nobody can know before, for what grows until it takes that file's name. It is not longer
/// for a longer one, which may be as long as the file system allows.
std::filesystem::path name_beside(const std::filesystem::path& file);

/// The files of a folder that have such names: what a program that was ended while it wrote has left.
std::vector<std::filesystem::path> unfinished_files_in(const std::filesystem::path& folder);

/// Whether there is such a file or folder; one that cannot be looked at is not.
bool is_there(const std::filesystem::path& file);

/// Whether two names are those of one file or folder, through links of both kinds, "." and ".."; of files that are not
/// there yet, whether they would be one. Never so for devices and pipes, which keep nothing.
bool are_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether a file is there that can be read without waiting for anybody: a pipe is refused, and what the kernel makes
/// up while it is read. The sentence names it and says why it cannot be: missing, a directory, or what the system says.
Status check_readable(const std::filesystem::path& file);

}  // namespace viewing
