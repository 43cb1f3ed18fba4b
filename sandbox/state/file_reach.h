// The files that a state may read. A state may come from anyone, so a file name in it is not a request by the user.
#pragma once

#include <filesystem>
#include <vector>

namespace viewing {

/// Returns the absolute path, following links as far as the path exists.
std::filesystem::path resolved(const std::filesystem::path& path);

/// A set of files, and of folders with everything below them. Links are resolved before a file is compared with the
/// set. The assets are always within reach.
struct FileReach {
    bool is_everywhere = true;
    std::vector<std::filesystem::path> places;  ///< resolved

    void add(const std::filesystem::path& place) { places.push_back(resolved(place)); }
    void add(const FileReach& other);
    bool includes(const std::filesystem::path& file) const;
};

/// Returns the reach of one folder alone; an empty path means the working directory.
FileReach reach_of_folder(const std::filesystem::path& folder);

}  // namespace viewing
