// Reads a whole text file into memory, with error messages for files that cannot be read.
#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>

#include "text/result.h"

namespace viewing {

/// The maximum size of a text file or of standard input.
inline constexpr std::size_t max_document_bytes = 16U << 20U;

/// Reads a file. The error names the file and says that it is missing, a directory, unreadable, or longer than
/// `most_bytes`.
Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most_bytes = max_document_bytes);

/// Reads the rest of a stream, such as standard input. The error begins with `name`.
Result<std::string> read_text(std::istream& stream, const std::string& name,
                              std::size_t most_bytes = max_document_bytes);

/// Returns, for example, "longer than 16 MiB".
std::string longer_than(std::size_t bytes);

}  // namespace viewing
