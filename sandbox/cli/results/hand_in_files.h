// The hand-ins that grade's arguments name, and the files that were skipped.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace viewing {

/// The reasons for skipping a file, in the order in which the summary lists them.
enum class WhySkipped { not_json, link, hidden, no_file };
/// Returns the words that follow a count: "not JSON", "a link".
const char* name_of(WhySkipped why);

struct HandInFiles {
    std::vector<std::filesystem::path> files;  ///< in the order of the arguments; sorted by path within a folder
    std::vector<std::pair<std::filesystem::path, WhySkipped>> skipped;
    std::vector<std::string> troubles;  ///< a sentence for each folder that cannot be read or has no hand-in
    bool has_folders = false;
};

/// Finds the hand-ins. Accepts a file argument whatever its name is. Searches folders and their subfolders for .json
/// files (in upper or lower case). Does not follow links inside a folder, so that the search always ends. Names that
/// begin with a dot count as hidden. Takes a file once, even if several arguments name it.
HandInFiles hand_in_files(const std::vector<std::string>& arguments);

}  // namespace viewing
