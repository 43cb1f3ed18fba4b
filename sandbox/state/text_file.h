// Internal to state/: a whole text file in memory, with the messages for what cannot be read.
#pragma once

#include <filesystem>
#include <istream>
#include <string>

#include "geometry/result.h"

namespace viewing {

/// At most 16 MiB. The error names the file: missing, a directory, unreadable, too large.
Result<std::string> read_text_file(const std::filesystem::path& file);

/// The rest of a stream, such as standard input, with the same limit; `name` opens the message.
Result<std::string> read_text(std::istream& stream, const std::string& name);

}  // namespace viewing
