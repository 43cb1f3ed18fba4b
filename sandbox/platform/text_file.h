// A whole text file in memory, with the messages for what cannot be read.
#pragma once

#include <filesystem>
#include <istream>
#include <string>

#include "text/result.h"

namespace viewing {

/// What a text file or standard input may hold at most.
inline constexpr std::size_t max_document_bytes = 16U << 20U;

/// At most 16 MiB. The error names the file: missing, a directory, unreadable, too large.
Result<std::string> read_text_file(const std::filesystem::path& file);

/// The rest of a stream, such as standard input, with the same limit; `name` opens the message.
Result<std::string> read_text(std::istream& stream, const std::string& name);

}  // namespace viewing
