// Names for files that nobody chose.
#pragma once

#include <filesystem>
#include <string>

namespace viewing {

/// A file in the working folder that is not there yet: "flight.json", and where that is taken "flight-2.json",
/// "flight-3.json" …
std::filesystem::path free_file(const std::string& stem, const std::string& extension);

}  // namespace viewing
