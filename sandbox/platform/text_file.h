// A whole text file in memory, with the messages for what cannot be read.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>

#include "text/result.h"

namespace viewing {

/// What a text file or standard input may hold at most.
inline constexpr std::size_t max_document_bytes = 16U << 20U;

/// The error names the file: missing, a directory, unreadable, longer than `most_bytes`.
Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most_bytes = max_document_bytes);

/// The rest of a stream, such as standard input; `name` opens the message.
Result<std::string> read_text(std::istream& stream, const std::string& name,
                              std::size_t most_bytes = max_document_bytes);

/// "longer than 16 MiB"
std::string longer_than(std::size_t bytes);

}  // namespace viewing
