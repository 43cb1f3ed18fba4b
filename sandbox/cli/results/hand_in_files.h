// Which files of the arguments of grade are hand-ins, and what lies beside them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace viewing {

/// In the order in which a sentence names them.
enum class WhySkipped { not_json, link, hidden, no_file };
/// As it stands behind a number: "not JSON", "a link".
const char* name_of(WhySkipped why);

struct HandInFiles {
    std::vector<std::filesystem::path> files;  ///< arguments in their order, what is in a folder sorted by its path
    std::vector<std::pair<std::filesystem::path, WhySkipped>> skipped;
    std::vector<std::string> troubles;  ///< a sentence for each folder that cannot be looked into or has nothing
    bool has_folders = false;
};

/// An argument that is a file is taken whatever its name; of a folder, and of the folders in it, all that end in .json,
/// in letters of either case. Links in a folder are not followed, so that it ends; what begins with a point is hidden.
HandInFiles hand_in_files(const std::vector<std::string>& arguments);

}  // namespace viewing
