// Which files a state may name: a state may come from anybody, and a name in it is no wish of the person's.
#pragma once

#include <filesystem>
#include <vector>

namespace viewing {

/// An absolute path with its links followed, as far as there is something.
std::filesystem::path resolved(const std::filesystem::path& path);

/// Files and folders with all below them, where their links lead. The assets are always within reach.
struct FileReach {
    bool is_everywhere = true;
    std::vector<std::filesystem::path> places;  ///< resolved

    void add(const std::filesystem::path& place) { places.push_back(resolved(place)); }
    void add(const FileReach& other);
    bool includes(const std::filesystem::path& file) const;
};

/// A folder and nothing else; empty: the working directory.
FileReach reach_of_folder(const std::filesystem::path& folder);

}  // namespace viewing
