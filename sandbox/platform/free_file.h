// Chooses a name for a file that the user did not name.
#pragma once

#include <filesystem>
#include <string>

namespace viewing {

/// Returns a file in the working directory that does not exist yet: "flight.json", or, if that exists, "flight-2.json",
/// "flight-3.json" …
std::filesystem::path free_file(const std::string& stem, const std::string& extension);

}  // namespace viewing
